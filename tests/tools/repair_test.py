"""foldless repair, and what info says of it."""

import json
import math
import struct

from meshes import ply_count, ply_header, sphere, tetrahedron, write_obj, write_off, write_ply
from program import ProgramTest


def scan_with_defects():
    """A sphere with a face twice, a face that names a vertex twice, a face turned over, a fin, and a crumb."""
    points, faces = sphere(6, 8)
    last = len(points)
    points = [*points, (0, 0, 3), (5, 0, 0), (6, 0, 0), (5, 1, 0), (7, 7, 7)]
    a, b, c = faces[20]
    faces = [*faces[:20], (a, c, b), *faces[21:], faces[3], (4, 4, 5), (0, 1, last), (last + 1, last + 2, last + 3)]
    return points, faces


class Repair(ProgramTest):
    def repair(self, *arguments):
        """Repairs scan.off into out.ply; returns the report."""
        self.expect(0, "repair", "scan.off", "-o", "out.ply", "--report", "report.json", *arguments)
        return self.json_of("report.json")

    def test_what_simplify_refuses_it_accepts_afterwards(self):
        write_off(self.folder / "scan.off", scan_with_defects())
        self.expect_one_line(4, "simplify", "scan.off", "-o", "base.ply")
        report = self.repair()
        self.assertGreater(sum(report["input"]["defects"].values()), 0)
        self.assertEqual(report["command"], "repair")
        done = {name: count for name, count in report["repairs"].items() if count > 0}
        self.assertEqual(
            done,
            {
                "repeated_index_faces": 1,
                "duplicate_faces": 1,
                "turned_faces": 1,
                "non_manifold_edges": 1,
                "split_vertices": 2,
                "added_vertices": 2,
                "dropped_vertices": 1,
            },
        )
        self.assertEqual(report["input"]["faces"] - 2, report["output"]["faces"])
        self.assertEqual(report["output"]["faces"], ply_count(self.folder / "out.ply", "face"))
        self.assertEqual(report["output"]["vertices"], ply_count(self.folder / "out.ply", "vertex"))
        self.assertEqual(report["output"]["components"], 3)
        self.expect(0, "simplify", "out.ply", "-o", "base.ply", "--quiet")
        self.expect(0, "verify", "base.ply", "out.ply", "--quiet")

    def test_what_was_done_is_counted_by_name(self):
        write_off(self.folder / "scan.off", scan_with_defects())
        run = self.expect(0, "repair", "scan.off", "-o", "out.ply")
        self.assertEqual(run.stdout, "")
        self.assertIn("1 duplicate face dropped, 1 face turned over, 1 non-manifold edge taken apart", run.stderr)
        self.assertEqual(len(run.stderr.splitlines()), 3)
        self.assertEqual(self.expect(0, "repair", "scan.off", "-o", "out.ply", "--quiet").stderr, "")

    def test_small_components_go_if_asked_for(self):
        write_off(self.folder / "scan.off", scan_with_defects())
        report = self.repair("--min-component-faces", "2")
        self.assertEqual(report["repairs"]["small_components"], 2)
        self.assertEqual(report["output"]["components"], 1)
        self.assertEqual(report["output"]["boundary_edges"], 0)
        self.assertIn("comment min-component-faces 2", ply_header(self.folder / "out.ply"))

    def test_unserved_vertices_go_if_asked_for(self):
        points, faces = sphere(6, 8)
        # The pole is pulled through the sphere: the faces around it look every way.
        ring = [list(points[i]) for i in range(1, 9)]
        ring[0] = [-2 * ring[0][0], -2 * ring[0][1], 1.5]
        ring[3] = [-2 * ring[3][0], -2 * ring[3][1], 1.2]
        points = [points[0], *map(tuple, ring), *points[9:]]
        write_off(self.folder / "scan.off", (points, faces))
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--report", "before.json", "--quiet")
        unserved = self.json_of("before.json")["unserved_vertices"]
        self.assertGreater(unserved, 0)
        self.assertEqual(sum(self.repair()["repairs"].values()), 0, "only if asked for")
        self.assertGreaterEqual(self.repair("--drop-unserved")["repairs"]["unserved_vertices"], unserved)
        self.expect(0, "simplify", "out.ply", "-o", "base.ply", "--report", "after.json", "--quiet")
        self.assertEqual(self.json_of("after.json")["unserved_vertices"], 0)

    def test_a_clean_scan_comes_out_as_it_is(self):
        write_ply(self.folder / "scan.ply", sphere(6, 8))
        self.expect(0, "repair", "scan.ply", "-o", "out.obj")
        self.assertIn("nothing to repair", self.expect(0, "repair", "out.obj", "-o", "out.ply").stderr)
        bodies = [(self.folder / name).read_bytes().split(b"end_header\n")[1] for name in ("scan.ply", "out.ply")]
        self.assertEqual(len(bodies[0]) - 3 * 80, len(bodies[1]), "counts are int there and uchar here")
        self.assertEqual(bodies[0][: 42 * 12], bodies[1][: 42 * 12], "positions keep their bits")

    def test_the_same_bytes_come_out_of_every_run_and_of_a_second_repair(self):
        write_off(self.folder / "scan.off", scan_with_defects())
        for scan, out in (("scan.off", "a.ply"), ("scan.off", "b.ply"), ("a.ply", "c.ply")):
            self.expect(0, "repair", scan, "-o", out, "--quiet")
        contents = {(self.folder / name).read_bytes() for name in ("a.ply", "b.ply", "c.ply")}
        self.assertEqual(len(contents), 1)

    def test_doubles_stay_doubles(self):
        points, faces = tetrahedron()
        write_off(self.folder / "scan.off", ([(0.1, 0.2, 0.3), *points[1:]], [*faces, faces[0]]))
        self.expect(0, "repair", "scan.off", "-o", "out.ply", "--quiet")
        self.assertIn("property double x", ply_header(self.folder / "out.ply"))
        self.assertIn(struct.pack("<3d", 0.1, 0.2, 0.3), (self.folder / "out.ply").read_bytes())

    def test_a_scan_of_which_nothing_is_left_is_refused(self):
        write_off(self.folder / "scan.off", ([(0, 0, 0), (1, 0, 0), (math.nan, 1, 0)], [(0, 1, 1), (0, 1, 2)]))
        before = self.files()
        line = self.expect_one_line(4, "repair", "scan.off", "-o", "out.ply", "--report", "report.json")
        self.assertIn("scan.off: no face is left", line)
        self.assertIn("not finite", line)
        self.assertEqual(self.files(), before, "nothing is written")

    def test_polygons_that_cannot_be_fanned_are_refused(self):
        write_obj(self.folder / "bent.obj", ([(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)], [(0, 1, 2, 3)]))
        self.assertIn("convex", self.expect_one_line(4, "repair", "bent.obj", "-o", "out.ply"))

    def test_simplify_repairs_nothing_unasked(self):
        write_off(self.folder / "scan.off", scan_with_defects())
        self.expect_one_line(4, "simplify", "scan.off", "-o", "base.ply")
        self.assertEqual(self.files(), ["scan.off"])


