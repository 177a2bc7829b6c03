"""The command line: what is wrong usage, and what is printed where."""

from meshes import tetrahedron, write_off
from program import ProgramTest


class Help(ProgramTest):
    def test_version_goes_to_standard_output(self):
        for arguments in (["--version"], ["simplify", "--version"], ["verify", "--version"], ["repair", "--version"], ["bake", "--version"], ["reconstruct", "--version"], ["info", "--version"]):
            run = self.expect(0, *arguments)
            self.assertRegex(run.stdout, r"\Afoldless \d+\.\d+\.\d+\n\Z")
            self.assertEqual(run.stderr, "")

    def test_help_goes_to_standard_output(self):
        for arguments in (["--help"], ["simplify", "--help"], ["verify", "--help"], ["repair", "--help"], ["bake", "--help"], ["reconstruct", "--help"], ["info", "--help"]):
            run = self.expect(0, *arguments)
            self.assertIn("Usage: foldless", run.stdout)
            self.assertEqual(run.stderr, "")

    def test_help_names_the_commands(self):
        for command in ("simplify", "verify", "repair", "bake", "reconstruct", "info"):
            self.assertIn(command, self.expect(0, "--help").stdout)

    def test_help_of_simplify_names_each_option_that_is_promised(self):
        text = self.expect(0, "simplify", "--help").stdout
        for option in (
            "--faces --ratio --preset --directions --store-directions --placement --boundary --max-displacement "
            "--threads --time-limit --report --correspondence --no-verify --quiet --version --help --output"
        ).split():
            self.assertIn(option, text)

    def test_help_of_verify_names_each_option_that_is_promised(self):
        text = self.expect(0, "verify", "--help").stdout
        for option in "--report --violations --threads --quiet --version --help".split():
            self.assertIn(option, text)

    def test_help_of_repair_names_each_option_that_is_promised(self):
        text = self.expect(0, "repair", "--help").stdout
        for option in "--output --min-component-faces --drop-unserved --report --quiet --version --help".split():
            self.assertIn(option, text)


