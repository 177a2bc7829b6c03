"""`foldless bake` and `foldless reconstruct` as a user runs them."""

import json
import math
import zlib

from meshes import hill, ply_count, sphere, write_off
from plain_reader import read_ply
from program import ProgramTest

MAPS = ["base.glb", "base.mtl", "base.obj", "displacement.exr", "displacement.png", "maps.json", "mask.png", "normal_object.png", "normal_tangent.png", "vector.exr"]


def grey_png(path):
    """Width, height and the values of a PNG with one channel, read with nothing but zlib."""
    data = path.read_bytes()
    at, pixels, header = 8, b"", b""
    while at < len(data):
        length = int.from_bytes(data[at : at + 4], "big")
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        header = body if kind == b"IHDR" else header
        pixels += body if kind == b"IDAT" else b""
        at += length + 12
    width, height, size = int.from_bytes(header[:4], "big"), int.from_bytes(header[4:8], "big"), header[8] // 8
    raw, rows, before = zlib.decompress(pixels), [], bytes(width * size)
    for y in range(height):
        start = y * (width * size + 1)
        before = unfiltered(raw[start], raw[start + 1 : start + 1 + width * size], before, size)
        rows += [int.from_bytes(before[i : i + size], "big") for i in range(0, width * size, size)]
    return width, height, rows


