"""Group B: counts that are no counts, or not those of what follows. Nothing may be allocated for what is only claimed."""

import struct
import unittest

from encoded_meshes import ENCODINGS, changed, content, encoded, extension, off, ply_ascii, small_mesh, stl_binary
from faults import PLACE, Case, FaultTest, at_byte, at_line

POINTS, FACES = small_mesh()
# Spelled in the place of a count of n.
HUGE = ("2147483647", "2147483648", "4294967295", "4294967296", "4294967297", "9223372036854775807")
TOO_LARGE = ("9223372036854775808", "18446744073709551616", "99999999999999999999", "9" * 400)
NO_INTEGERS = ("1.5", "3x", "nan", "1e3", "0x10", "--1", "+-1", "ten", ",")
# Counts that fit into an int32 list length, for the lengths of lists.
LENGTHS = ("4", "255", "256", "65536", "-1", "-3", "-2147483648", "2147483647", *TOO_LARGE[:2], "1.5", "x")


def huge_counts(name, file, data, old, line):
    """The count in the text `old` of the form 'before {} after' replaced by values that no file of this size has."""
    before, n, after = old
    whole = f"{before}{n}{after}".encode("ascii")

    def spelled(text):
        return changed(data, whole, f"{before}{text}{after}".encode("ascii"))

    for text in HUGE:
        yield Case(f"{name} {text}", file, spelled(text), 3, PLACE + ".*(cannot have|do not fit)")
    for text in TOO_LARGE:
        yield Case(f"{name} {text[:40]}", file, spelled(text), 3, at_line(line, "'9|'1") + ".*is too large")
    for text in NO_INTEGERS:
        yield Case(f"{name} {text}", file, spelled(text), 3, at_line(line, "") + ".*is not a(n integer| number)")
    yield Case(f"{name} -1", file, spelled("-1"), 3, at_line(line, "") + ".*negative")
    yield Case(f"{name} -{n}", file, spelled(f"-{n}"), 3, at_line(line, "") + ".*negative")
    yield Case(f"{name} is missing", file, spelled(""), 3, at_line(line, ".*(is missing|is not)|.*data behind"))
    for step in (-1, 1):
        yield Case(f"{name} {step:+}", file, spelled(str(int(n) + step)), 3, PLACE)
    yield Case(f"{name} 0", file, spelled("0"), 3, PLACE)


def with_short_face(case):
    return Case(case.name, case.file, case.data, 4, r"\A1 face has fewer than three corners\Z")


