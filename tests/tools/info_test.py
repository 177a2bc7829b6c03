"""foldless info."""

import json

from meshes import hill, sphere, tetrahedron, write_obj, write_off, write_ply
from program import ProgramTest


class Info(ProgramTest):
    def info(self, name):
        run = self.expect(0, "info", name, "--json")
        self.assertEqual(run.stderr, "")
        return json.loads(run.stdout)

    def test_tells_counts_and_topology(self):
        write_off(self.folder / "hill.off", hill(5))
        report = self.info("hill.off")
        self.assertEqual(report["command"], "info")
        self.assertEqual(report["path"], "hill.off")
        self.assertEqual((report["vertices"], report["faces"]), (36, 50))
        self.assertEqual((report["components"], report["boundary_loops"], report["boundary_edges"]), (1, 1, 20))
        self.assertEqual(report["euler_characteristic"], 1)
        self.assertEqual(report["unused_vertices"], 0)
        self.assertIs(report["accepted"], True)
        self.assertIsNone(report["refusal"])
        self.assertEqual(set(report["defects"].values()), {0})

    def test_speaks_to_people_on_standard_output(self):
        write_off(self.folder / "scan.off", tetrahedron())
        run = self.expect(0, "info", "scan.off")
        self.assertIn("4 vertices, 4 faces", run.stdout)
        self.assertIn("simplify accepts this mesh", run.stdout)
        self.assertEqual(run.stderr, "")

    def test_a_mesh_that_simplify_refuses_is_no_failure(self):
        write_off(self.folder / "bad.off", ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 1)]))
        refusal = self.expect_one_line(4, "simplify", "bad.off", "-o", "base.ply")
        report = self.info("bad.off")
        self.assertIs(report["accepted"], False)
        self.assertEqual(report["defects"]["repeated_index"], 1)
        self.assertIn(report["refusal"], refusal)
        self.assertIn(f"simplify refuses this mesh: {report['refusal']}", self.expect(0, "info", "bad.off").stdout)

    def test_polygons_that_cannot_be_fanned_are_no_failure(self):
        bent = ([(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)], [(0, 1, 2, 3)])
        write_obj(self.folder / "bent.obj", bent)
        self.expect_one_line(4, "simplify", "bent.obj", "-o", "base.ply")
        self.assertIn("convex", self.info("bent.obj")["refusal"])

    def test_what_cannot_be_read_is_a_failure(self):
        self.assertIn("none.ply", self.expect_one_line(3, "info", "none.ply"))
        (self.folder / "bad.off").write_text("OFF\n1 1 0\n0 0 zero\n3 0 0 0\n", encoding="ascii")
        self.assertIn("bad.off", self.expect_one_line(3, "info", "bad.off", "--json"))

    def test_a_base_mesh_has_directions_and_ranges(self):
        write_ply(self.folder / "scan.ply", sphere(8, 16))
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--quiet")
        report = self.info("base.ply")
        self.assertEqual(report["directions"], "vertices")
        self.assertIs(report["ranges"], True)
        self.assertEqual(report["notes"]["ignored"], [])
        self.assertEqual(self.info("scan.ply")["directions"], "none")
        self.assertIn("displacement directions", self.expect(0, "info", "base.ply").stdout)

    def test_an_obj_base_mesh_has_no_ranges(self):
        write_ply(self.folder / "scan.ply", sphere(8, 16))
        self.expect(0, "simplify", "scan.ply", "-o", "base.obj", "--quiet", "--no-verify")
        report = self.info("base.obj")
        self.assertEqual(report["directions"], "vertices")
        self.assertIs(report["ranges"], False)

    def test_directions_of_faces_are_told(self):
        write_ply(self.folder / "scan.ply", sphere(8, 16))
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--directions", "face", "--quiet", "--no-verify")
        self.assertEqual(self.info("base.ply")["directions"], "faces")
