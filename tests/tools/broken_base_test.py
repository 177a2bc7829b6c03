"""Groups B to E for base meshes: what verify says of a BASE whose properties are missing, no numbers, or out of range."""

import itertools
import unittest

from encoded_meshes import changed, encoded, obj, ply_ascii, ply_binary, small_mesh
from faults import PLACE, SANITIZED, FaultTest, at_byte, at_line, measure

MESH = small_mesh()
POINTS, FACES = MESH
N = len(POINTS)


def with_columns(properties, rows, face_properties="", face_rows=lambda i: ""):
    """The small mesh as an ascii PLY with further columns, as a base mesh has them."""
    data = ply_ascii(MESH).data.decode("ascii")
    header, text = data.split("end_header\n")
    header = header.replace("property float z\n", "property float z\n" + properties)
    header = header.replace("vertex_indices\n", "vertex_indices\n" + face_properties)
    lines = text.splitlines()
    lines[:N] = [line + " " + rows(i) for i, line in enumerate(lines[:N])]
    lines[N:] = [line + " " + face_rows(i) for i, line in enumerate(lines[N:])]
    return (header + "end_header\n" + "\n".join(lines) + "\n").encode("ascii")


NORMALS = "property float nx\nproperty float ny\nproperty float nz\n"
KEPT = NORMALS + "property int scan_vertex\n"
KEPT_DOUBLE = NORMALS + "property double scan_vertex\n"
RANGES = "property float t_min\nproperty float t_max\n"


def normal(i):
    return "{} {} {}".format(*POINTS[i])


def kept(i):
    return f"{normal(i)} {i}"


def replaced(row, number, text):
    """The rows with row `number` replaced."""
    return lambda i: text if i == number else row(i)


def base(**changes):
    """A base mesh that is the scan itself, with parts changed."""
    parts = {"properties": KEPT, "rows": kept, "face_properties": RANGES, "face_rows": lambda i: "0 0"} | changes
    return with_columns(**parts)


def base_obj(corner):
    """An OBJ with a normal for each vertex, and corners as `corner(vertex)` spells them."""
    points = "".join("v {} {} {}\nvn {} {} {}\n".format(*p, *p) for p in POINTS)
    return (points + "".join("f " + " ".join(corner(c + 1) for c in face) + "\n" for face in FACES)).encode("ascii")


