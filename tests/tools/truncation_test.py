"""Group A: files that end too early, cut at each 32nd of the file, at each section and beside it; in a soak at each byte."""

import unittest

from encoded_meshes import ENCODINGS, content, encoded, extension, small_mesh, written_base
from faults import ALL_FACES, FORMAT, PLACE, FaultTest
from soak import soak

PARTS = 32
CUTS_OF_A_SOAK = 100


def cuts(whole):
    """Where to cut: nearly everywhere in a soak."""
    size = len(whole.data)
    beside = {edge + step for edge in whole.edges for step in (-1, 0, 1)}
    step = max(1, size * (CUTS_OF_A_SOAK - soak(CUTS_OF_A_SOAK)) // (CUTS_OF_A_SOAK * PARTS))
    spread = set(range(0, size, step))
    return sorted(cut for cut in beside | spread if 0 <= cut < size)


def obj_content(data):
    """The mesh of an OBJ file that was cut, or None where a line with a number cannot be read."""
    points, faces = [], []
    for line in data.decode("ascii").split("\n"):
        keyword, *words = line.split() or [""]
        try:
            if keyword == "v":
                points.append(tuple(float(words[i]) for i in range(3)))
            elif keyword == "f":
                faces.append(tuple(int(word) - 1 for word in words))
        except (IndexError, ValueError):
            return None
    return points, faces


def corners(mesh):
    """The positions of the corners of each face. A base mesh has no vertices that no face names."""
    points, faces = mesh
    return [[points[corner] for corner in face] for face in faces]


class Truncation(FaultTest):
    group = "A truncation"

    def cut_everywhere(self, name, expect):
        whole = encoded(name, small_mesh())
        file = f"cut.{extension(name)}"
        if not file.endswith(FORMAT):
            return
        for cut in cuts(whole):
            with self.case(encoding=name, cut=cut):
                expect(file, whole.data[:cut])

    def expect_unreadable(self, file, data):
        (self.folder / file).write_bytes(data)
        run = self.simplify(file, "--faces", ALL_FACES)
        self.expect_reason(run, 3, file, PLACE if data else r"\Athe file is empty\Z")
        self.expect_old_outputs(file)
        self.expect_modest(run, len(data))

    def expect_unreadable_but_for_the_last_line_end(self, file, data):
        name = {"ply": "ply ascii", "off": "off"}[file.split(".")[1]]
        whole = encoded(name, small_mesh()).data
        if data == whole[:-1]:
            self.expect_accepted(file, data, content(name, small_mesh()))
        else:
            self.expect_unreadable(file, data)

    def expect_what_obj_has(self, file, data):
        """OBJ announces no counts, so that a cut between lines or digits leaves a shorter file, of a shorter mesh."""
        left = obj_content(data)
        if not data or left is None:
            self.expect_unreadable(file, data)
            return
        (self.folder / file).write_bytes(data)
        run = self.simplify(file, "--faces", ALL_FACES)
        if run.code == 4:
            self.expect_reason(run, 4, file, "no faces|fewer than three corners|non-manifold|repeated|inconsistent")
            self.expect_old_outputs(file)
            return
        self.assertEqual(run.code, 0, run.stderr)
        self.assertEqual(corners(written_base(self.folder / "base.ply")), corners(left))

    def test_a_binary_file_must_be_whole(self):
        for name in ("ply little endian", "ply big endian", "stl binary"):
            self.cut_everywhere(name, self.expect_unreadable)

    def test_a_text_with_an_end_must_have_it(self):
        self.cut_everywhere("stl ascii", self.expect_unreadable)

    def test_a_text_with_counts_may_lack_only_the_last_line_end(self):
        for name in ("ply ascii", "off"):
            self.cut_everywhere(name, self.expect_unreadable_but_for_the_last_line_end)

    def test_a_text_without_counts_must_have_whole_numbers(self):
        self.cut_everywhere("obj", self.expect_what_obj_has)

    def test_the_whole_files_are_accepted(self):
        for name in ENCODINGS:
            with self.case(encoding=name):
                data = encoded(name, small_mesh()).data
                self.expect_accepted(f"whole.{extension(name)}", data, content(name, small_mesh()))


if __name__ == "__main__":
    unittest.main()
