"""Standard output and standard error that are closed, full, or read by nobody."""

import os
import signal
import subprocess

from meshes import sphere, tetrahedron, write_off, write_ply
from program import PROGRAM, ProgramTest


def close(*streams):
    def closer():
        for stream in streams:
            os.close(stream)

    return closer


class Streams(ProgramTest):
    def setUp(self):
        super().setUp()
        write_off(self.folder / "scan.off", tetrahedron())

    def test_a_result_that_cannot_be_written_is_a_failure(self):
        for arguments in (["info", "scan.off", "--json"], ["info", "scan.off"], ["--help"], ["--version"]):
            with self.subTest(arguments=arguments):
                with open("/dev/full", "w", encoding="ascii") as full:
                    run = self.run_program(*arguments, stdout=full)
                self.assertEqual(run.returncode, 5)
                self.assertIn("standard output", run.stderr)
                run = self.run_program(*arguments, preexec_fn=close(1))
                self.assertEqual(run.returncode, 5)

    def test_messages_that_cannot_be_written_lose_nothing(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            self.expect(0, "simplify", "scan.off", "-o", "a.ply", stderr=full)
        self.expect(0, "simplify", "scan.off", "-o", "b.ply", preexec_fn=close(2))
        self.expect(0, "simplify", "scan.off", "-o", "c.ply", preexec_fn=close(0, 1, 2))
        contents = {(self.folder / name).read_bytes() for name in ("a.ply", "b.ply", "c.ply")}
        self.assertEqual(len(contents), 1, "no message ended up in an output")

    def test_messages_that_nobody_reads_lose_nothing(self):
        reader, writer = os.pipe()
        os.close(reader)
        self.expect(0, "simplify", "scan.off", "-o", "base.ply", stderr=writer)
        os.close(writer)
        self.assertIn("base.ply", self.files())

    def test_a_result_that_nobody_reads_ends_the_program_as_it_ends_others(self):
        reader, writer = os.pipe()
        os.close(reader)
        run = self.run_program("info", "scan.off", "--json", stdout=writer)
        os.close(writer)
        self.assertEqual(run.returncode, -signal.SIGPIPE)
        self.assertEqual(run.stderr, "")


class Terminal(ProgramTest):
    def text_on_terminal(self, *arguments):
        """What the program writes to standard error when that is a terminal."""
        master, terminal = os.openpty()
        process = subprocess.Popen(
            [PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=terminal
        )
        os.close(terminal)
        text = b""
        try:
            while chunk := os.read(master, 4096):
                text += chunk
        except OSError:
            pass  # Linux reports the end of a terminal as an error
        os.close(master)
        self.assertEqual(process.wait(), 0)
        return text.decode("utf-8")

    def test_a_progress_bar_shows_on_a_terminal_alone(self):
        write_ply(self.folder / "scan.ply", sphere(40, 80))
        arguments = ("simplify", "scan.ply", "-o", "base.ply")
        text = self.text_on_terminal(*arguments)
        self.assertIn("decimating [", text)
        self.assertIn("verifying [", text)
        self.assertIn("\x1b[K", text)
        self.assertNotIn("decimating [", self.expect(0, *arguments).stderr)
        self.assertEqual(self.text_on_terminal(*arguments, "--quiet"), "")
