"""Group P: each option without a value, with a wrong one, twice, empty; and targets at the edges of what makes sense."""

import unittest

from encoded_meshes import encoded, small_mesh, written_base
from faults import FaultTest, measure

SCAN_FACES = len(small_mesh()[1])
SIMPLIFY = ["simplify", "scan.ply", "-o", "base.ply"]
VERIFY = ["verify", "base.ply", "scan.ply"]
WITH_VALUE = (
    "--output --faces --ratio --time-limit --max-displacement --preset --directions --store-directions --placement --boundary "
    "--threads --report --correspondence"
).split()
WITH_VALUE_OF_VERIFY = "--report --violations --threads".split()
FLAGS = "--no-verify --quiet".split()
# No number of any kind.
NEVER = (
    *("nan -nan inf -inf zero 1,5 0x10 1e -- 1;2 \u0661 1e999 +-1 '1'".split()), "", " ", "1 2", "1\n2", "9" * 400
)
WRONG = {
    "--faces": (*NEVER, "0", "-1", "-0", "1.0", "0.5", "1e3", "1e30", "9223372036854775808", "3x", " 3", "3 ", "50%"),
    "--ratio": (*NEVER, "0", "-0", "-0.5", "1.0001", "1.0000000000000002", "2", "1e30", "50%", "0.5x", "1e-400"),
    "--time-limit": (*NEVER, "-1", "-1e-9", "1h", "10s"),
    "--max-displacement": (*NEVER, "-1", "-1%", "%", "1%%", "1 %", "%1", "1mm", "nan%", "inf%"),
    "--threads": (*NEVER, "0", "-2", "1.5", "1025", "4294967297", "all"),
    "--preset": ("", "Default", "papers", "default,paper", "0"),
    "--directions": ("", "Visible", "normal", "visible ", "0"),
    "--store-directions": ("", "Yes", "true", "1", "y"),
    "--placement": ("", "Best", "mid", "0"),
    "--boundary": ("", "Lock", "free", "0"),
    "--output": ("", "base", "base.stl", "base.off", "base.ply.gz", ".ply", "base.ply ", "base.p1y"),
    "--correspondence": ("", "c.obj", "c.json", "c"),
    "--report": ("",),
}
# Values at the edge of what is accepted.
RIGHT = {
    "--faces": ("1", "+7", "007", "9223372036854775807"),
    "--ratio": ("1", "1.0", "+0.5", "1e-300", "5e-324", "0.9999999999999999", ".5", "1e0", "1E-2"),
    "--time-limit": ("0", "-0", "0.0", "1e300", "1e-300", "5e-324", "1000000"),
    "--max-displacement": ("0", "-0", "0%", "1e300", "1e300%", "5e-324", "100%", "1e-3", "+1"),
    "--threads": ("1", "1024", "+2", "01"),
    "--preset": ("default", "paper"),
    "--directions": ("visible", "area", "angle", "face"),
    "--store-directions": ("yes", "no"),
    "--placement": ("best", "endpoint", "midpoint", "quadric"),
    "--boundary": ("lock", "trim"),
}


