"""Group D: coordinates that are no numbers, or numbers that few files have; nothing may be altered in silence."""

import os
import re
import shutil
import struct
import subprocess
import tempfile
import unittest

from encoded_meshes import ENCODINGS, TEXTS, changed, content, encoded, extension, ply_ascii, ply_binary, small_mesh
from faults import ALL_FACES, MEGABYTE, PLACE, Case, FaultTest, at_line

POINTS, FACES = small_mesh()
# The first coordinate of the first vertex, 0.0, in each text encoding.
FIRST = {
    "ply ascii": b"\n0.0 0.0 1.0\n", "off": b"\n0.0 0.0 1.0\n", "obj": b"v 0.0 0.0 1.0\n", "stl ascii": b"vertex 0.0 0.0 1.0\n"
}
NOT_NUMBERS = (
    "zero", "0,5", "0,0", "0x1p3", "0x10", "--1", "+-1", "-+1", "++1", "1e", "1e+", "e5", "1.0.0", "1_000", "1'000",
    ".", "-", "+", "1f", "1.5d", "1d0", "infinit", "nane", "1e5.5", "\u0661", "\uff11", "\u22121", "1\u00a02", "$", "NULL", "#IND", "1.#INF", "1.#QNAN",
)
NOT_FINITE = ("nan", "NaN", "-nan", "inf", "-inf", "+inf", "Infinity", "-INFINITY", "nan(0x7)")
TOO_LARGE = ("1e400", "-1e400", "1e309", "1.8e308", "9" * 400, "1e99999999999999999999", "-1e2147483648")
# What a coordinate 0 may be spelled as, or become, and what that is as a double.
EXACT = {
    "0": 0.0, "+0": 0.0, "0e5": 0.0, "0.": 0.0, ".0": 0.0, "-0.0": -0.0, "000": 0.0, "0e999": 0.0, "0e99999999999999999999": 0.0,
    "5e-324": 5e-324, "-5e-324": -5e-324, "1e-320": 1e-320, "2.2250738585072011e-308": 2.2250738585072011e-308,
    "1e-400": 0.0, "-1e-400": -0.0, "1e-99999999999999999999": 0.0, "2e-324": 0.0, "3e-324": 5e-324,
    "1e-310": 1e-310, "1E-3": 0.001, "+1e-3": 0.001, "0.1": 0.1, "0.1000000000000000055511151231257827021181583404541015625": 0.1,
    "1.0000000000000002e-9": 1.0000000000000002e-9, "0." + "0" * 5000 + "1": 0.0, "0." + "3" * 5000: 1 / 3,
}  # fmt: skip


def with_first(x, points=None):
    return [(x, 0.0, 1.0), *(points or POINTS)[1:]], FACES


def double_typed(name):
    """The text of the small mesh; PLY declares its coordinates as double, as the others need not."""
    return ply_ascii(small_mesh(), vertex="double").data if name == "ply ascii" else encoded(name, small_mesh()).data


def spelled(name, data, text):
    """The first coordinate replaced; STL names it once for each corner."""
    old = FIRST[name]
    return data.replace(old, old.replace(b"0.0", text.encode("utf-8"), 1))


def first_line(name, data):
    """The number of the line that holds the first coordinate."""
    at = data.index(FIRST[name])
    return data.count(b"\n", 0, at + 1) + 1


def german(folder):
    """The environment of a program that writes decimal commas, or None where the system cannot make such a locale."""
    localedef = shutil.which("localedef")
    if localedef is None:
        return None
    path = os.path.join(folder, "de_DE.UTF-8")
    made = subprocess.run([localedef, "-i", "de_DE", "-f", "UTF-8", path], capture_output=True, check=False)
    return os.environ | {"LC_ALL": "de_DE.UTF-8", "LOCPATH": folder} if made.returncode == 0 else None


