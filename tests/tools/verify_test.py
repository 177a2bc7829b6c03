"""foldless verify, and simplify as far as it verifies."""

import struct

from meshes import ply_header, sphere, write_ply
from program import ProgramTest

VIOLATIONS = set(
    "topology kept_vertex border jacobian no_preimage several_preimages normal_condition orientation trace "
    "interior_sample base_ray undecided".split()
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