class Options(FaultTest):
    group = "P options"

    def reset_folder(self):
        super().reset_folder()
        (self.folder / "scan.ply").write_bytes(encoded("ply little endian", small_mesh()).data)

    def refused(self, says, *arguments):
        with self.case(arguments=arguments):
            run = measure(arguments, self.folder)
            self.assertEqual(run.code, 2, run.stderr)
            self.assertEqual(run.stdout, "")
            self.assertRegex(run.stderr, r"\Afoldless: [^\x00-\x1f]+\n\Z")
            self.assertRegex(run.stderr, says)
            self.expect_old_outputs("scan.ply")

    def accepted(self, *arguments):
        """The result is valid, and is verified as such."""
        with self.case(arguments=arguments):
            run = measure([*SIMPLIFY, *arguments], self.folder)
            self.assertEqual(run.code, 0, run.stderr)
            run = measure(VERIFY, self.folder)
            self.assertEqual(run.code, 0, run.stderr)
            return written_base(self.folder / "base.ply")

    def with_option(self, option, value):
        """A command line in which the option has this value; -o itself is not given twice."""
        return ["simplify", "scan.ply", *([] if option == "--output" else ["-o", "base.ply"]), f"{option}={value}"]

    def test_without_their_values_are_named(self):
        for option in WITH_VALUE:
            command = ["simplify", "scan.ply"] if option == "--output" else SIMPLIFY
            self.refused(f"{option} needs a value", *command, option)
            self.refused(f"{option} needs a value, not the option --quiet", *command, option, "--quiet")
            self.refused(f"{option} needs a value, not the option -h", *command, option, "-h")
        for option in WITH_VALUE_OF_VERIFY:
            self.refused(f"{option} needs a value", *VERIFY, option)
            self.refused(f"{option} needs a value, not the option --quiet", *VERIFY, option, "--quiet")
        self.refused("-o", "simplify", "scan.ply", "-o")

    def test_that_are_given_twice_are_named(self):
        for option in WITH_VALUE:
            value = (RIGHT.get(option) or ("out.ply",))[0]
            command = self.with_option(option, value)
            self.refused(f"{option} is given more than once", *command, option, value)
        for option in WITH_VALUE_OF_VERIFY:
            self.refused(f"{option} is given more than once", *VERIFY, option, "1", option, "1")

    def test_with_wrong_values_are_named(self):
        for option, values in WRONG.items():
            for value in values:
                self.refused(option, *self.with_option(option, value))
        for value in WRONG["--threads"]:
            self.refused("--threads", *VERIFY, f"--threads={value}")
        for value in ("", "v.obj", "v"):
            self.refused("--violations", *VERIFY, f"--violations={value}")

    def test_that_are_not_known_are_named(self):
        unknown = "--face --bogus -x -q --faces- --no-quiet ---quiet --QUIET --Faces -faces --violations --json"
        for option in unknown.split():
            self.refused(option.strip("-"), *SIMPLIFY, option, "1")
        for option in ("--faces", "--correspondence", "--json", "--no-verify"):
            self.refused(option, *VERIFY, option, "1")
        for option in ("--quiet", "--report", "--threads"):
            self.refused(option, "info", "scan.ply", option, "1")

    def test_flags_take_no_values(self):
        for flag in FLAGS:
            for value in ("maybe", "2x", "0", "1", "false"):
                with self.case(flag=flag, value=value):
                    run = measure([*SIMPLIFY, f"{flag}={value}"], self.folder)
                    self.assertEqual(run.code, 2, run.stderr)
                    self.assertRegex(run.stderr, rf"\Afoldless: {flag} takes no value [^\n]*\n\Z")

    def test_commands_and_files_that_are_missing_or_too_many_are_named(self):
        for says, *arguments in (
            ("a command is missing",),
            ("bogus", "bogus"),
            ("Simplify", "Simplify", "scan.ply", "-o", "base.ply"),
            ("SCAN", "simplify"),
            ("SCAN", "simplify", "-o", "base.ply"),
            ("--output", "simplify", "scan.ply"),
            ("extra", *SIMPLIFY, "extra"),
            ("BASE", "verify"),
            ("SCAN", "verify", "base.ply"),
            ("extra", *VERIFY, "extra"),
            ("MESH", "info"),
            ("extra", "info", "scan.ply", "extra"),
            ("simplify|verify|command", "simplify", "scan.ply", "-o", "base.ply", "verify"),
            ("command|not expected", ""),
        ):
            self.refused(says, *arguments)

    def test_that_contradict_one_another_are_named(self):
        for says, *arguments in (
            ("--faces and --ratio contradict", "--faces", "3", "--ratio", "0.5"),
            ("name the same file", "--report", "base.ply"),
            ("name the same file", "--report", "./base.ply"),
            ("name the same file", "--correspondence", "base.ply"),
            ("name the same file", "--correspondence", "x.ply", "--report", "x.ply"),
            ("name the same file", "--correspondence", "new.ply", "--report", "./new.ply"),
            ("would overwrite the scan", "--report", "scan.ply"),
            ("would overwrite the scan", "--correspondence", "scan.ply"),
        ):
            self.refused(says, *SIMPLIFY, *arguments)
        self.refused("--directions face needs", "simplify", "scan.ply", "-o", "base.obj", "--directions", "face")
        self.refused("would overwrite the base mesh", *VERIFY, "--violations", "base.ply")
        self.refused("would overwrite the scan", *VERIFY, "--report", "scan.ply")

    def test_at_the_edges_of_what_makes_sense_give_valid_results(self):
        for option, values in RIGHT.items():
            for value in values:
                points, faces = self.accepted(f"{option}={value}")
                self.assertLessEqual(len(faces), SCAN_FACES)
                self.assertGreater(len(points), 3)

    def test_targets_are_kept_exactly(self):
        for faces in (SCAN_FACES, SCAN_FACES + 1, 2**31, 2**32, 2**63 - 1):
            self.assertEqual(self.accepted(f"--faces={faces}"), small_mesh())
        for faces in (SCAN_FACES - 1, SCAN_FACES - 2, SCAN_FACES // 2):
            self.assertLessEqual(len(self.accepted(f"--faces={faces}")[1]), faces)
        self.assertEqual(self.accepted("--ratio=1"), small_mesh())
        self.assertEqual(self.accepted("--time-limit=0"), small_mesh())
        self.assertEqual(len(self.accepted(f"--ratio={1 - 1 / SCAN_FACES}")[1]) // 2 * 2, SCAN_FACES - 2)

    def test_targets_out_of_reach_are_told_in_one_line(self):
        for arguments in (["--faces", "1"], ["--faces", "3"], ["--ratio", "1e-9"], ["--faces", "4", "--time-limit", "0"]):
            with self.case(arguments=arguments):
                run = measure([*SIMPLIFY, "--quiet", *arguments], self.folder)
                self.assertEqual(run.code, 0)
                self.assertRegex(run.stderr, r"\Afoldless: the target of \d faces is not reached: [^\n]+\n\Z")

    def test_arguments_as_long_as_they_can_be_are_wrong_usage(self):
        for option in ("--faces", "--ratio", "--preset", "--report"):
            with self.case(option=option):
                run = measure([*SIMPLIFY, f"{option}={'9' * 50000}"], self.folder)
                self.assertIn(run.code, (2, 5))
                self.assertEqual(run.stderr.count("\n"), 1)
                self.expect_old_outputs("scan.ply")


if __name__ == "__main__":
    unittest.main()
