"""foldless simplify on scans that it can use."""

import os
import subprocess

from meshes import hill, ply_count, ply_header, sphere, tetrahedron, write_obj, write_off, write_ply
from program import ProgramTest

VERDICTS = set(
    "link_condition boundary frozen valence flip degenerate direction jacobian no_preimage several_preimages "
    "normal_condition orientation out_of_range max_displacement undecided".split()
)


class Simplify(ProgramTest):
    def setUp(self):
        super().setUp()
        write_ply(self.folder / "scan.ply", sphere(12, 24))
        self.scan_faces = 2 * 24 * 11

    def simplify(self, *arguments):
        run = self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--report", "report.json", *arguments)
        self.assertEqual(run.stdout, "")
        self.faces = ply_count(self.folder / "base.ply", "face")
        return run

    def test_decimates_until_every_edge_is_refused(self):
        self.simplify()
        self.assertLess(self.faces, self.scan_faces / 2)
        self.assertEqual(self.json_of("report.json")["stop_reason"], "every_edge_refused")

    def test_stops_at_the_target(self):
        self.simplify("--faces", "400")
        self.assertLessEqual(self.faces, 400)
        self.assertGreater(self.faces, 390, "the first state with at most that many")
        self.assertEqual(self.json_of("report.json")["stop_reason"], "target_reached")

    def test_a_ratio_is_a_share_of_the_faces(self):
        self.simplify("--ratio", "0.75")
        self.assertEqual(self.json_of("report.json")["options"]["faces"], self.scan_faces * 3 // 4)
        self.assertLessEqual(self.faces, self.scan_faces * 3 // 4)

    def test_a_ratio_is_what_its_decimals_say(self):
        write_off(self.folder / "hill.off", hill(5))
        for ratio, faces in (("0.58", 29), ("0.14", 7), ("1", 50), ("1e-9", 1)):
            with self.subTest(ratio=ratio):
                self.expect(0, "simplify", "hill.off", "-o", "h.ply", "--ratio", ratio, "--report", "h.json")
                self.assertEqual(self.json_of("h.json")["options"]["faces"], faces)

    def test_a_target_that_is_no_reduction_writes_the_scan_as_its_own_base(self):
        for faces in (self.scan_faces, self.scan_faces + 1, 10**18):
            with self.subTest(faces=faces):
                self.simplify("--faces", faces)
                report = self.json_of("report.json")
                self.assertEqual(self.faces, self.scan_faces)
                self.assertEqual(report["output"]["frozen_faces"], self.scan_faces)
                self.assertEqual(report["decimation_rate"], 0)
                self.assertEqual(report["displacement"]["max"], 0)

    def test_a_target_that_cannot_be_reached_is_told_in_one_line_even_with_quiet(self):
        run = self.simplify("--faces", "1", "--quiet")
        self.assertRegex(run.stderr, r"\Afoldless: the target of 1 faces is not reached: [^\n]+\n\Z")
        self.assertEqual(self.json_of("report.json")["stop_reason"], "every_edge_refused")

    def test_quiet_is_silent_on_success(self):
        self.assertEqual(self.simplify("--faces", "500", "--quiet").stderr, "")
        self.assertEqual(self.simplify("--quiet").stderr, "")

    def test_the_summary_goes_to_standard_error(self):
        text = self.simplify().stderr
        self.assertIn("528 faces", text)
        self.assertIn("base.ply", text)
        self.assertIn("certified", text)
        self.assertNotIn("\r", text, "no progress bar without a terminal")

    def test_a_time_limit_writes_what_is_reached(self):
        run = self.simplify("--time-limit", "0", "--faces", "100")
        report = self.json_of("report.json")
        self.assertEqual(report["stop_reason"], "time_limit")
        self.assertEqual(report["certificate"]["violations"], 0)
        self.assertIn("time limit", run.stderr)

    def test_a_bound_on_displacements_holds(self):
        self.simplify()
        unbounded = self.json_of("report.json")["displacement"]
        bound = max(-unbounded["min"], unbounded["max"]) / 4
        self.simplify("--max-displacement", repr(bound))
        bounded = self.json_of("report.json")["displacement"]
        self.assertLessEqual(max(-bounded["min"], bounded["max"]), bound)

    def test_a_bound_may_be_a_percentage_of_the_diagonal(self):
        self.simplify("--max-displacement", "0.5%")
        report = self.json_of("report.json")
        self.assertLessEqual(report["displacement"]["max_relative_to_diagonal"], 0.005)
        self.assertAlmostEqual(report["options"]["max_displacement"], 0.005 * 3.46, delta=0.001)

    def test_no_verify_leaves_the_certificate_out(self):
        run = self.simplify("--no-verify")
        report = self.json_of("report.json")
        self.assertIsNone(report["certificate"])
        self.assertFalse(report["options"]["verify"])
        self.assertEqual(report["seconds"]["verify"], 0)
        self.assertIn("not verified", run.stderr)
        self.expect(0, "verify", "base.ply", "scan.ply")

    def test_every_combination_of_presets_and_boundaries_is_certified(self):
        write_ply(self.folder / "scan.ply", hill(12))
        for preset in ("default", "paper"):
            for boundary in ("lock", "trim"):
                with self.subTest(preset=preset, boundary=boundary):
                    self.simplify("--preset", preset, "--boundary", boundary)
                    self.assertEqual(self.json_of("report.json")["certificate"]["violations"], 0)
                    self.expect(0, "verify", "base.ply", "scan.ply")

    def test_every_choice_of_directions_and_placement_is_certified(self):
        choices = [["--directions", word] for word in ("visible", "area", "angle", "face")]
        choices += [["--placement", word] for word in ("best", "endpoint", "midpoint", "quadric")]
        choices += [["--store-directions", word] for word in ("yes", "no")]
        for choice in choices:
            with self.subTest(choice=choice):
                self.simplify(*choice)
                self.expect(0, "verify", "base.ply", "scan.ply")

    def test_explicit_options_are_laid_over_the_preset(self):
        self.simplify("--preset", "paper", "--placement", "endpoint")
        options = self.json_of("report.json")["options"]
        self.assertEqual(options["preset"], "paper")
        self.assertEqual(options["placement"], "endpoint")
        self.assertEqual(options["directions"], "area")
        self.assertFalse(options["store_directions"])

    def test_the_order_of_preset_and_options_does_not_matter(self):
        self.simplify("--placement", "endpoint", "--preset", "paper")
        self.assertEqual(self.json_of("report.json")["options"]["placement"], "endpoint")


class Files(ProgramTest):
    def setUp(self):
        super().setUp()
        write_ply(self.folder / "scan.ply", sphere(12, 24))

    def test_the_header_names_version_preset_and_options_that_change_the_result(self):
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--faces", "100", "--threads", "2", "--time-limit", "999")
        text = "\n".join(line for line in ply_header(self.folder / "base.ply") if line.startswith("comment"))
        for word in ("foldless 0.", "preset default", "directions visible", "boundary lock", "faces 100"):
            self.assertIn(word, text)
        for word in ("thread", "999", "scan.ply", "base.ply", str(self.folder)):
            self.assertNotIn(word, text)

    def test_the_base_mesh_has_directions_ranges_and_scan_vertices(self):
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply")
        header = ply_header(self.folder / "base.ply")
        self.assertEqual(header[1], "format binary_little_endian 1.0")
        properties = [line.split()[1:] for line in header if line.startswith("property")]
        floats = [["float", name] for name in ("x", "y", "z", "nx", "ny", "nz")]
        self.assertEqual(
            properties,
            floats
            + [["int", "scan_vertex"], ["list", "uchar", "int", "vertex_indices"], ["float", "t_min"], ["float", "t_max"]],
        )

    def test_the_bytes_depend_on_neither_threads_nor_the_run(self):
        outputs = []
        for name, threads in (("a", "1"), ("b", "2"), ("c", "3")):
            self.expect(0, "simplify", "scan.ply", "-o", f"{name}.ply", "--correspondence", f"{name}.c.ply", "--threads", threads)
            outputs.append([(self.folder / f"{name}{end}").read_bytes() for end in (".ply", ".c.ply")])
        self.assertEqual(outputs[0], outputs[1])
        self.assertEqual(outputs[0], outputs[2])

    def test_numbers_are_spelled_alike_in_every_locale(self):
        known = subprocess.run(["locale", "-a"], capture_output=True, text=True, check=False).stdout.split()
        with_comma = [name for name in known if name.lower().startswith(("de_", "fr_", "it_", "es_"))]
        if not with_comma:
            self.skipTest("the system has no locale with a decimal comma")
        environment = os.environ | {"LC_ALL": with_comma[0]}
        write_obj(self.folder / "scan.obj", sphere(6, 12))
        arguments = ("simplify", "scan.obj", "--max-displacement", "1.5%", "-o")
        self.expect(0, *arguments, "a.obj", "--report", "report.json", env=environment)
        self.expect(0, *arguments, "b.obj")
        self.assertEqual((self.folder / "a.obj").read_bytes(), (self.folder / "b.obj").read_bytes())
        self.assertGreater(self.json_of("report.json")["options"]["max_displacement"], 0.01)

    def test_the_correspondence_has_one_vertex_per_scan_vertex(self):
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--correspondence", "c.ply")
        header = ply_header(self.folder / "c.ply")
        self.assertEqual(ply_count(self.folder / "c.ply", "vertex"), ply_count(self.folder / "scan.ply", "vertex"))
        names = [line.split()[-1] for line in header if line.startswith("property")]
        self.assertEqual(names, ["x", "y", "z", "base_face", "alpha0", "alpha1", "alpha2", "t"])

    def test_obj_is_written_and_its_lack_of_ranges_told(self):
        run = self.expect(0, "simplify", "scan.ply", "-o", "base.obj", "--faces", "300")
        self.assertRegex(run.stderr, "OBJ has no room for the ranges")
        self.assertIn("\nvn ", (self.folder / "base.obj").read_text(encoding="ascii"))
        self.expect(0, "verify", "base.obj", "scan.ply")

    def test_every_format_is_read(self):
        mesh = tetrahedron()
        write_off(self.folder / "a.off", mesh)
        write_obj(self.folder / "b.obj", mesh)
        write_ply(self.folder / "c.ply", mesh)
        corners = "\n".join(
            "facet normal 0 0 0 outer loop\n"
            + "\n".join("vertex {} {} {}".format(*mesh[0][corner]) for corner in face)
            + "\nendloop endfacet"
            for face in mesh[1]
        )
        (self.folder / "d.stl").write_text(f"solid t\n{corners}\nendsolid t\n", encoding="ascii")
        for name in ("a.off", "b.obj", "c.ply", "d.stl"):
            with self.subTest(name=name):
                self.expect(0, "simplify", name, "-o", "base.ply")

    def test_what_is_ignored_is_told_in_one_line_unless_quiet(self):
        write_obj(self.folder / "quads.obj", ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)]))
        with open(self.folder / "quads.obj", "a", encoding="ascii") as file:
            file.write("vt 0 0\nusemtl red\n")
        text = self.expect(0, "simplify", "quads.obj", "-o", "base.ply").stderr
        lines = [line for line in text.splitlines() if "ignored" in line]
        self.assertEqual(len(lines), 1)
        self.assertIn("fanned 1 polygon", lines[0])
        self.assertEqual(self.expect(0, "simplify", "quads.obj", "-o", "base.ply", "--quiet").stderr, "")

    def test_nothing_but_the_outputs_is_left(self):
        self.expect(0, "simplify", "scan.ply", "-o", "b.ply", "--correspondence", "c.ply", "--report", "r.json")
        self.assertEqual(self.files(), ["b.ply", "c.ply", "r.json", "scan.ply"])

    def test_an_existing_output_is_replaced(self):
        (self.folder / "base.ply").write_text("old", encoding="ascii")
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply")
        self.assertEqual(ply_header(self.folder / "base.ply")[0], "ply")


