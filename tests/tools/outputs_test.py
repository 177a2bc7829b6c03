"""Outputs that cannot be written (5) and memory that runs out (7)."""

import os
import resource
import unittest

from meshes import sphere, write_ply
from program import ProgramTest, limit

MEGABYTE = 1 << 20


class UnwritableOutputs(ProgramTest):
    def setUp(self):
        super().setUp()
        write_ply(self.folder / "scan.ply", sphere(12, 24))

    def refused(self, *arguments, **options):
        before = self.files()
        line = self.expect_one_line(5, "simplify", "scan.ply", "--quiet", *arguments, **options)
        self.assertEqual(self.files(), before)
        return line

    def test_a_folder_that_does_not_exist_is_named(self):
        self.assertIn("none", self.refused("-o", "none/base.ply"))
        self.assertIn("none", self.refused("-o", "base.ply", "--report", "none/report.json"))
        self.assertIn("none", self.refused("-o", "base.ply", "--correspondence", "none/c.ply"))

    def test_a_folder_is_not_replaced(self):
        (self.folder / "base.ply").mkdir()
        self.refused("-o", "base.ply")
        self.refused("-o", "other.ply", "--report", "base.ply")

    def test_a_device_is_not_replaced(self):
        self.refused("-o", "base.ply", "--report", "/dev/full")

    def test_a_folder_is_refused_before_the_scan_is_read(self):
        self.assertIn("none/", self.expect_one_line(5, "simplify", "missing.ply", "-o", "none/base.ply"))

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_without_permission_is_refused(self):
        (self.folder / "locked").mkdir(mode=0o555)
        self.refused("-o", "locked/base.ply")

    def test_a_full_disk_leaves_the_old_output(self):
        (self.folder / "base.ply").write_text("old", encoding="ascii")
        self.refused("-o", "base.ply", "--faces", "400", preexec_fn=limit(resource.RLIMIT_FSIZE, 1000))
        self.assertEqual((self.folder / "base.ply").read_text(encoding="ascii"), "old")

    def test_a_report_of_verify_that_cannot_be_written_is_a_failure(self):
        self.expect(0, "simplify", "scan.ply", "-o", "base.ply", "--quiet")
        self.expect_one_line(5, "verify", "base.ply", "scan.ply", "--report", "none/report.json")


@unittest.skipIf(os.environ.get("FOLDLESS_SANITIZE"), "sanitizers reserve more memory than any limit leaves")
class Memory(ProgramTest):
    def test_running_out_is_told_and_leaves_nothing(self):
        write_ply(self.folder / "scan.ply", sphere(150, 300))
        codes = set()
        for megabytes in (40, 60, 80, 120, 160, 240):
            with self.subTest(megabytes=megabytes):
                bound = limit(resource.RLIMIT_AS, megabytes * MEGABYTE)
                run = self.run_program(
                    "simplify", "scan.ply", "-o", "base.ply", "--time-limit", "1", "--threads", "1", "--quiet", preexec_fn=bound
                )
                self.assertIn(run.returncode, (0, 7), run.stderr)
                codes.add(run.returncode)
                if run.returncode == 7:
                    self.assertEqual(run.stderr, "foldless: out of memory\n")
                    self.assertEqual(self.files(), ["scan.ply"])
                (self.folder / "base.ply").unlink(missing_ok=True)
        self.assertIn(7, codes)