class Usage(ProgramTest):
    def setUp(self):
        super().setUp()
        write_off(self.folder / "scan.off", tetrahedron())

    def refused(self, code, *arguments):
        line = self.expect_one_line(code, "repair", *arguments)
        self.assertEqual(self.files(), ["scan.off"], "nothing is written")
        return line

    def test_the_scan_is_not_overwritten(self):
        (self.folder / "link.ply").symlink_to("scan.off")
        line = self.expect_one_line(2, "repair", "scan.off", "-o", "link.ply")
        self.assertIn("--output would overwrite the scan", line)
        self.assertIn("overwrite", self.expect_one_line(2, "repair", "scan.off", "-o", "out.ply", "--report", "scan.off"))

    def test_outputs_are_different_files(self):
        self.assertIn("--report", self.refused(2, "scan.off", "-o", "out.ply", "--report", "./out.ply"))

    def test_the_output_is_needed_and_has_a_type_that_can_be_written(self):
        self.assertIn("--output", self.refused(2, "scan.off"))
        self.assertIn("--output", self.refused(2, "scan.off", "-o", "out.stl"))

    def test_min_component_faces_is_a_whole_number_of_at_least_one(self):
        for value in ("0", "-1", "many", "1.5", ""):
            with self.subTest(value=value):
                line = self.refused(2, "scan.off", "-o", "out.ply", "--min-component-faces", value)
                self.assertIn("--min-component-faces", line)

    def test_what_cannot_be_read_or_written_is_told(self):
        self.assertIn("none.ply", self.refused(3, "none.ply", "-o", "out.ply"))
        self.assertIn("none", self.refused(5, "scan.off", "-o", "none/out.ply"))
        self.assertIn("none", self.refused(5, "scan.off", "-o", "out.ply", "--report", "none/report.json"))

    def test_the_report_is_refused_before_the_scan_is_read(self):
        self.assertIn("none", self.refused(5, "missing.off", "-o", "out.ply", "--report", "none/report.json"))


class InfoOnRepair(ProgramTest):
    def info(self, name):
        return json.loads(self.expect(0, "info", name, "--json").stdout)

    def test_names_the_repair_that_would_help(self):
        write_off(self.folder / "scan.off", scan_with_defects())
        outlook = self.info("scan.off")["repair"]
        self.expect(0, "repair", "scan.off", "-o", "out.ply", "--report", "report.json", "--quiet")
        report = self.json_of("report.json")
        self.assertEqual(outlook["repairs"], report["repairs"])
        self.assertEqual(outlook["faces"], report["output"]["faces"])
        self.assertEqual(outlook["vertices"], report["output"]["vertices"])
        lines = self.expect(0, "info", "scan.off").stdout.splitlines()
        self.assertTrue(lines[-2].startswith("simplify refuses this mesh"), lines)
        self.assertIn("foldless repair would make it acceptable: 1 face with a repeated index dropped", lines[-1])

    def test_says_nothing_of_a_mesh_that_is_accepted(self):
        write_off(self.folder / "scan.off", tetrahedron())
        self.assertIsNone(self.info("scan.off")["repair"])
        self.assertNotIn("repair", self.expect(0, "info", "scan.off").stdout)

    def test_says_that_no_repair_helps(self):
        write_off(self.folder / "scan.off", ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 1)]))
        self.assertIsNone(self.info("scan.off")["repair"])
        self.assertIn("foldless repair would refuse this mesh, too", self.expect(0, "info", "scan.off").stdout)
