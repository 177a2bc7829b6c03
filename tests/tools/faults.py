"""Runs the program on files that have a fault, or that only look as if they had one, and measures what it takes."""

import os
import re
import resource
import subprocess
import sys
import threading
import unittest
from dataclasses import dataclass

from encoded_meshes import MEGABYTE, written_base
from program import PROGRAM, SECONDS_FOR_ONE_RUN, ProgramTest

SANITIZED = bool(os.environ.get("FOLDLESS_SANITIZE"))
OUTPUTS = ("base.ply", "report.json", "correspondence.ply")
OLD = b"what was there before"
# More faces than any input here has: the scan is written as its own base mesh.
ALL_FACES = "1000000000"
# scripts/mutate-readers asks for files of one format at a time.
FORMAT = os.environ.get("FOLDLESS_FORMAT", "")
PLACE = r"(line|byte) \d+: "


@dataclass(frozen=True)
class Case:
    """A file with a fault: the exit code, and a pattern that the reason must match, place included."""

    name: str
    file: str
    data: bytes
    code: int
    says: str


@dataclass(frozen=True)
class Measured:
    """What became of a run, and what it took. The peak is at least that of this test itself, from which Linux starts."""

    code: int
    stdout: str
    stderr: str
    cpu_seconds: float
    peak_bytes: int


def measure(arguments, folder, **options):
    """Runs the program to its end. What it prints must fit into a pipe: a file would obey limits on files."""
    redirected = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
    with subprocess.Popen([PROGRAM, *map(os.fsencode, map(str, arguments))], cwd=folder, **redirected) as process:
        watchdog = threading.Timer(SECONDS_FOR_ONE_RUN, process.kill)
        watchdog.start()
        _, status, usage = os.wait4(process.pid, 0)
        watchdog.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        texts = [stream.read().decode("utf-8", "replace") for stream in (process.stdout, process.stderr)]
    seconds = usage.ru_utime + usage.ru_stime
    return Measured(process.returncode, *texts, seconds, usage.ru_maxrss * 1024)


class FaultTest(ProgramTest):
    """A test whose cases are counted; `group` is the name under which they are told at the end."""

    group = ""
    cases = 0

    @classmethod
    def tearDownClass(cls):
        print(f"{cls.group}: {cls.cases} cases", file=sys.stderr)

    def setUp(self):
        super().setUp()
        self.reset_folder()

    def reset_folder(self):
        """Leaves the old outputs in the folder, and nothing else."""
        for path in self.folder.iterdir():
            path.unlink()
        for name in OUTPUTS:
            (self.folder / name).write_bytes(OLD)

    def case(self, **names):
        """A subtest that is counted and has a folder with nothing but the old outputs."""
        type(self).cases += 1
        self.reset_folder()
        return self.subTest(**names)

    def simplify(self, name, *arguments, **options):
        outputs = ["-o", "base.ply", "--report", "report.json", "--correspondence", "correspondence.ply"]
        return measure(["simplify", *outputs, *arguments, "--", name], self.folder, **options)

    def expect_old_outputs(self, *others):
        """Nothing was written, and nothing temporary was left."""
        for name in OUTPUTS:
            self.assertEqual((self.folder / name).read_bytes(), OLD, name)
        self.assertEqual(self.files(), sorted((*OUTPUTS, *others)))

    def expect_modest(self, run, size):
        """Time and memory are bounded by the size of the file, whatever it claims."""
        if SANITIZED:
            return
        self.assertLessEqual(run.cpu_seconds, 2 + size / (100 * MEGABYTE))
        own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
        self.assertLess(own, 64 * MEGABYTE, "run fewer tests at once: nothing smaller than this process can be measured")
        self.assertLessEqual(run.peak_bytes, 20 * size + 64 * MEGABYTE)

    def expect_reason(self, run, code, prefix, says):
        """The run failed with this code, and said why in one line."""
        self.assertEqual(run.code, code, run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertRegex(run.stderr, r"\Afoldless: [^\n]+\n\Z")
        reason = run.stderr.removeprefix(f"foldless: {prefix}: ")
        self.assertNotEqual(reason, run.stderr, f"the line does not start with {prefix!r}")
        self.assertRegex(reason.rstrip(), says)
        self.assertLess(len(run.stderr), 600)

    def expect_refused(self, case):
        """The scan is refused by simplify, as the case says; info agrees."""
        if not case.file.lower().endswith(FORMAT):
            return
        path = self.folder / case.file
        path.write_bytes(case.data)
        run = self.simplify(case.file, "--faces", ALL_FACES)
        self.expect_reason(run, case.code, case.file, case.says)
        if case.code == 3:
            self.assertRegex(run.stderr, PLACE)
        self.expect_old_outputs(case.file)
        self.expect_modest(run, len(case.data))
        info = measure(["info", case.file], self.folder)
        self.assertEqual(info.code, 3 if case.code == 3 else 0, info.stderr)
        if case.code == 3:
            self.assertEqual(info.stderr, run.stderr)

    def expect_accepted(self, file, data, mesh, *others):
        """simplify writes the scan as its own base mesh, each coordinate and each index as it is in `mesh`."""
        if not file.lower().endswith(FORMAT):
            return None
        path = self.folder / file
        if data is not None:
            path.write_bytes(data)
        run = self.simplify(file, "--faces", ALL_FACES)
        self.assertEqual(run.code, 0, run.stderr)
        self.assertEqual(run.stdout, "")
        points, faces = written_base(self.folder / "base.ply")
        self.assertEqual([tuple(map(repr, p)) for p in points], [tuple(map(repr, map(float, p))) for p in mesh[0]])
        self.assertEqual(faces, mesh[1])
        self.assertEqual(self.files(), sorted((*OUTPUTS, file, *others)))
        return run

    def expect_all_refused(self, cases):
        for case in cases:
            with self.case(fault=case.name, file=case.file):
                self.expect_refused(case)


def line_of(data, position):
    """The number of the line that holds this byte, from 1."""
    return data.count(b"\n", 0, position) + 1


def at_line(number, reason):
    return rf"\Aline {number}: {reason}"


def at_byte(number, reason):
    return rf"\Abyte {number}: {reason}"


def literal(text):
    return re.escape(text)
