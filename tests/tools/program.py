"""Runs the program under test, which the environment variable FOLDLESS_PROGRAM names, in a folder of its own."""

import json
import os
import resource
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["FOLDLESS_PROGRAM"]
SECONDS_FOR_ONE_RUN = 200


def limit(kind, amount):
    """For preexec_fn: bounds what the program may use of a resource."""
    return lambda: resource.setrlimit(kind, (amount, amount))


class ProgramTest(unittest.TestCase):
    """A test with an empty folder, `self.folder`, in which the program runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="foldless test ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, *arguments, **options):
        """The finished run, with `stdout` and `stderr` as text unless the options redirect them."""
        redirected = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL} | options
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            text=True,
            timeout=SECONDS_FOR_ONE_RUN,
            check=False,
            **redirected,
        )

    def expect(self, code, *arguments, **options):
        """Runs the program, and fails unless it ends with this exit code."""
        run = self.run_program(*arguments, **options)
        self.assertEqual(run.returncode, code, f"{arguments}\n{run.stdout}\n{run.stderr}")
        return run

    def expect_one_line(self, code, *arguments, **options):
        """As expect, of a failure that is told in one line on standard error; returns the line."""
        run = self.expect(code, *arguments, **options)
        self.assertEqual(run.stdout, "")
        self.assertRegex(run.stderr, r"\Afoldless: [^\n]+\n\Z")
        return run.stderr

    def json_of(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())