class Numbers(FaultTest):
    group = "D numbers"

    def cases_of(self, name, texts, code, says):
        data = double_typed(name)
        file = f"number.{extension(name)}"
        line = first_line(name, data)
        for text in texts:
            if "#" in text and name in ("obj", "off"):
                continue  # a comment
            yield Case(text[:40], file, spelled(name, data, text), code, says(line))

    def test_that_are_none_are_named_with_their_line(self):
        for name in TEXTS:
            self.expect_all_refused(
                self.cases_of(name, NOT_NUMBERS, 3, lambda line: at_line(line, "'.*' for x is not a number"))
            )

    def test_that_are_too_large_are_named_with_their_line(self):
        for name in TEXTS:
            self.expect_all_refused(self.cases_of(name, TOO_LARGE, 3, lambda line: at_line(line, "'.*' for x is too large")))

    def test_that_are_not_finite_are_counted(self):
        for name in ("ply ascii", "off", "obj"):
            self.expect_all_refused(self.cases_of(name, NOT_FINITE, 4, lambda line: r"\A1 vertex that is not finite\Z"))
        self.expect_all_refused(self.cases_of("stl ascii", NOT_FINITE, 4, lambda line: r"\A1 vertex that is not finite\Z"))

    def test_in_bytes_that_are_not_finite_are_counted(self):
        for bits in (0x7F800000, 0xFF800000, 0x7FC00000, 0x7F800001, 0xFFFFFFFF):
            for order, name in (("<", "ply little endian"), (">", "ply big endian"), ("<", "stl binary")):
                with self.case(encoding=name, bits=hex(bits)):
                    data = encoded(name, small_mesh()).data
                    first = struct.pack(order + "3f", 0.0, 0.0, 1.0)
                    lie = data.replace(first, struct.pack(order + "I", bits) + first[4:])
                    self.expect_refused(Case(hex(bits), f"bits.{extension(name)}", lie, 4, r"\A1 vertex that is not finite\Z"))

    def test_that_are_missing_are_named_with_their_line(self):
        for name in ("ply ascii", "off", "obj", "stl ascii"):
            data = double_typed(name)
            line = first_line(name, data)
            for numbers, missing in (("0.0 0.0", "z"), ("0.0", "y"), ("", "x")):
                with self.case(encoding=name, numbers=numbers):
                    old = FIRST[name]
                    lie = changed(data, old, old.replace(b"0.0 0.0 1.0", numbers.encode("ascii")))
                    says = at_line(line, f"{missing} is missing")
                    if numbers == "" and name in ("ply ascii", "off"):
                        says = PLACE  # an empty line is passed over, and the first face is a vertex too many
                    self.expect_refused(Case(numbers, f"few.{extension(name)}", lie, 3, says))

    def test_of_a_megabyte_are_read_or_refused_at_once(self):
        ones, zeros = "1" * MEGABYTE, "0." + "0" * MEGABYTE + "1"
        for name in TEXTS:
            for token, says in (
                (ones, "is too large"),
                ("a" * MEGABYTE, "is not a number"),
                ("1e" + ones, "is too large"),
                ("-" * MEGABYTE, "is not a number"),
            ):
                with self.case(encoding=name, token=token[:3], says=says):
                    data = double_typed(name)
                    lie = changed(data, FIRST[name], FIRST[name].replace(b"0.0", token.encode("ascii"), 1))
                    says = at_line(first_line(name, data), f"'.*' for x {says}")
                    self.expect_refused(Case(token[:3], f"long.{extension(name)}", lie, 3, says))
            with self.case(encoding=name, token="zeros"):
                data = double_typed(name)
                lie = changed(data, FIRST[name], FIRST[name].replace(b"0.0", zeros.encode("ascii"), 1))
                self.expect_accepted(f"long.{extension(name)}", lie, content(name, small_mesh()))

    def test_in_text_are_the_nearest_doubles(self):
        for name in ("ply ascii", "off", "obj"):
            for text, value in EXACT.items():
                with self.case(encoding=name, text=text[:40]):
                    self.expect_accepted(f"exact.{extension(name)}", spelled(name, double_typed(name), text), with_first(value))

    def test_declared_as_float_are_the_nearest_floats(self):
        for text in (
            "0.1", "1e-46", "1e-45", "7.00649232162408535461864791644958065640e-46", "1.17549429e-38", "0.333333333333333333"
        ):
            with self.case(text=text):
                data = spelled("ply ascii", ply_ascii(small_mesh()).data, text)
                # Twice rounded is what would be once, save for the exact half, which the texts above are not.
                value = struct.unpack("f", struct.pack("f", float(text)))[0]
                self.expect_accepted("float.ply", data, with_first(value))
        for text in ("1e39", "-3.5e38", "3.4028236e38"):
            with self.case(text=text):
                data = spelled("ply ascii", ply_ascii(small_mesh()).data, text)
                says = at_line(
                    first_line("ply ascii", data.replace(text.encode("ascii"), b"0.0")),
                    f"'{re.escape(text)}' for x is too large",
                )
                self.expect_refused(Case(text, "float.ply", data, 3, says))

    def test_in_bytes_are_taken_as_they_are(self):
        values = (5e-324, 1e-310, 0.1, 1 / 3, -0.0)
        for value in values:
            for big in (False, True):
                with self.case(value=value, big=big):
                    mesh = with_first(value)
                    self.expect_accepted("double.ply", ply_binary(mesh, big=big, vertex="double").data, mesh)
        for bits in (1, 0x007FFFFF, 0x80000001, 0x3DCCCCCD):
            value = struct.unpack("<f", struct.pack("<I", bits))[0]
            for name in ("ply little endian", "ply big endian", "stl binary"):
                with self.case(encoding=name, bits=hex(bits)):
                    mesh = with_first(value)
                    self.expect_accepted(f"float.{extension(name)}", encoded(name, mesh).data, content(name, mesh))

    def test_of_a_coordinate_may_be_integers(self):
        grown = [tuple(int(64 * x) for x in point) for point in POINTS]
        for kind in ("char", "short", "int"):
            with self.case(type=kind):
                self.expect_accepted("int.ply", ply_binary((grown, FACES), vertex=kind).data, (grown, FACES))
                self.reset_folder()
                self.expect_accepted("int.ply", ply_ascii((grown, FACES), vertex=kind).data, (grown, FACES))
        with self.case(type="int", text="0.5"):
            data = ply_ascii((grown, FACES), vertex="int").data
            self.expect_refused(
                Case(
                    "half",
                    "int.ply",
                    changed(data, b"\n0 0 64\n", b"\n0.5 0 64\n"),
                    3,
                    at_line(10, "'0.5' for x is not an integer"),
                )
            )

    def test_have_a_decimal_point_in_every_locale(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = german(folder)
            if environment is None:
                self.skipTest("this system cannot make the locale de_DE")
            expected = subprocess.run(["printf", "%.1f", "0,5"], capture_output=True, env=environment, check=False).stdout
            self.assertEqual(expected, b"0,5", "the locale is in force")
            for name in ENCODINGS:
                with self.case(encoding=name):
                    file = f"locale.{extension(name)}"
                    (self.folder / file).write_bytes(encoded(name, small_mesh()).data)
                    self.assertEqual(self.simplify(file, "--faces", ALL_FACES).code, 0)
                    base = (self.folder / "base.ply").read_bytes()
                    report = self.json_of("report.json")
                    self.assertEqual(self.simplify(file, "--faces", ALL_FACES, env=environment).code, 0)
                    self.assertEqual((self.folder / "base.ply").read_bytes(), base)
                    self.assertEqual(self.json_of("report.json")["input"], report["input"])


if __name__ == "__main__":
    unittest.main()