def unfiltered(kind, line, before, size):
    result = bytearray()
    for i, byte in enumerate(line):
        left, up = (result[i - size] if i >= size else 0), before[i]
        corner = before[i - size] if i >= size else 0
        estimate = left + up - corner
        distances = [abs(estimate - value) for value in (left, up, corner)]
        paeth = (left, up, corner)[distances.index(min(distances))]
        result.append((byte + (0, left, up, (left + up) // 2, paeth)[kind]) % 256)
    return bytes(result)


class BakeTest(ProgramTest):
    def decimated(self, mesh, *arguments):
        write_off(self.folder / "scan.off", mesh)
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--quiet", *arguments)

    def bake(self, *arguments, code=0):
        return self.expect(code, "bake", "base.ply", "scan.off", "-o", "maps", "--atlas", "128", *arguments)

    def reconstruct(self, *arguments, code=0):
        return self.expect(code, "reconstruct", "base.ply", "maps", "-o", "back.ply", *arguments)


class Maps(BakeTest):
    def test_all_maps_are_written_into_a_new_folder(self):
        self.decimated(sphere(12, 16))
        run = self.bake()
        self.assertEqual(run.stdout, "")
        self.assertRegex(run.stderr, r"maps: 128 x 128 texels, \d+ samples, 0.00 % of them uncovered\n\Z")
        self.assertEqual(sorted(path.name for path in (self.folder / "maps").iterdir()), MAPS)

    def test_only_the_maps_that_are_asked_for_are_written(self):
        self.decimated(sphere(12, 16))
        self.bake("--maps", "displacement", "--quiet")
        names = {path.name for path in (self.folder / "maps").iterdir()}
        self.assertEqual(names, set(MAPS) - {"vector.exr", "normal_object.png", "normal_tangent.png"})

    def test_colours_of_the_scan_are_baked(self):
        points, faces = sphere(12, 16)
        self.decimated((points, faces))
        lines = ["COFF", f"{len(points)} {len(faces)} 0"]
        lines += [f"{x!r} {y!r} {z!r} 255 0 0 255" for x, y, z in points]
        lines += [" ".join(map(str, (3, *face))) for face in faces]
        (self.folder / "scan.off").write_text("\n".join(lines) + "\n", encoding="ascii")
        self.bake("--maps", "color")
        self.assertTrue((self.folder / "maps/color.png").exists())
        self.assertIn("map_Kd color.png", (self.folder / "maps/base.mtl").read_text(encoding="ascii"))

    def test_the_binary_gltf_holds_pictures_and_says_how_to_read_the_others(self):
        self.decimated(sphere(12, 16))
        self.bake("--quiet")
        data = (self.folder / "maps/base.glb").read_bytes()
        self.assertEqual(data[:4], b"glTF")
        gltf = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
        self.assertEqual(len(gltf["images"]), 1, "no colours")
        self.assertIn("_DISPLACEMENT_DIRECTION", gltf["meshes"][0]["primitives"][0]["attributes"])
        self.assertIn("normalTexture", gltf["materials"][0])
        notes = gltf["meshes"][0]["extras"]["foldless"]
        self.assertEqual(notes["vector"], json.loads((self.folder / "maps/maps.json").read_text(encoding="utf-8"))["vector"])
        self.assertIn((self.folder / "maps/normal_tangent.png").read_bytes(), data)

    def test_no_sample_of_a_closed_scan_is_empty(self):
        self.decimated(sphere(16, 24))
        for size in (64, 100, 257):
            self.expect(0, "bake", "base.ply", "scan.off", "-o", "maps", "--atlas", size, "--quiet")
            maps = json.loads((self.folder / "maps/maps.json").read_text(encoding="utf-8"))
            self.assertEqual(maps["uncovered"], 0)
            self.assertGreater(maps["samples"], size)

    def test_the_16_bit_map_says_how_it_is_scaled(self):
        self.decimated(sphere(12, 16))
        self.bake()
        scaling = json.loads((self.folder / "maps/maps.json").read_text(encoding="utf-8"))["displacement_16_bits"]
        width, height, values = grey_png(self.folder / "maps/displacement.png")
        self.assertEqual((width, height), (128, 128))
        self.assertEqual((min(values), max(values)), (0, 65535))
        # Beside the charts t is 0: the mid-level, to the nearest of 65,536 steps.
        self.assertAlmostEqual(values[-1] / 65535, scaling["mid_level"], delta=1 / 65535)

    def test_the_same_bytes_with_any_number_of_threads(self):
        self.decimated(sphere(16, 24))
        written = []
        for threads in ("1", "3"):
            self.bake("--threads", threads)
            written.append([(self.folder / "maps" / name).read_bytes() for name in MAPS])
        self.assertEqual(*written)

    def test_rays_find_the_same_map(self):
        self.decimated(sphere(16, 24))
        self.bake("--quiet")
        inverse = grey_png(self.folder / "maps/displacement.png")
        run = self.bake("--method", "direct")
        self.assertRegex(run.stderr, r" samples, 0\.00 % of them uncovered: 0 rays met nothing\n\Z")
        self.assertEqual(grey_png(self.folder / "maps/displacement.png")[:2], inverse[:2])
        # Both scales are of the same range; float32 edges may move a value by a step or two of 65,536.
        for direct, other in zip(grey_png(self.folder / "maps/displacement.png")[2], inverse[2]):
            self.assertLessEqual(abs(direct - other), 2)

    def test_a_trimmed_border_leaves_samples_uncovered(self):
        self.decimated(hill(20), "--boundary", "trim")
        self.bake("--quiet")
        width, height, mask = grey_png(self.folder / "maps/mask.png")
        self.assertIn(255, mask)
        maps = json.loads((self.folder / "maps/maps.json").read_text(encoding="utf-8"))
        self.assertGreaterEqual(maps["uncovered"], 0)


class SimplifyAndBake(BakeTest):
    def test_writes_what_two_commands_write(self):
        self.decimated(sphere(12, 16), "--faces", "40")
        self.bake("--quiet")
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--faces", "40", "--bake", "both", "--atlas", "128")
        self.assertEqual(sorted(path.name for path in (self.folder / "both").iterdir()), sorted(path.name for path in (self.folder / "maps").iterdir()))
        for path in (self.folder / "maps").iterdir():
            self.assertEqual(path.read_bytes(), (self.folder / "both" / path.name).read_bytes(), path.name)

    def test_an_atlas_without_room_leaves_the_base_mesh(self):
        write_off(self.folder / "scan.off", sphere(12, 16))
        line = self.expect_one_line(2, "simplify", "scan.off", "-o", "base.ply", "--bake", "maps", "--atlas", "2", "--quiet")
        self.assertIn("--atlas", line)
        self.assertTrue((self.folder / "base.ply").exists())
        self.assertFalse((self.folder / "maps").exists())

    def test_what_contradicts_itself_is_wrong_usage(self):
        write_off(self.folder / "scan.off", sphere(12, 16))
        self.expect_one_line(2, "simplify", "scan.off", "-o", "base.ply", "--atlas", "128")
        self.expect_one_line(2, "simplify", "scan.off", "-o", "base.ply", "--bake", "maps", "--directions", "face")
        self.expect_one_line(2, "simplify", "scan.off", "-o", "base.ply", "--bake", "maps", "--atlas", "0")
        self.expect_one_line(2, "simplify", "scan.off", "-o", "base.ply", "--bake", "")
        self.expect_one_line(5, "simplify", "scan.off", "-o", "base.ply", "--bake", "scan.off")
        self.expect_one_line(2, "simplify", "scan.off", "-o", "maps/base.obj", "--bake", "maps")
        self.assertFalse((self.folder / "base.ply").exists())


class Reports(BakeTest):
    def test_bake_tells_what_it_wrote(self):
        self.decimated(sphere(12, 16))
        self.bake("--report", "bake.json")
        report = json.loads((self.folder / "bake.json").read_text())
        self.assertEqual("bake", report["command"])
        self.assertEqual({"path": "maps", "method": "inverse", "size": 128, "uncovered": 0, "contested": 0}, {key: value for key, value in report["maps"].items() if key != "samples"})
        self.assertEqual(json.loads((self.folder / "maps" / "maps.json").read_text())["samples"], report["maps"]["samples"])
        self.assertEqual(0, report["certificate"]["violations"])
        self.assertEqual(["read", "verify", "fit", "bake", "write"], list(report["seconds"]))

    def test_bake_tells_what_is_wrong(self):
        self.decimated(sphere(12, 16))
        write_off(self.folder / "scan.off", hill(10))
        self.bake("--report", "bake.json", code=6)
        report = json.loads((self.folder / "bake.json").read_text())
        self.assertIsNone(report["maps"]["path"])
        self.assertGreater(report["certificate"]["violations"], 0)
        self.assertFalse((self.folder / "maps").exists())

    def test_the_distance_is_measured_both_ways(self):
        self.decimated(sphere(20, 30))
        self.bake()
        distances = []
        for level in range(1, 5):
            run = self.reconstruct("--level", str(level), "--compare", "scan.off", "--report", "back.json")
            self.assertEqual(3, len(run.stdout.splitlines() + run.stderr.splitlines()))
            comparison = json.loads((self.folder / "back.json").read_text())["comparison"]
            for side in (comparison["from_scan"], comparison["to_scan"]):
                self.assertLessEqual(side["maximum"], side["maximum_bound"])
                self.assertLessEqual(side["maximum_bound"], side["maximum"] + 1.01 * comparison["bound"])
                self.assertAlmostEqual(side["maximum"], math.dist(side["furthest"], side["nearest"]), 9)
                self.assertLess(side["rms"], side["maximum"])
            distances.append(max(comparison["from_scan"]["maximum"], comparison["to_scan"]["maximum"]))
        self.assertLess(distances[3], distances[1])
        self.assertLess(distances[1], distances[0])
        self.reconstruct("--report", "back.json")
        self.assertIsNone(json.loads((self.folder / "back.json").read_text())["comparison"])

    def test_maps_are_as_large_as_the_error_asks_for(self):
        self.decimated(sphere(40, 60), "--faces", "60")
        sizes = []
        for error in ("5%", "0.5%", "0.2%"):
            run = self.expect(0, "bake", "base.ply", "scan.off", "-o", "maps", "--max-error", error, "--atlas", "1024", "--report", "bake.json")
            report = json.loads((self.folder / "bake.json").read_text())
            fit = report["fit"]
            self.assertTrue(fit["fits"], fit)
            self.assertAlmostEqual(fit["max_error"], float(error[:-1]) / 100 * fit["bounding_box_diagonal"])
            self.assertIn(f"--level {fit['level']} within", run.stderr)
            sizes.append((report["maps"]["size"], fit["level"]))
            self.reconstruct("--level", str(fit["level"]), "--compare", "scan.off", "--report", "back.json")
            comparison = json.loads((self.folder / "back.json").read_text())["comparison"]
            for side in ("from_scan", "to_scan"):
                self.assertLessEqual(comparison[side]["maximum_bound"], fit["max_error"])
                self.assertAlmostEqual(comparison[side]["maximum"], fit[side]["maximum"], 5)
            if fit["level"] > 0:
                self.reconstruct("--level", str(fit["level"] - 1), "--compare", "scan.off", "--report", "back.json")
                comparison = json.loads((self.folder / "back.json").read_text())["comparison"]
                self.assertGreater(max(comparison[side]["maximum_bound"] for side in ("from_scan", "to_scan")), fit["max_error"])
        self.assertEqual(sizes, sorted(sizes))
        self.assertLess(sizes[0], sizes[2])

    def test_an_error_that_is_not_reached_is_told(self):
        self.decimated(sphere(12, 16))
        for quiet in ([], ["--quiet"]):
            run = self.expect(0, "bake", "base.ply", "scan.off", "-o", "maps", "--max-error", "0", "--atlas", "300", "--report", "bake.json", *quiet)
            self.assertIn("foldless: --max-error 0 is not reached: 300 x 300 texels", run.stderr)
            self.assertEqual(300, json.loads((self.folder / "bake.json").read_text())["maps"]["size"])
        for bound in ("-1", "x", "nan", "1%%"):
            self.expect_one_line(2, "bake", "base.ply", "scan.off", "-o", "maps", f"--max-error={bound}")

    def test_what_is_compared_with_stays(self):
        self.decimated(sphere(12, 16))
        self.bake()
        before = (self.folder / "scan.off").read_bytes()
        self.expect_one_line(2, "reconstruct", "base.ply", "maps", "-o", "back.ply", "--compare", "scan.off", "--report", "scan.off")
        self.expect_one_line(2, "reconstruct", "base.ply", "maps", "-o", "back.ply", "--report", "maps/maps.json")
        self.expect_one_line(2, "bake", "base.ply", "scan.off", "-o", "maps", "--report", "base.ply")
        self.expect_one_line(3, "reconstruct", "base.ply", "maps", "-o", "back.ply", "--compare", "none.off")
        self.expect_one_line(5, "reconstruct", "base.ply", "maps", "-o", "back.ply", "--report", "none/back.json")
        self.assertEqual(before, (self.folder / "scan.off").read_bytes())
        self.assertFalse((self.folder / "back.ply").exists())


class Reconstruction(BakeTest):
    def test_each_face_becomes_four_to_the_level(self):
        self.decimated(sphere(12, 16), "--faces", "40")
        faces = ply_count(self.folder / "base.ply", "face")
        self.bake()
        for level in (0, 1, 4):
            run = self.reconstruct("--level", str(level))
            self.assertEqual(ply_count(self.folder / "back.ply", "face"), faces * 4**level)
            self.assertRegex(run.stderr, r"\Aback.ply: \d+ vertices, \d+ faces\n\Z")

    def test_the_surface_is_closed_where_the_scan_is(self):
        self.decimated(sphere(12, 16))
        self.bake()
        self.reconstruct("--level", "4")
        report = json.loads(self.expect(0, "info", "back.ply", "--json").stdout)
        self.assertEqual((report["boundary_edges"], report["euler_characteristic"], report["components"]), (0, 2, 1))

    def test_its_points_lie_on_the_scan(self):
        self.decimated(sphere(24, 32))
        self.expect(0, "bake", "base.ply", "scan.off", "-o", "maps", "--atlas", "1024", "--quiet")
        self.reconstruct("--level", "6", "--quiet")
        points, _ = read_ply((self.folder / "back.ply").read_bytes())
        for point in points[::37]:
            self.assertLess(abs(math.dist(point, (0, 0, 0)) - 1.0), 0.03, "bumps are 0.02 high, chords 0.005")


class Refusals(BakeTest):
    def setUp(self):
        super().setUp()
        self.decimated(sphere(12, 16))

    def test_a_base_mesh_of_another_scan_is_not_baked(self):
        write_off(self.folder / "scan.off", sphere(10, 12))
        run = self.bake(code=6)
        self.assertIn("base.ply: not certified", run.stderr)
        self.assertFalse((self.folder / "maps").exists())

    def test_an_atlas_without_room_is_wrong_usage(self):
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--quiet", "--faces", "200")
        line = self.expect_one_line(2, "bake", "base.ply", "scan.off", "-o", "maps", "--atlas", "16")
        self.assertIn("an atlas of 16 x 16 has no room for", line)

    def test_wrong_values_of_options(self):
        for arguments in (["--atlas", "0"], ["--atlas", "16385"], ["--atlas", "x"], ["--maps", "heights"], ["--method", "both"],
                          ["--method", ""]):
            self.expect_one_line(2, "bake", "base.ply", "scan.off", "-o", "maps", *arguments)
        for level in ("-1", "13", "1.5"):
            self.expect_one_line(2, "reconstruct", "base.ply", "maps", "-o", "back.ply", f"--level={level}")
        self.expect_one_line(2, "reconstruct", "base.ply", "maps", "-o", "back.stl")
        self.expect_one_line(2, "reconstruct", "base.ply", "maps", "-o", "base.ply")

    def test_a_folder_that_is_a_file_is_not_overwritten(self):
        (self.folder / "maps").write_text("old", encoding="ascii")
        line = self.expect_one_line(5, "bake", "base.ply", "scan.off", "-o", "maps")
        self.assertIn("maps: is not a folder", line)
        self.assertEqual((self.folder / "maps").read_text(encoding="ascii"), "old")

    def test_inputs_in_the_folder_are_not_overwritten(self):
        self.bake("--quiet")
        before = (self.folder / "maps/base.obj").read_bytes()
        line = self.expect_one_line(2, "bake", "maps/base.obj", "scan.off", "-o", "maps")
        self.assertIn("base.obj of the maps", line)
        self.expect_one_line(2, "bake", "base.ply", "maps/base.obj", "-o", "./maps")
        self.assertEqual((self.folder / "maps/base.obj").read_bytes(), before)

    def test_a_folder_in_no_folder_cannot_be_written(self):
        self.expect_one_line(5, "bake", "base.ply", "scan.off", "-o", "nowhere/maps")

    def test_constant_face_directions_are_refused(self):
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--quiet", "--directions", "face")
        line = self.expect_one_line(4, "bake", "base.ply", "scan.off", "-o", "maps")
        self.assertIn("directions of faces", line)

    def test_damaged_maps_are_told_of(self):
        self.bake("--quiet")
        maps = self.folder / "maps"
        whole = {name: (maps / name).read_bytes() for name in ("maps.json", "displacement.exr", "mask.png")}
        for name, data in whole.items():
            for damaged in (data[: len(data) // 2], b"", b"{}"):
                (maps / name).write_bytes(damaged)
                line = self.expect_one_line(3, "reconstruct", "base.ply", "maps", "-o", "back.ply")
                self.assertIn(f"maps/{name}: ", line)
            (maps / name).write_bytes(data)
        self.reconstruct("--quiet")

    def test_charts_that_lie_outside_the_picture_are_refused(self):
        self.bake("--quiet")
        path = self.folder / "maps/maps.json"
        maps = json.loads(path.read_text(encoding="utf-8"))
        for chart in ([3, 0, 0, 1, 1, 0], [0, 127, 0, 1, 1, 0], [0, 0, 0, 1, 1, 0], [0, -1, 5, 1, 1, 0], [0, 5, 5, 0, 1, 0],
                      [0, 5, 5, 1], [0, 5.5, 5, 1, 1, 0], "chart", None, [0, 5, 5, 10**30, 1, 0]):
            wrong = dict(maps, charts=[chart, *maps["charts"][1:]])
            path.write_text(json.dumps(wrong), encoding="utf-8")
            self.expect_one_line(3, "reconstruct", "base.ply", "maps", "-o", "back.ply")

    def test_maps_of_another_base_mesh_are_refused(self):
        self.bake("--quiet")
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--quiet", "--faces", "40")
        line = self.expect_one_line(3, "reconstruct", "base.ply", "maps", "-o", "back.ply")
        self.assertIn(" charts, but the base mesh has ", line)
