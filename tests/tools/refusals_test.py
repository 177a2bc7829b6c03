"""Inputs that cannot be read (3) or used (4): one line, and nothing is written."""

import os
import unittest

from meshes import sphere, tetrahedron, write_off
from program import ProgramTest

CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]


class Refusals(ProgramTest):
    def refused(self, code, name):
        before = self.files()
        line = self.expect_one_line(
            code, "simplify", name, "-o", "base.ply", "--report", "report.json", "--correspondence", "c.ply"
        )
        self.assertIn(name, line)
        self.assertEqual(self.files(), before, "nothing is written")
        return line

    def refused_mesh(self, points, faces):
        write_off(self.folder / "bad.off", (points, faces))
        return self.refused(4, "bad.off")

    def test_a_missing_file_cannot_be_read(self):
        self.refused(3, "none.ply")

    def test_a_folder_cannot_be_read(self):
        (self.folder / "folder.ply").mkdir()
        self.refused(3, "folder.ply")

    def test_a_pipe_cannot_be_read(self):
        os.mkfifo(self.folder / "pipe.ply")
        self.refused(3, "pipe.ply")

    def test_an_unknown_type_cannot_be_read(self):
        (self.folder / "scan.xyz").write_text("0 0 0\n", encoding="ascii")
        self.refused(3, "scan.xyz")

    def test_an_empty_file_cannot_be_read(self):
        (self.folder / "empty.ply").touch()
        self.refused(3, "empty.ply")

    @unittest.skipIf(os.geteuid() == 0, "root may read every file")
    def test_a_file_without_permission_cannot_be_read(self):
        write_off(self.folder / "secret.off", tetrahedron())
        (self.folder / "secret.off").chmod(0)
        self.refused(3, "secret.off")

    def test_a_word_for_a_number_is_named_with_its_line(self):
        (self.folder / "bad.off").write_text("OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", encoding="ascii")
        line = self.refused(3, "bad.off")
        self.assertIn("4", line)
        self.assertIn("zero", line)

    def test_an_index_out_of_range_cannot_be_read(self):
        write_off(self.folder / "bad.off", (CORNERS[:3], [(0, 1, 3)]))
        self.refused(3, "bad.off")

    def test_a_truncated_file_cannot_be_read(self):
        write_off(self.folder / "bad.off", tetrahedron())
        text = (self.folder / "bad.off").read_text(encoding="ascii")
        (self.folder / "bad.off").write_text(text[:-8], encoding="ascii")
        self.refused(3, "bad.off")

    def test_coordinates_are_finite(self):
        self.assertIn("1 ", self.refused_mesh([(0, 0, float("nan")), *CORNERS[1:3]], [(0, 1, 2)]))

    def test_faces_name_three_vertices(self):
        self.refused_mesh(CORNERS[:3], [(0, 1, 1)])

    def test_faces_have_an_area(self):
        self.refused_mesh([(0, 0, 0), (1, 1, 1), (2, 2, 2)], [(0, 1, 2)])

    def test_edges_have_at_most_two_faces(self):
        self.refused_mesh(CORNERS, [(0, 1, 2), (1, 0, 3), (0, 1, 4)])

    def test_faces_at_an_edge_agree_in_orientation(self):
        self.refused_mesh(CORNERS[:4], [(0, 1, 2), (0, 1, 3)])

    def test_vertices_have_one_fan(self):
        points = [*CORNERS[:3], (-1, 0, 0), (0, -1, 0)]
        self.refused_mesh(points, [(0, 1, 2), (0, 3, 4)])

    def test_a_mesh_has_faces(self):
        self.refused_mesh(CORNERS, [])

    def test_each_defect_is_counted(self):
        points, faces = sphere(6, 8)
        line = self.refused_mesh(points, [*faces, (1, 1, 2), (3, 3, 4)])
        self.assertIn("2 ", line)

    def test_an_output_that_was_there_is_untouched(self):
        (self.folder / "base.ply").write_text("old", encoding="ascii")
        self.refused_mesh(CORNERS, [])
        self.assertEqual((self.folder / "base.ply").read_text(encoding="ascii"), "old")