class BrokenBase(FaultTest):
    group = "B-E base meshes"

    def setUp(self):
        super().setUp()
        (self.folder / "scan.ply").write_bytes(ply_binary(MESH).data)

    def reset_folder(self):
        super().reset_folder()
        (self.folder / "scan.ply").write_bytes(ply_binary(MESH).data)

    def verified(self, code, data, says, name="bad.ply"):
        with self.case(code=code, says=says):
            (self.folder / name).write_bytes(data)
            outputs = ["--report", "report.json", "--violations", "correspondence.ply"]
            run = measure(["verify", name, "scan.ply", *outputs], self.folder)
            if code == 0:
                self.assertEqual(run.code, 0, run.stderr)
                return
            self.expect_reason(run, code, name, says)
            if code == 3:
                self.assertRegex(run.stderr, PLACE)
            self.expect_old_outputs(name, "scan.ply")
            self.expect_modest(run, len(data))

    def test_the_scan_itself_is_certified(self):
        self.verified(0, base(), "")
        self.verified(0, base(face_properties="", face_rows=lambda i: ""), "")
        self.verified(0, base_obj(lambda v: f"{v}//{v}"), "", "bad.obj")
        self.verified(0, base_obj(lambda v: f"{v}//{v - N - 1}"), "", "bad.obj")
        self.verified(0, base_obj(lambda v: f"{v}/7/{v}"), "", "bad.obj")
        # Each normal is there twice, and corners name now the one, now the other.
        which = itertools.cycle((0, N))
        normals = "".join("vn {} {} {}\n".format(*p) for p in POINTS).encode("ascii")
        twice = base_obj(lambda v: f"{v}//{v + next(which)}").replace(b"f ", normals + b"f ", 1)
        self.verified(0, twice, "", "bad.obj")

    def test_scan_vertices_are_vertices_or_none(self):
        line = 16  # the first vertex
        for text in ("-2", "2147483648", "-2147483648", "99999999999999999999", "1.5", "x", ""):
            says = at_line(line, ".*scan_vertex")
            self.verified(3, base(rows=replaced(kept, 0, f"{normal(0)} {text}")), says)
        for text in ("-2", "2147483648", "1.5", "nan", "inf", "-inf", "-1.0000001", "-0.5"):
            says = at_line(line, f"scan_vertex {text} is neither a vertex nor -1|scan_vertex")
            self.verified(3, base(properties=KEPT_DOUBLE, rows=replaced(kept, 0, f"{normal(0)} {text}")), says)

    def test_scan_vertices_beyond_the_scan_are_refused(self):
        for vertex in (N, N + 1, 2147483647):
            data = base(rows=replaced(kept, 0, f"{normal(0)} {vertex}"))
            with self.case(vertex=vertex):
                (self.folder / "bad.ply").write_bytes(data)
                run = measure(["verify", "bad.ply", "scan.ply"], self.folder)
                self.assertIn(run.code, (3, 4, 6), run.stderr)
                self.assertRegex(run.stderr, r"\Afoldless: bad.ply")

    def test_directions_are_finite(self):
        for text in ("nan 0 0", "0 inf 0", "0 0 -inf"):
            says = r"\A1 displacement direction is not finite\Z"
            self.verified(4, base(rows=replaced(kept, 3, text + " 3")), says)
            faces = {"properties": "", "rows": lambda i: "", "face_properties": NORMALS}
            self.verified(4, base(face_rows=replaced(lambda i: "0 0 1", 3, text), **faces), says)

    def test_directions_are_numbers(self):
        for text in ("zero 0 0", "0 1e40 0", "0 0 0x1"):
            self.verified(3, base(rows=replaced(kept, 3, text + " 3")), at_line(19, "'.*' for n[xyz] is"))

    def test_directions_are_there(self):
        for properties in (
            "property float nx\nproperty float ny\n",
            "property float nx\nproperty float nz\n",
            "property float ny\nproperty float nz\n",
        ):
            rows = {"properties": properties, "rows": lambda i: "0 1"}
            self.verified(4, base(**rows), r"\Athe mesh has no displacement directions\Z")
        for name in ("ply", "obj"):
            data = encoded("ply ascii" if name == "ply" else "obj", MESH).data
            self.verified(4, data, r"\Athe mesh has no displacement directions\Z", f"bad.{name}")
        for name in ("off", "stl binary"):
            suffix = name.split()[0]
            self.verified(4, encoded(name, MESH).data, r"\Athe mesh has no displacement directions\Z", f"bad.{suffix}")

    def test_directions_are_declared_once(self):
        twice = KEPT + "property float nx\n"
        self.verified(
            3,
            base(properties=twice, rows=lambda i: kept(i) + " 0"),
            PLACE + "property 'nx' of element 'vertex' is declared twice",
        )
        listed = KEPT.replace("property float nx", "property list uchar float nx")
        self.verified(
            3,
            base(properties=listed, rows=lambda i: f"1 {kept(i)}"),
            PLACE + "property 'nx' of element 'vertex' is of the wrong kind",
        )

    def test_ranges_are_finite_and_ordered(self):
        says = r"\A1 displacement range is not finite or has t_min > t_max\Z"
        for text in ("1 0", "nan 0", "0 nan", "-inf 0", "0 inf", "inf inf", "nan nan"):
            self.verified(4, base(face_rows=replaced(lambda i: "0 0", 39, text)), says)

    def test_ranges_have_two_ends(self):
        for name in ("t_min", "t_max"):
            says = PLACE + "element 'face' has only one of 't_min' and 't_max'"
            self.verified(3, base(face_properties=f"property float {name}\n", face_rows=lambda i: "0"), says)

    def test_normals_of_obj_are_in_range(self):
        last = f"line {len(base_obj(str).splitlines())}"
        says = rf"\A{last}: normal index .* is out of range \({N} normals\)"
        for text in ("0", str(N + 1), str(-N - 1), "2147483648", "-9223372036854775808"):
            lie = changed(
                base_obj(lambda v: f"{v}//{v}"), b"\nf 1//1 6//6 2//2\n", f"\nf 1//1 6//6 2//{text}\n".encode("ascii")
            )
            self.verified(3, lie, says, "bad.obj")
        for text in ("1.5", "", "x", "99999999999999999999"):
            lie = changed(
                base_obj(lambda v: f"{v}//{v}"), b"\nf 1//1 6//6 2//2\n", f"\nf 1//1 6//6 2//{text}\n".encode("ascii")
            )
            self.verified(3, lie, rf"\A{last}: '{text}' for a normal index is not an integer", "bad.obj")

    def test_normals_of_obj_are_vectors(self):
        data = base_obj(lambda v: f"{v}//{v}")
        for text, says in (("0 0", "z is missing"), ("0 0 x", "'x' for z is not a number"), ("0 0 1 1", "unexpected '1'")):
            self.verified(3, changed(data, b"vn 0.0 0.0 1.0\n", f"vn {text}\n".encode("ascii")), at_line(2, says), "bad.obj")
        self.verified(
            4, changed(data, b"vn 0.0 0.0 1.0\n", b"vn 0.0 nan 1.0\n"), r"\A1 displacement direction is not finite\Z", "bad.obj"
        )

    def test_vertices_of_obj_have_one_normal(self):
        data = base_obj(lambda v: f"{v}//{v}")
        says = r"\Ano displacement directions: 1 vertex has several normals\Z"
        self.verified(4, changed(data, b"\nf 1//1 6//6 2//2\n", b"\nf 1//1 6//6 2//3\n"), says, "bad.obj")
        says = r"\Ano displacement directions: 1 vertex has no normal\Z"
        self.verified(4, changed(data, b"\nf 1//1 6//6 2//2\n", b"\nf 1//1 6//6 2\n"), says, "bad.obj")

    def test_indices_and_lengths_are_those_of_any_mesh(self):
        for text, says in (
            ("3 0 5 22", r"vertex index 22 is out of range \(22 vertices\)"),
            ("3 0 5 -1", "vertex index -1 is out of range"),
            ("4 0 5 1", "t_max is missing"),
        ):
            self.verified(3, changed(base(), b"\n3 0 5 1 0 0\n", f"\n{text} 0 0\n".encode("ascii")), at_line(77, says))
        data = ply_binary(MESH).data
        self.verified(3, data[:-1], at_byte(r"\d+", "list .vertex_indices. cannot have 3 values"))

    @unittest.skipIf(SANITIZED, "sanitizers take more memory")
    def test_counts_are_those_of_any_mesh(self):
        for count in ("2147483647", "9223372036854775807"):
            data = changed(base(), b"element vertex 22", f"element vertex {count}".encode("ascii"))
            self.verified(3, data, at_line(16, "element 'vertex' cannot have"))


if __name__ == "__main__":
    unittest.main()