class Counts(FaultTest):
    group = "B counts"

    def test_of_ply_headers(self):
        for name in ("ply ascii", "ply little endian", "ply big endian"):
            data = encoded(name, small_mesh()).data
            vertex = ("element vertex ", str(len(POINTS)), "\n")
            cases = list(huge_counts(f"{name}: vertices", "count.ply", data, vertex, 3))
            if name == "ply little endian":
                # One vertex more takes all of the first face but its last byte, a 0, which is then an empty list; the
                # other faces follow as they are.
                cases = [with_short_face(case) if case.name.endswith(" +1") else case for case in cases]
            self.expect_all_refused(cases)
            face = ("element face ", str(len(FACES)), "\n")
            self.expect_all_refused(huge_counts(f"{name}: faces", "count.ply", data, face, 7))

    def test_of_elements_that_are_skipped(self):
        for name in ("ply ascii", "ply little endian"):
            data = changed(
                encoded(name, small_mesh()).data,
                b"end_header\n",
                b"element lie 1\nproperty uchar a\nproperty list uchar uchar b\nend_header\n",
            ) + (b"1 1 1\n" if name == "ply ascii" else b"\1\1\1")
            self.expect_all_refused(huge_counts(f"{name}: skipped", "count.ply", data, ("element lie ", "1", "\n"), 9))

    def test_of_elements_that_take_no_space(self):
        """They may be as many as they like: nothing is kept of them, and nothing has to be read."""
        for name in ("ply ascii", "ply little endian"):
            with self.case(encoding=name):
                data = encoded(name, small_mesh()).data
                data = changed(data, b"end_header\n", b"element void 9223372036854775807\nend_header\n")
                self.expect_accepted("void.ply", data, small_mesh())

    def test_of_vertices_or_faces_that_take_no_space(self):
        nothing = b"element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
        for element, others, says in (("vertex", b"", "no property 'x'"), ("face", nothing, "no list 'vertex_indices'")):
            header = f"ply\nformat ascii 1.0\nelement {element} 4000000000000000000\n".encode("ascii")
            case = Case(element, "count.ply", header + others + b"end_header\n", 3, PLACE + ".*" + says)
            with self.case(fault=f"{element} without properties"):
                self.expect_refused(case)

    def test_of_off(self):
        data = off(small_mesh()).data
        vertices, faces = str(len(POINTS)), str(len(FACES))
        self.expect_all_refused(huge_counts("off: vertices", "count.off", data, ("OFF\n", vertices, f" {faces} 0\n"), 2))
        self.expect_all_refused(huge_counts("off: faces", "count.off", data, (f"OFF\n{vertices} ", faces, " 0\n"), 2))
        joined = changed(data, b"OFF\n", b"OFF")
        for case in huge_counts("off: joined", "count.off", joined, ("OFF", vertices, f" {faces} 0\n"), 1):
            # "OFF-1" and the like: the first token is no longer a header that is followed by a count.
            with self.case(fault=case.name):
                says = at_line(1, "'-.*' for the count of vertices is not a number") if case.data.startswith(b"OFF-") else PLACE
                self.expect_refused(Case(case.name, case.file, case.data, 3, says))

    def test_of_edges_in_off_mean_nothing_but_are_integers(self):
        data = off(small_mesh()).data
        counts = f"{len(POINTS)} {len(FACES)} 0\n".encode("ascii")
        for edges in (b"0", b"1", b"60", b"-1", b"9223372036854775807"):
            with self.case(edges=edges):
                self.expect_accepted("edges.off", changed(data, counts, counts[:-2] + edges + b"\n"), small_mesh())
        with self.case(edges="none"):
            self.expect_accepted("edges.off", changed(data, counts, counts[:-3] + b"\n"), small_mesh())
        for edges in (b"1.5", b"many", b"9223372036854775808"):
            with self.case(edges=edges):
                data_with = changed(data, counts, counts[:-2] + edges + b"\n")
                self.expect_refused(Case("edges", "edges.off", data_with, 3, at_line(2, "'.*' for the count of edges")))
        with self.case(edges="a fourth count"):
            self.expect_refused(
                Case("edges", "edges.off", changed(data, counts, counts[:-1] + b" 7\n"), 3, at_line(2, "unexpected '7'"))
            )

    def test_of_binary_stl(self):
        data = stl_binary(small_mesh()).data
        n = len(FACES)
        for count in (0, 1, n - 1, n + 1, 2**31 - 1, 2**31, 2**32 - 1):
            with self.case(count=count):
                lie = data[:80] + struct.pack("<I", count) + data[84:]
                self.expect_refused(Case("count", "count.stl", lie, 3, at_byte(80, f"{count} triangles take")))
        with self.case(count="none and nothing"):
            (self.folder / "count.stl").write_bytes(data[:80] + struct.pack("<I", 0))
            self.expect_reason(self.simplify("count.stl"), 4, "count.stl", r"\Ano faces\Z")
            self.expect_old_outputs("count.stl")

    def test_of_lists_in_text(self):
        last = " ".join(map(str, FACES[-1]))
        for name in ("ply ascii", "off"):
            data = encoded(name, small_mesh()).data
            line = data.count(b"\n")
            for length in LENGTHS:
                with self.case(encoding=name, length=length):
                    lie = changed(data, f"\n3 {last}\n".encode("ascii"), f"\n{length} {last}\n".encode("ascii"))
                    never = name == "ply ascii" and (length.startswith("-") or length == "2147483647")
                    says = f"list 'vertex_indices' cannot have {length} values" if never and length not in TOO_LARGE else ""
                    self.expect_refused(Case(length, f"list.{extension(name)}", lie, 3, at_line(line, says)))

    def test_of_lists_in_bytes(self):
        for name in ("ply little endian", "ply big endian"):
            order = ">" if "big" in name else "<"
            for kind, code, lengths in (
                ("uchar", "B", (4, 255)),
                ("char", "b", (4, -1, -128)),
                ("ushort", "H", (4, 65535)),
                ("short", "h", (4, -3, -32768)),
                ("uint", "I", (4, 2**31, 2**32 - 1)),
                ("int", "i", (4, -3, -(2**31), 2**31 - 1)),
            ):
                data = ENCODINGS[name][0](small_mesh(), length=kind).data
                last = struct.calcsize("<" + code) + 12
                for length in lengths:
                    with self.case(encoding=name, type=kind, length=length):
                        start = len(data) - last
                        lie = data[:start] + struct.pack(order + code, length) + data[len(data) - 12 :]
                        self.expect_refused(Case(kind, "list.ply", lie, 3, at_byte(start, "list 'vertex_indices' cannot")))

    def test_of_short_lists_are_faces_without_three_corners(self):
        for length in (0, 1, 2):
            face = FACES[-1][:length]
            for name in ("ply ascii", "ply little endian", "ply big endian", "off", "obj"):
                with self.case(encoding=name, length=length):
                    mesh = POINTS, [*FACES[:-1], face]
                    file = f"short.{extension(name)}"
                    (self.folder / file).write_bytes(encoded(name, mesh).data)
                    run = self.simplify(file)
                    self.expect_reason(run, 4, file, r"\A1 face has fewer than three corners\Z")
                    self.expect_old_outputs(file)

    def test_of_the_right_size_are_accepted_in_any_type(self):
        for length in ("char", "uchar", "short", "ushort", "int", "uint"):
            for index in ("char", "uchar", "short", "ushort", "int", "uint"):
                for encode in (ENCODINGS["ply little endian"][0], ENCODINGS["ply big endian"][0], ply_ascii):
                    with self.case(length=length, index=index, encode=encode.__name__):
                        data = encode(small_mesh(), length=length, index=index).data
                        self.expect_accepted("types.ply", data, content("ply ascii", small_mesh()))

    def test_of_lists_are_not_real_numbers(self):
        for real in ("float", "double"):
            for length, index, says in (
                (real, "int", "the length of a list is not an integer"),
                ("uchar", real, "the vertex indices are not integers"),
            ):
                with self.case(length=length, index=index):
                    data = ply_ascii(small_mesh(), length=length, index=index).data
                    self.expect_refused(Case("real", "real.ply", data, 3, PLACE + says))


if __name__ == "__main__":
    unittest.main()
