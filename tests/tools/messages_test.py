"""What messages look like: they name the program and the files, and stay one line each."""

from meshes import hill, tetrahedron, write_off
from program import ProgramTest


class Messages(ProgramTest):
    def test_every_line_of_an_error_names_the_program(self):
        write_off(self.folder / "bad.off", ([(0, 0, 0)], []))
        for arguments in (["info", "none.ply"], ["simplify", "bad.off", "-o", "b.ply"], ["simplify"]):
            with self.subTest(arguments=arguments):
                self.assertTrue(self.run_program(*arguments).stderr.startswith("foldless: "))

    def test_control_characters_in_names_do_not_break_lines(self):
        name = "two\nlines\x1b[31m.off"
        write_off(self.folder / name, tetrahedron())
        text = self.expect(0, "simplify", name, "-o", "base.ply").stderr
        self.assertIn("two?lines?[31m.off", text)
        self.assertNotIn("\x1b", text)
        self.assertIn("two?lines?", self.expect(0, "info", name).stdout)
        self.expect_one_line(3, "info", "no\nsuch.ply")

    def test_control_characters_in_arguments_are_not_printed(self):
        text = self.expect_one_line(2, "info", "a.ply", "--no\x7f\x1b[31m")
        self.assertIn("--no??[31m", text)

    def test_a_report_holds_a_name_as_it_is(self):
        name = 'a "quoted"\nname.off'
        write_off(self.folder / name, tetrahedron())
        self.expect(0, "simplify", name, "-o", "base.ply", "--report", "report.json")
        self.assertEqual(self.json_of("report.json")["input"]["path"], name)

    def test_a_border_is_told(self):
        write_off(self.folder / "hill.off", hill(4))
        text = self.expect(0, "simplify", "hill.off", "-o", "base.ply").stderr
        self.assertIn("1 boundary loop with 16 edges", text)
