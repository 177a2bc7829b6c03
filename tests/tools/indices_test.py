"""Group C: indices of vertices that are none, in each format, and what OBJ says with signs and slashes."""

import re
import struct
import unittest

from encoded_meshes import ENCODINGS, PLY_TYPES, changed, encoded, extension, obj, off, ply_ascii, small_mesh
from faults import PLACE, Case, FaultTest, at_byte, at_line

POINTS, FACES = small_mesh()
N = len(POINTS)
OUT_OF_RANGE = rf"is out of range \({N} vertices\)"
TOO_LARGE = (2**63, -(2**63) - 1, 10**19, 10**400)
NO_INTEGERS = ("1.5", "1.0", "nan", "inf", "1e1", "0x1", "2a", "--1", "+-1", "-", "+", "one", "1,2")


def integer_cases(file, data, wrong, spell):
    """The faults of one index, which `spell(text)` puts into the file in the last line."""
    line = data.count(b"\n")
    for index in wrong:
        yield Case(f"index {index}", file, spell(str(index)), 3, at_line(line, f"vertex index {index} {OUT_OF_RANGE}"))
    for index in TOO_LARGE:
        yield Case(
            f"index {index}"[:40], file, spell(str(index)), 3, at_line(line, "'.*' for .* (is too large|is not an integer)")
        )
    for text in NO_INTEGERS:
        yield Case(
            f"index {text}", file, spell(text), 3, at_line(line, f"'{re.escape(text)}' for .* is not a(n integer| number)")
        )


