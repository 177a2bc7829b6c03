"""What happens when the verification of a result fails, which it should never do: run on a program that has a verify()
of its own (failing_verify.cpp)."""

from meshes import hill, octahedron, tetrahedron, write_off
from program import ProgramTest


def icosahedron():
    """Connected as an icosahedron is: an antiprism of five sides between two pyramids."""
    points = [(0, 0, 2)]
    ring = [(2, 0), (1, 2), (-1, 2), (-2, 0), (0, -2)]
    points += [(x, y, 1) for x, y in ring] + [(x, y, -1) for x, y in ring] + [(0, 0, -2)]
    faces = []
    for k in range(5):
        a, b = 1 + k, 1 + (k + 1) % 5
        faces += [(0, a, b), (a, a + 5, b), (b, a + 5, b + 5), (11, b + 5, a + 5)]
    return points, faces


class NotCertified(ProgramTest):
    def setUp(self):
        super().setUp()
        write_off(self.folder / "scan.off", hill(4))
        (self.folder / "base.ply").write_text("old", encoding="ascii")

    def simplify(self, *arguments):
        return self.expect(6, "simplify", "scan.off", "-o", "base.ply", *arguments)

    def test_the_previous_output_is_untouched(self):
        self.simplify("--correspondence", "c.ply")
        self.assertEqual(self.files(), ["base.ply", "scan.off"])
        self.assertEqual((self.folder / "base.ply").read_text(encoding="ascii"), "old")

    def test_violations_are_counted_by_name_and_located_even_with_quiet(self):
        lines = self.simplify("--quiet").stderr.splitlines()
        self.assertEqual(
            lines,
            [
                "foldless: base.ply, which was not written: not certified: 1 border, 41 orientation",
                "foldless: border, scan vertex 7, base face 9, at (0.5, -1.5, 2)",
            ],
        )

    def test_the_report_tells_what_is_wrong(self):
        self.simplify("--report", "report.json")
        report = self.json_of("report.json")
        self.assertIsNone(report["output"]["path"])
        self.assertEqual(report["certificate"]["violations"], 42)
        self.assertEqual(report["certificate"]["violations_by_name"]["border"], 1)

    def test_nothing_is_found_where_nothing_is_verified(self):
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--no-verify")


class Bugs(ProgramTest):
    def failure(self, code, mesh):
        write_off(self.folder / "scan.off", mesh)
        line = self.expect_one_line(code, "simplify", "scan.off", "-o", "base.ply", "--faces", "1000", "--report", "r.json")
        self.assertEqual(self.files(), ["scan.off"])
        return line

    def test_a_bug_is_told_with_a_request_to_report_it(self):
        line = self.failure(1, tetrahedron())
        self.assertIn("internal error: bug", line)
        self.assertIn("report", line)

    def test_a_bug_that_nobody_can_catch_is_told_too(self):
        self.assertIn("internal error: deep bug", self.failure(1, octahedron()))

    def test_memory_that_runs_out_is_no_bug(self):
        self.assertEqual(self.failure(7, icosahedron()), "foldless: out of memory\n")