class Report(ProgramTest):
    def report(self):
        write_off(self.folder / "scan.off", hill(10))
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--report", "report.json", "--threads", "2")
        return self.json_of("report.json")

    def test_has_the_promised_keys_with_their_types(self):
        report = self.report()
        count, number, text = int, (int, float), str
        expected = {
            "foldless": text,
            "command": text,
            "options": dict,
            "input": dict.fromkeys(
                "vertices faces unused_vertices components boundary_loops boundary_edges euler_characteristic".split(), count
            )
            | {"path": text},
            "output": {"path": text, "vertices": count, "faces": count, "frozen_faces": count},
            "unserved_vertices": count,
            "decimation_rate": number,
            "stop_reason": text,
            "collapses": {"attempted": count, "accepted": count, "refused": dict, "refused_between_vertices": count},
            "displacement": dict.fromkeys(("min", "max", "rms", "max_relative_to_diagonal"), number),
            "certificate": {
                "level": text,
                "violations": count,
                "signs": {"filtered": count, "exact": count},
                "ambiguous_vertices": count,
                "uncovered_fraction": number,
                "ranges_computed": bool,
                "violations_by_name": dict,
                "located": list,
            },
            "seconds": dict.fromkeys(("read", "setup", "decimate", "verify", "write"), number),
            "cpu_seconds": dict.fromkeys(("read", "setup", "decimate", "verify", "write"), number),
            "peak_memory_bytes": count,
            "threads": count,
        }
        self.check_types(report, expected, "report")

    def check_types(self, value, expected, where):
        if not isinstance(expected, dict):
            self.assertIsInstance(value, expected, where)
            return
        self.assertEqual(set(value), set(expected), where)
        for key, inner in expected.items():
            self.check_types(value[key], inner, f"{where}.{key}")

    def test_tells_the_truth_about_the_meshes(self):
        report = self.report()
        self.assertEqual(report["command"], "simplify")
        self.assertEqual(report["input"]["path"], "scan.off")
        self.assertEqual(report["input"]["vertices"], 121)
        self.assertEqual(report["input"]["faces"], 200)
        self.assertEqual(report["input"]["boundary_edges"], 40)
        self.assertEqual(report["input"]["boundary_loops"], 1)
        self.assertEqual(report["input"]["euler_characteristic"], 1)
        base = self.folder / "base.ply"
        self.assertEqual(report["output"]["faces"], ply_count(base, "face"))
        self.assertEqual(report["output"]["vertices"], ply_count(base, "vertex"))
        self.assertAlmostEqual(report["decimation_rate"], 1 - ply_count(base, "face") / 200)
        self.assertEqual(report["threads"], 2)

    def test_counts_collapses_and_refusals_by_known_names(self):
        report = self.report()
        collapses = report["collapses"]
        self.assertGreaterEqual(collapses["attempted"], collapses["accepted"])
        self.assertLessEqual(set(collapses["refused"]), VERDICTS)
        self.assertTrue(collapses["refused"], "a decimation ends by refusals")
        self.assertEqual(report["input"]["faces"] - report["output"]["faces"], 2 * collapses["accepted"])

    def test_times_and_memory_are_plausible(self):
        report = self.report()
        for phase in ("read", "decimate", "verify", "write"):
            self.assertGreater(report["seconds"][phase], 0, phase)
            self.assertLess(report["seconds"][phase], 100, phase)
            self.assertGreaterEqual(report["cpu_seconds"][phase], 0, phase)
        self.assertGreater(report["peak_memory_bytes"], 1_000_000)
