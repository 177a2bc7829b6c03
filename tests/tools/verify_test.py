"""foldless verify, and simplify as far as it verifies."""

import re
import resource
import struct

from meshes import ply_count, ply_header, sphere, write_ply
from program import ProgramTest, limit

VIOLATIONS = set(
    "topology kept_vertex border jacobian no_preimage several_preimages normal_condition orientation trace "
    "interior_sample base_ray pillar degree overlap".split()
)
BASE_VERTEX_BYTES = struct.calcsize("<6fi")


class Verify(ProgramTest):
    def setUp(self):
        super().setUp()
        write_ply(self.folder / "scan.ply", sphere(12, 24))
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--faces", "200", "--quiet")

    def damage(self):
        """Turns the direction of the first vertex that was moved inside out."""
        path = self.folder / "base.ply"
        head, body = path.read_bytes().split(b"end_header\n")
        count = next(int(line.split()[2]) for line in ply_header(path) if line.startswith("element vertex"))
        for start in range(0, count * BASE_VERTEX_BYTES, BASE_VERTEX_BYTES):
            vertex = struct.unpack_from("<6fi", body, start)
            if vertex[6] < 0:
                turned = (*vertex[:3], *(-number for number in vertex[3:6]), vertex[6])
                body = body[:start] + struct.pack("<6fi", *turned) + body[start + BASE_VERTEX_BYTES :]
                break
        else:
            self.fail("no vertex was moved")
        (self.folder / "damaged.ply").write_bytes(head + b"end_header\n" + body)

    def test_certifies_in_one_line_that_names_the_level(self):
        run = self.expect(0, "verify", "base.ply", "scan.ply")
        self.assertEqual(run.stdout, "")
        self.assertRegex(run.stderr, r"\Afoldless: base.ply represents scan.ply: certified, level surface[^\n]*\n\Z")

    def test_quiet_is_silent_when_certified(self):
        run = self.expect(0, "verify", "base.ply", "scan.ply", "--quiet")
        self.assertEqual(run.stdout + run.stderr, "")

    def test_counts_violations_by_name_and_locates_the_first_ones(self):
        self.damage()
        for quiet in ([], ["--quiet"]):
            with self.subTest(quiet=quiet):
                run = self.expect(6, "verify", "damaged.ply", "scan.ply", *quiet)
                lines = run.stderr.splitlines()
                self.assertRegex(lines[0], r"\Afoldless: damaged.ply: not certified: \d+ [a-z_]+")
                self.assertGreater(len(lines), 1)
                for line in lines[1:]:
                    self.assertRegex(line, r"\Afoldless: [a-z_]+(, (scan vertex|scan face|base face) \d+)*, at \(")
                    self.assertIn(line.split()[1].rstrip(","), VIOLATIONS)

    def test_reports_what_was_certified(self):
        self.expect(0, "verify", "base.ply", "scan.ply", "--report", "report.json")
        report = self.json_of("report.json")
        self.assertEqual(report["command"], "verify")
        self.assertEqual(report["input"]["path"], "scan.ply")
        self.assertEqual(report["output"]["path"], "base.ply")
        self.assertLessEqual(report["output"]["faces"], 200)
        self.assertEqual(report["certificate"]["level"], "surface")
        self.assertEqual(report["certificate"]["violations"], 0)
        self.assertEqual(set(report["certificate"]["violations_by_name"]), VIOLATIONS)
        self.assertEqual(set(report["seconds"]), {"read", "verify"})
        self.assertGreater(report["displacement"]["rms"], 0)

    def test_reports_violations_too(self):
        self.damage()
        self.expect(6, "verify", "damaged.ply", "scan.ply", "--report", "report.json")
        certificate = self.json_of("report.json")["certificate"]
        self.assertGreater(certificate["violations"], 0)
        self.assertEqual(certificate["violations"], sum(certificate["violations_by_name"].values()))
        self.assertTrue(certificate["located"])

    def violations_mesh(self):
        """The kinds that the comments name, the vertices and the faces of v.ply, numbers as text."""
        head, body = (self.folder / "v.ply").read_text(encoding="ascii").split("end_header\n")
        self.assertTrue(head.startswith("ply\nformat ascii 1.0\n"))
        kinds = dict(re.findall(r"^comment violation (\d+) (\w+)$", head, re.MULTILINE))
        count = ply_count(self.folder / "v.ply", "vertex")
        rows = [line.split() for line in body.splitlines()]
        vertices, faces = rows[:count], rows[count:]
        self.assertEqual(len(faces), ply_count(self.folder / "v.ply", "face"))
        return kinds, vertices, faces

    def test_writes_the_violations_as_a_mesh(self):
        self.damage()
        lines = self.expect(6, "verify", "damaged.ply", "scan.ply", "--violations", "v.ply").stderr.splitlines()
        kinds, vertices, faces = self.violations_mesh()
        self.assertEqual(set(kinds.values()), set(re.findall(r"\d+ ([a-z_]+)", lines[0])))
        for row in vertices:
            self.assertEqual(len(row), 7)
            self.assertIn(row[6], kinds)
        corners = {}
        for face in faces:
            self.assertEqual((len(face), face[0]), (5, "3"))
            triangle = [vertices[int(index)] for index in face[1:4]]
            self.assertEqual({row[6] for row in triangle}, {face[4]})
            colour = " ".join(triangle[0][3:6])
            corners.setdefault(colour, []).append([tuple(map(float, row[:3])) for row in triangle])
        points, triangles = sphere(12, 24)
        float32 = struct.Struct("<3f")
        named = [int(index) for line in lines[1:] for index in re.findall(r"scan face (\d+)", line)]
        self.assertTrue(named)
        wanted = [[float32.unpack(float32.pack(*points[v])) for v in triangles[face]] for face in named]
        self.assertEqual(corners["255 165 0"], wanted)
        self.assertEqual(len(corners["30 90 255"]), sum("base face" in line for line in lines[1:]))
        self.assertEqual(sum(row[3:6] == ["230", "25", "25"] for row in vertices), len(lines) - 1)

    def test_names_the_base_face_of_what_is_found_on_a_scan_face(self):
        self.damage()
        for line in self.expect(6, "verify", "damaged.ply", "scan.ply").stderr.splitlines()[1:]:
            if re.match("foldless: (normal_condition|trace|pillar),", line):
                self.assertRegex(line, r", scan face \d+, base face \d+, at")

    def test_writes_an_empty_mesh_when_certified(self):
        self.expect(0, "verify", "base.ply", "scan.ply", "--violations", "v.ply")
        self.assertEqual(self.violations_mesh(), ({}, [], []))

    def test_violations_that_cannot_be_written_are_a_failure(self):
        self.damage()
        (self.folder / "v.ply").mkdir()
        before = self.files()
        for name in ("none/v.ply", "v.ply"):
            with self.subTest(name=name):
                line = self.expect_one_line(
                    5, "verify", "damaged.ply", "scan.ply", "--report", "r.json", "--violations", name
                )
                self.assertIn(name, line)
                self.assertEqual(self.files(), before)

    def test_a_full_disk_leaves_the_old_violations(self):
        self.damage()
        (self.folder / "v.ply").write_text("old", encoding="ascii")
        before = self.files()
        bound = limit(resource.RLIMIT_FSIZE, 100)
        self.expect_one_line(
            5, "verify", "damaged.ply", "scan.ply", "--quiet", "--violations", "v.ply", preexec_fn=bound
        )
        self.assertEqual((self.folder / "v.ply").read_text(encoding="ascii"), "old")
        self.assertEqual(self.files(), before)

    def test_finds_that_a_base_mesh_is_of_another_scan(self):
        write_ply(self.folder / "other.ply", sphere(13, 25))
        self.expect(6, "verify", "base.ply", "other.ply")

    def test_agrees_with_the_report_of_simplify(self):
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--report", "a.json")
        self.expect(0, "verify", "base.ply", "scan.ply", "--report", "b.json")
        a, b = self.json_of("a.json"), self.json_of("b.json")
        for key in ("input", "output", "certificate", "decimation_rate"):
            self.assertEqual(a[key], b[key], key)
        for key, value in a["displacement"].items():
            self.assertAlmostEqual(value, b["displacement"][key], msg=key)

    def test_refuses_a_base_mesh_without_directions(self):
        line = self.expect_one_line(4, "verify", "scan.ply", "scan.ply")
        self.assertIn("scan.ply", line)
        self.assertIn("directions", line)

    def test_cannot_read_what_is_missing(self):
        self.assertIn("none.ply", self.expect_one_line(3, "verify", "none.ply", "scan.ply"))
        self.assertIn("none.ply", self.expect_one_line(3, "verify", "base.ply", "none.ply"))

    def test_does_not_depend_on_threads(self):
        self.damage()
        runs = [self.expect(6, "verify", "damaged.ply", "scan.ply", "--threads", n).stderr for n in ("1", "2", "3")]
        self.assertEqual(runs[0], runs[1])
        self.assertEqual(runs[0], runs[2])