class Indices(FaultTest):
    group = "C indices"

    def test_of_text_count_from_zero(self):
        first, second, third = FACES[-1]
        for name, wrong in (("ply ascii", (N, N + 1, -1, -N - 1)), ("off", (N, N + 1, -1, -N - 1))):
            data = encoded(name, small_mesh()).data
            last = f"\n3 {first} {second} {third}\n".encode("ascii")
            wrong = (*wrong, 2**31 - 1, 2**31, 2**32, 2**32 + 1, -(2**31), 2**63 - 1, -(2**63))
            for place in ("{} 5 1", "0 {} 1", "0 5 {}"):

                def spell(text, place=place):
                    return changed(data, last, f"\n3 {place.format(text)}\n".encode("ascii"))

                self.expect_all_refused(integer_cases(f"index.{extension(name)}", data, wrong, spell))
                with self.case(encoding=name, place=place, index="missing"):
                    self.expect_refused(
                        Case("missing", f"index.{extension(name)}", spell(""), 3, at_line(data.count(b"\n"), ".* is missing"))
                    )

    def test_of_bytes(self):
        for name in ("ply little endian", "ply big endian"):
            order = ">" if "big" in name else "<"
            for kind, wrong in (
                ("int", (N, N + 1, -1, -N - 1, 2**31 - 1, -(2**31))),
                ("uint", (N, 2**31, 2**32 - 1)),
                ("short", (N, -1, 2**15 - 1)),
                ("ushort", (N, 2**16 - 1)),
                ("char", (N, -1, -128, 127)),
                ("uchar", (N, 255)),
            ):
                data = ENCODINGS[name][0](small_mesh(), index=kind).data
                size = struct.calcsize("<" + PLY_TYPES[kind])
                for corner in range(3):
                    start = len(data) - (3 - corner) * size
                    for index in wrong:
                        with self.case(encoding=name, type=kind, index=index, corner=corner):
                            value = struct.pack(order + PLY_TYPES[kind], index)
                            lie = data[:start] + value + data[start + size :]
                            says = at_byte(start, f"vertex index {index} {OUT_OF_RANGE}")
                            self.expect_refused(Case("index", "index.ply", lie, 3, says))

    def test_of_obj_count_from_one(self):
        data = obj(small_mesh()).data
        wrong = (0, N + 1, N + 2, -N - 1, 2**31 - 1, 2**31, 2**32, 2**32 + 1, -(2**31), 2**63 - 1, -(2**63))
        for place in ("{} 6 2", "1 {} 2", "1 6 {}"):

            def spell(text, place=place):
                return changed(data, b"\nf 1 6 2\n", f"\nf {place.format(text)}\n".encode("ascii"))

            self.expect_all_refused(integer_cases("index.obj", data, wrong, spell))

    def test_of_obj_that_are_negative_count_from_the_last_vertex(self):
        data = obj((POINTS, [tuple(corner - N - 1 for corner in face) for face in FACES])).data
        with self.case(indices="negative"):
            self.expect_accepted("index.obj", data, small_mesh())
        # Vertices and faces mixed: -1 is the last vertex before the face.
        head, tail = data.split(b"f ", 1)
        points = head.splitlines(keepends=True)
        with self.case(indices="before all vertices"):
            lie = b"".join(points[:2]) + b"f -1 -2 -3\n" + b"".join(points[2:]) + b"f " + tail
            self.expect_refused(
                Case("early", "index.obj", lie, 3, at_line(3, r"vertex index -3 is out of range \(2 vertices\)"))
            )

    def test_of_obj_may_point_forward(self):
        data = obj(small_mesh()).data
        points, faces = data[: data.index(b"f ")], data[data.index(b"f ") :]
        with self.case(order="faces first"):
            self.expect_accepted("index.obj", faces + points, small_mesh())
        with self.case(order="faces first, one vertex missing"):
            missing = points[: points.rstrip().rindex(b"\n") + 1]
            line = 1 + next(i for i, face in enumerate(FACES) if N - 1 in face)
            says = at_line(line, rf"vertex index {N} is out of range \({N - 1} vertices\)")
            self.expect_refused(Case("missing", "index.obj", faces + missing, 3, says))

    def test_of_obj_with_slashes(self):
        data = obj(small_mesh()).data
        line = data.count(b"\n")
        for corner in ("1//", "1/", "1//x", "1/x", "1/1/", "1/1/1.5", "1/x/1", "1/1/1/1", "1/////", "1///1"):
            with self.case(corner=corner):
                lie = changed(data, b"\nf 1 6 2\n", f"\nf {corner} 6 2\n".encode("ascii"))
                says = at_line(line, "'.*' for a (texture|normal) index is not an integer")
                self.expect_refused(Case(corner, "slash.obj", lie, 3, says))
        for corner in ("/1", "//1", "/", "//", "x/1/1"):
            with self.case(corner=corner):
                lie = changed(data, b"\nf 1 6 2\n", f"\nf {corner} 6 2\n".encode("ascii"))
                self.expect_refused(Case(corner, "slash.obj", lie, 3, at_line(line, "'x?' for a vertex index is not")))
        with self.case(corner="a backslash within a line"):
            lie = changed(data, b"\nf 1 6 2\n", b"\nf 1 6\\2\n")
            says = at_line(line, r"'6\\2' for a vertex index is not an integer")
            self.expect_refused(Case("backslash", "slash.obj", lie, 3, says))
        # What is ignored needs not be there; the position is what it says.
        for corner in ("1/1", "1/2/999", "1//7", "1/-1/-1", "1/0/0", "+1", "01", "1/1/1"):
            with self.case(corner=corner):
                said = changed(data, b"\nf 1 6 2\n", f"\nf {corner} 6 2\n".encode("ascii"))
                self.expect_accepted("slash.obj", said, small_mesh())

    def test_of_obj_faces_without_three_corners(self):
        for face in (b"f", b"f 1", b"f 1 6", b"fo 1 6", b"f # 1 6 2"):
            with self.case(face=face):
                (self.folder / "short.obj").write_bytes(changed(obj(small_mesh()).data, b"f 1 6 2", face))
                run = self.simplify("short.obj")
                self.expect_reason(run, 4, "short.obj", r"\A1 face has fewer than three corners\Z")
                self.expect_old_outputs("short.obj")

    def test_that_repeat_a_vertex_are_counted(self):
        for name in ("ply ascii", "ply little endian", "off", "obj", "stl ascii", "stl binary"):
            with self.case(encoding=name):
                file = f"twice.{extension(name)}"
                (self.folder / file).write_bytes(encoded(name, (POINTS, [*FACES[:-1], (0, 5, 5)])).data)
                self.expect_reason(self.simplify(file), 4, file, r"\A1 face with a repeated index")
                self.expect_old_outputs(file)

    def test_of_a_corner_too_many_or_too_few(self):
        for name, data, line in (
            ("ply", ply_ascii(small_mesh()).data, "unexpected '9' at the end of the line"),
            ("off", off(small_mesh()).data, None),
        ):
            with self.case(format=name, corners="one more"):
                more = changed(data, b"\n3 0 5 1\n", b"\n3 0 5 1 9\n")
                if line is None:
                    self.expect_accepted("more.off", more, small_mesh())  # a colour
                else:
                    self.expect_refused(Case("more", f"more.{name}", more, 3, at_line(data.count(b"\n"), line)))
            with self.case(format=name, corners="one fewer"):
                fewer = changed(data, b"\n3 0 5 1\n", b"\n3 0 5\n")
                self.expect_refused(Case("fewer", f"fewer.{name}", fewer, 3, PLACE + ".* is missing"))


if __name__ == "__main__":
    unittest.main()
