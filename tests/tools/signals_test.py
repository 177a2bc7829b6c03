"""Signals end the program with nothing left behind."""

import signal
import subprocess
import time

from meshes import sphere, write_ply
from program import PROGRAM, ProgramTest

SECONDS_TO_START = 0.3
SECONDS_TO_STAGE = 100


class Signals(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.mesh = sphere(250, 500)

    def setUp(self):
        super().setUp()
        write_ply(self.folder / "scan.ply", self.mesh)
        (self.folder / "base.ply").write_text("old", encoding="ascii")

    def start(self, *arguments, **options):
        process = subprocess.Popen(
            [PROGRAM, "simplify", "scan.ply", "-o", "base.ply", "--report", "report.json", *arguments],
            cwd=self.folder,
            stderr=subprocess.DEVNULL,
            **options,
        )
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def expect_end_by(self, process, number):
        self.assertIsNone(process.poll(), "the run ended before the signal")
        process.send_signal(number)
        self.assertEqual(process.wait(timeout=20), -number)
        self.assertEqual(self.files(), ["base.ply", "scan.ply"])
        self.assertEqual((self.folder / "base.ply").read_text(encoding="ascii"), "old")

    def test_end_a_run_while_it_decimates(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(signal=number):
                process = self.start()
                time.sleep(SECONDS_TO_START)
                self.expect_end_by(process, number)

    def test_remove_the_file_that_is_being_verified(self):
        process = self.start("--faces", "240000")
        end = time.monotonic() + SECONDS_TO_STAGE
        while len(self.files()) < 3 and time.monotonic() < end:
            time.sleep(0.001)
        self.expect_end_by(process, signal.SIGINT)

    def test_that_were_ignored_stay_ignored(self):
        process = self.start(
            "--time-limit", "1", "--no-verify", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)
        )
        time.sleep(SECONDS_TO_START)
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(timeout=100), 0)