class WrongUsage(ProgramTest):
    def setUp(self):
        super().setUp()
        write_off(self.folder / "scan.off", tetrahedron())

    def refused(self, *arguments):
        line = self.expect_one_line(2, *arguments)
        self.assertEqual(self.files(), ["scan.off"], "nothing is written")
        return line

    def simplify_refused(self, *arguments):
        return self.refused("simplify", "scan.off", "-o", "base.ply", *arguments)

    def test_a_command_is_needed(self):
        self.assertIn("simplify, verify, repair, bake, reconstruct or info", self.refused())

    def test_an_unknown_command_is_named(self):
        self.assertIn("bogus", self.refused("bogus"))

    def test_an_unknown_option_is_named(self):
        self.assertIn("--bogus", self.simplify_refused("--bogus"))
        self.assertIn("--jsn", self.refused("info", "scan.off", "--jsn"))

    def test_options_are_not_abbreviated(self):
        self.assertIn("--fac", self.simplify_refused("--fac", "3"))

    def test_a_missing_file_argument_is_named(self):
        self.assertIn("SCAN", self.refused("simplify", "-o", "base.ply"))
        self.assertIn("--output", self.refused("simplify", "scan.off"))
        self.assertIn("SCAN", self.refused("verify", "base.ply"))
        self.assertIn("MESH", self.refused("info"))

    def test_a_missing_value_is_named(self):
        self.assertIn("--report needs a value", self.simplify_refused("--report"))

    def test_an_argument_too_many_is_named(self):
        self.assertIn("extra", self.simplify_refused("extra"))
        self.assertIn("third", self.refused("verify", "a.ply", "b.ply", "third"))

    def test_an_empty_file_name_is_refused(self):
        self.simplify_refused("--report", "")
        self.refused("simplify", "", "-o", "base.ply")
        self.refused("simplify", "scan.off", "-o", "")
        self.refused("info", "")

    def test_faces_is_a_whole_number_of_at_least_one(self):
        for value in ("0", "-1", "nan", "inf", "1e30", "1e3", "2.5", "99999999999999999999", "", " 3", "3x", "0x10"):
            with self.subTest(value=value):
                self.assertIn("--faces", self.simplify_refused("--faces", value))

    def test_ratio_is_above_zero_and_at_most_one(self):
        for value in ("0", "-0.5", "1.0001", "nan", "inf", "", "half", "0,5", "50%"):
            with self.subTest(value=value):
                self.assertIn("--ratio", self.simplify_refused("--ratio", value))

    def test_faces_and_ratio_contradict_one_another(self):
        line = self.simplify_refused("--faces", "3", "--ratio", "0.5")
        self.assertIn("--faces", line)
        self.assertIn("--ratio", line)

    def test_threads_is_a_whole_number_of_at_least_one(self):
        for value in ("0", "-2", "1.5", "many", "1025", "4294967297"):
            with self.subTest(value=value):
                self.assertIn("--threads", self.simplify_refused("--threads", value))

    def test_time_limit_is_a_finite_number_of_seconds(self):
        for value in ("-1", "nan", "inf", "1h", ""):
            with self.subTest(value=value):
                self.assertIn("--time-limit", self.simplify_refused("--time-limit", value))

    def test_max_displacement_is_a_length_or_a_percentage(self):
        for value in ("-1", "nan", "inf", "%", "1%%", "1 %", "1mm", "-1%"):
            with self.subTest(value=value):
                self.assertIn("--max-displacement", self.simplify_refused("--max-displacement", value))

    def test_choices_are_named_when_a_word_is_none_of_them(self):
        for option, word in (
            ("--preset", "paper"),
            ("--directions", "visible"),
            ("--store-directions", "yes"),
            ("--placement", "midpoint"),
            ("--boundary", "trim"),
        ):
            with self.subTest(option=option):
                line = self.simplify_refused(option, "bogus")
                self.assertIn(option, line)
                self.assertIn(word, line)

    def test_an_option_with_a_value_is_given_once(self):
        self.assertIn("--faces is given more than once", self.simplify_refused("--faces", "3", "--faces", "4"))

    def test_unsupported_output_types_are_refused_before_any_work(self):
        for name in ("base.stl", "base.off", "base", "base.ply.gz", ".ply"):
            with self.subTest(name=name):
                self.assertIn("--output", self.refused("simplify", "missing.off", "-o", name))
        self.assertIn("--correspondence", self.simplify_refused("--correspondence", "c.obj"))

    def test_obj_has_no_room_for_directions_of_faces(self):
        self.refused("simplify", "scan.off", "-o", "base.obj", "--directions", "face")

    def test_outputs_are_different_files(self):
        self.assertIn("--report", self.simplify_refused("--report", "base.ply"))
        self.assertIn("--correspondence", self.simplify_refused("--correspondence", "./base.ply"))

    def test_no_output_overwrites_the_scan(self):
        (self.folder / "scan.ply").symlink_to("scan.off")
        for arguments in (
            ["-o", "scan.ply"],
            ["-o", "base.ply", "--report", "scan.off"],
            ["-o", "base.ply", "--correspondence", "../" + self.folder.name + "/scan.ply"],
        ):
            with self.subTest(arguments=arguments):
                self.assertIn("overwrite", self.expect_one_line(2, "simplify", "scan.off", *arguments))
        self.assertIn("overwrite", self.expect_one_line(2, "verify", "base.ply", "scan.off", "--report", "scan.off"))

    def test_verify_overwrites_no_mesh_and_writes_violations_as_ply(self):
        for arguments in (
            ["--violations", "v.obj"],
            ["--violations", "base.ply"],
            ["--report", "./base.ply"],
            ["--report", "v.ply", "--violations", "./v.ply"],
        ):
            with self.subTest(arguments=arguments):
                self.assertIn(arguments[0], self.refused("verify", "base.ply", "scan.off", *arguments))

    def test_control_characters_do_not_break_the_line(self):
        self.refused("simplify", "scan.off", "-o", "base.ply", "--bo\ngus")
        self.refused("simplify", "scan.off", "-o", "ba\nse.stl")
        self.simplify_refused("--faces", "1\n2")


class Names(ProgramTest):
    def test_files_may_have_any_name(self):
        for scan, base in (("a scan.off", "a base.ply"), ("größe.off", "基.ply"), ("SCAN.OFF", "BASE.PLY"), ("[a].off", "[b].ply")):
            with self.subTest(scan=scan):
                write_off(self.folder / scan, tetrahedron())
                self.expect(0, "simplify", scan, "-o", base)
                self.assertIn(base, self.files())

    def test_a_leading_dash_is_a_name_after_two_dashes(self):
        write_off(self.folder / "-scan.off", tetrahedron())
        self.expect(0, "simplify", "-o", "-base.ply", "--", "-scan.off")
        self.expect(0, "verify", "--", "-base.ply", "-scan.off")
        self.expect(0, "info", "--", "-scan.off")

    def test_a_file_may_be_called_like_a_command(self):
        write_off(self.folder / "info", tetrahedron())
        self.assertIn("unknown file type", self.expect_one_line(3, "info", "info"))
        self.assertIn("unknown file type", self.expect_one_line(3, "simplify", "info", "-o", "base.ply"))

    def test_flags_may_be_repeated(self):
        write_off(self.folder / "scan.off", tetrahedron())
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--quiet", "--quiet")
