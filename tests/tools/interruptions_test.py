"""Group M: signals at any moment, disks that are full, folders that may not be written, two runs with one output.

An output is what it was, or what an undisturbed run writes, and nothing in between.
"""

import os
import random
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from encoded_meshes import encoded, extension
from faults import OLD, OUTPUTS, PROGRAM, FaultTest, measure
from meshes import sphere
from program import limit
from soak import soak

MOMENTS = 50
SEED = 20240607
NOBODY = 65534
MOST_SECONDS = 60

# How a run is made to spend its time in one phase: the encoding of the scan, its size, and the options.
PHASES = {
    "read": ("obj", (160, 320), ["--faces", "1000000000", "--no-verify"]),
    "decimate": ("ply little endian", (40, 80), []),
    "verify and write": ("ply little endian", (120, 240), ["--faces", "50000"]),
}
ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE, signal.SIGKILL)
# A temporary file that is left by kill -9, which no program can answer.
TEMPORARY = ".foldless-"


def scan_file(phase):
    return f"scan.{extension(PHASES[phase][0])}"


class Interruption(FaultTest):
    """Runs that differ from an undisturbed one in one thing only."""

    group = "M"

    def write_scan(self, phase):
        encoding, size, _ = PHASES[phase]
        (self.folder / scan_file(phase)).write_bytes(encoded(encoding, sphere(*size)).data)

    def arguments(self, phase):
        return [
            "simplify",
            scan_file(phase),
            "-o",
            "base.ply",
            "--correspondence",
            "correspondence.ply",
            "--quiet",
            *PHASES[phase][2],
        ]

    def undisturbed(self, phase):
        """What a run writes when nothing happens, and how long it takes; the report is left out, for it has times."""
        start = time.monotonic()
        run = measure(self.arguments(phase), self.folder)
        seconds = time.monotonic() - start
        self.assertEqual(run.code, 0, run.stderr)
        return {name: (self.folder / name).read_bytes() for name in ("base.ply", "correspondence.ply")}, seconds

    def reset_outputs(self):
        for name in OUTPUTS:
            (self.folder / name).write_bytes(OLD)

    def expect_old_or_new(self, new):
        for name, data in new.items():
            found = (self.folder / name).read_bytes()
            self.assertIn(found, (OLD, data), f"{name} is neither what it was nor what it shall be")
        self.assertEqual((self.folder / "report.json").read_bytes(), OLD)


def ignores(process, number):
    """Whether a process ignores a signal: SIGPIPE as soon as main() begins."""
    (mask,) = re.findall(r"^SigIgn:\s*(\w+)$", Path(f"/proc/{process}/status").read_text(encoding="ascii"), re.MULTILINE)
    return bool(int(mask, 16) >> (number - 1) & 1)


class Signals(Interruption):
    group = "M signals"

    def interrupt(self, phase, number, seconds):
        """Sends the signal after so many seconds; the exit code, and whether the program ignored that signal by then."""
        with subprocess.Popen([PROGRAM, *self.arguments(phase)], cwd=self.folder, stderr=subprocess.PIPE) as process:
            time.sleep(seconds)
            is_ignored = ignores(process.pid, number)
            process.send_signal(number)
            _, text = process.communicate(timeout=MOST_SECONDS)
        self.assertEqual(text, b"", "a signal has no message")
        return process.returncode, is_ignored

    def expect_after(self, phase, number, code, new):
        self.assertIn(code, (0, -number))
        self.expect_old_or_new(new)
        if code == 0:
            for name, data in new.items():
                self.assertEqual((self.folder / name).read_bytes(), data)
        strays = set(self.files()) - {*OUTPUTS, scan_file(phase)}
        if number == signal.SIGKILL:
            strays = {name for name in strays if not name.startswith(TEMPORARY)}
        self.assertEqual(strays, set())

    def test_at_any_moment_leave_old_or_new_outputs(self):
        ended = ignored = 0
        for phase in PHASES:
            self.reset_folder()
            self.write_scan(phase)
            new, seconds = self.undisturbed(phase)
            for number in ENDING:
                moments = random.Random(f"{SEED} {phase} {int(number)}")
                for _ in range(soak(MOMENTS)):
                    moment = moments.uniform(0, seconds)
                    self.reset_outputs()
                    type(self).cases += 1
                    with self.subTest(phase=phase, signal=number.name, moment=moment):
                        code, is_ignored = self.interrupt(phase, number, moment)
                        ended += code != 0
                        ignored += is_ignored
                        self.assertFalse(is_ignored and code != 0)
                        self.expect_after(phase, number, code, new)
                    for name in set(self.files()) - {*OUTPUTS, scan_file(phase)}:
                        (self.folder / name).unlink()
        self.assertGreater(ended, 0, "some runs were still going on")
        self.assertGreater(ignored, 0, "a pipe that is not used is none of our business")

    def test_find_files_of_killed_runs_no_obstacle(self):
        """Names of temporary files hold the number of the process, which comes again: one that is taken is passed over."""
        self.write_scan("decimate")
        new, _ = self.undisturbed("decimate")
        with self.case(files="taken"):
            self.write_scan("decimate")
            taken = f'for i in 0 1 2 3 4 5 6 7 8 9; do echo taken > ".foldless-$$-$i.ply"; done; exec "$@"'
            command = ["sh", "-c", taken, "sh", PROGRAM, *self.arguments("decimate")]
            subprocess.run(command, cwd=self.folder, check=True)
            for name, data in new.items():
                self.assertEqual((self.folder / name).read_bytes(), data)
            left = [name for name in self.files() if name.startswith(TEMPORARY)]
            self.assertEqual(len(left), 10)
            for name in left:
                self.assertEqual((self.folder / name).read_bytes(), b"taken\n")


class Disks(Interruption):
    group = "M disks and folders"

    def reset_folder(self):
        super().reset_folder()
        (self.folder / "scan.ply").write_bytes(encoded("ply little endian", sphere(24, 48)).data)

    def refused(self, *arguments, says="", **options):
        """Exit code 5 in one line, and every file as it was."""
        before = {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}
        names = self.files()
        run = measure(["simplify", "scan.ply", "--quiet", *arguments], self.folder, **options)
        self.assertEqual(run.code, 5, run.stderr)
        self.assertRegex(run.stderr, r"\Afoldless: [^\n]+: cannot be (written|replaced): [^\n]+\n\Z")
        self.assertIn(says, run.stderr)
        self.assertEqual(self.files(), names)
        for name, data in before.items():
            self.assertEqual((self.folder / name).read_bytes(), data, name)

    def outputs(self):
        return ["-o", "base.ply", "--correspondence", "correspondence.ply", "--report", "report.json"]

    def test_a_limit_on_files_at_any_size_leaves_the_old_outputs(self):
        base = ["-o", "base.ply"]
        for arguments in (
            base, [*base, "--report", "report.json"], [*base, "--correspondence", "correspondence.ply"], self.outputs()
        ):
            with self.case(arguments=arguments):
                self.reset_outputs()
                run = measure(["simplify", "scan.ply", "--quiet", *arguments], self.folder)
                self.assertEqual(run.code, 0, run.stderr)
                # Not the report: it holds times, and is not of the same size in each run.
                sized = [self.folder / name for name in arguments if name.endswith(".ply")]
                largest = max(path.stat().st_size for path in sized)
            sizes = {0, 1, 511, 512, 4095, 4096, largest // 4, largest // 2, largest - 1}
            for size in sorted(size for size in sizes if size < largest):
                with self.subTest(arguments=arguments, size=size):
                    type(self).cases += 1
                    self.reset_outputs()
                    self.refused(*arguments, says="File too large", preexec_fn=limit(resource.RLIMIT_FSIZE, size))

    def test_a_full_disk_leaves_the_old_outputs(self):
        """A file system of some pages, in a name space of its own; what is written to it ends at any page."""
        for pages in (1, 2, 3, 4, 8, 12, 16, 32):
            with self.case(pages=pages):
                script = (
                    f"mount -t tmpfs -o size={4 * pages}k none full && printf old > full/base.ply && "
                    '"$@" 2> told; echo $? > code; cat full/base.ply > found; ls -A full > names'
                )
                (self.folder / "full").mkdir()
                command = ["unshare", "--mount", "--map-root-user", "sh", "-c", script, "sh"]
                command += [PROGRAM, "simplify", "scan.ply", "-o", "full/base.ply", "--quiet", "--faces", "2208"]
                finished = subprocess.run(command, cwd=self.folder, capture_output=True, check=False)
                (self.folder / "full").rmdir()
                if not (self.folder / "names").exists():
                    self.skipTest(f"no file system can be mounted here: {finished.stderr}")
                code = int((self.folder / "code").read_text(encoding="ascii"))
                told = (self.folder / "told").read_text(encoding="utf-8")
                self.assertEqual((self.folder / "names").read_text(encoding="ascii"), "base.ply\n")
                if pages == 32:
                    self.assertEqual(code, 0, told)
                    continue
                self.assertEqual(code, 5, told)
                self.assertRegex(told, r"\Afoldless: [^\n]*full/base.ply: cannot be written: No space left on device\n\Z")
                self.assertEqual((self.folder / "found").read_bytes(), b"old")

    def test_a_device_or_a_pipe_is_not_replaced(self):
        for device in ("full", "null", "zero"):
            for option in ("--output", "--report", "--correspondence"):
                with self.case(device=device, option=option):
                    name = {"--report": "link.json"}.get(option, "link.ply")
                    (self.folder / name).symlink_to(f"/dev/{device}")
                    others = [] if option == "--output" else ["-o", "base.ply"]
                    self.refused(*others, option, name, says="is not a regular file")
                    (self.folder / name).unlink()
        with self.case(device="pipe"):
            os.mkfifo(self.folder / "pipe.ply")
            self.refused("-o", "pipe.ply", says="is not a regular file")

    def test_a_folder_is_not_replaced_and_has_to_be_there(self):
        for name, says in (
            ("folder.ply", "is a folder"),
            ("none/base.ply", "No such file"),
            ("base.ply/base.ply", "Not a directory"),
            ("n" * 300 + ".ply", "File name too long"),
        ):
            for option in ("--output", "--report", "--correspondence"):
                with self.case(name=name[:20], option=option):
                    (self.folder / "folder.ply").mkdir()
                    others = [] if option == "--output" else ["-o", "other.ply"]
                    self.refused(*others, option, name, says=says)
                    (self.folder / "folder.ply").rmdir()
        with self.case(name="a link that leads round"):
            (self.folder / "loop.ply").symlink_to("loop.ply")
            self.refused("-o", "loop.ply", says="Too many levels")

    def test_a_folder_that_may_not_be_written(self):
        """Permissions do not bind root: the run is another user's, if that one may start the program."""
        user = {}
        if os.geteuid() == 0:
            user = {"user": NOBODY}
            try:
                subprocess.run([PROGRAM, "--version"], check=True, capture_output=True, **user)
            except (PermissionError, subprocess.CalledProcessError):
                self.skipTest("root may write everywhere, and another user may not start the program")
        for option in ("--output", "--report", "--correspondence"):
            with self.case(folder="locked", option=option):
                (self.folder / "locked").mkdir(mode=0o555)
                (self.folder / "open").mkdir()
                (self.folder / "open").chmod(0o777)
                self.folder.chmod(0o755)
                others = [] if option == "--output" else ["-o", "open/base.ply"]
                self.refused(*others, option, "locked/base.ply", says="Permission denied", **user)
                self.assertEqual(os.listdir(self.folder / "open"), [])
                (self.folder / "open").rmdir()
                (self.folder / "locked").rmdir()
        with self.case(folder="open", file="locked"):
            self.folder.chmod(0o777)
            (self.folder / "base.ply").chmod(0o444)
            self.refused("-o", "base.ply", says="Permission denied", **user)

    def test_the_scan_is_never_the_output(self):
        for arguments in (
            ["-o", "scan.ply"],
            ["-o", "./scan.ply"],
            ["-o", "link.ply"],
            ["-o", "hard.ply"],
            ["-o", "b.ply", "--report", "scan.ply"],
        ):
            with self.case(arguments=arguments):
                data = (self.folder / "scan.ply").read_bytes()
                (self.folder / "link.ply").symlink_to("scan.ply")
                os.link(self.folder / "scan.ply", self.folder / "hard.ply")
                names = self.files()
                run = measure(["simplify", "scan.ply", *arguments], self.folder)
                self.assertEqual(run.code, 2)
                self.assertRegex(run.stderr, r"\Afoldless: --\w+ would overwrite the scan scan.ply\n\Z")
                self.assertEqual(self.files(), names)
                self.assertEqual((self.folder / "scan.ply").read_bytes(), data)

    def test_a_link_as_output_stays_and_its_file_is_replaced(self):
        with self.case(link="to a file"):
            (self.folder / "folder").mkdir()
            (self.folder / "folder" / "real.ply").write_bytes(OLD)
            (self.folder / "link.ply").symlink_to("folder/real.ply")
            run = measure(["simplify", "scan.ply", "-o", "link.ply", "--quiet"], self.folder)
            self.assertEqual(run.code, 0, run.stderr)
            self.assertTrue((self.folder / "link.ply").is_symlink())
            self.assertTrue((self.folder / "folder" / "real.ply").read_bytes().startswith(b"ply\n"))
            self.assertEqual(os.listdir(self.folder / "folder"), ["real.ply"])
            shutil.rmtree(self.folder / "folder")

    def test_standard_streams_that_are_closed_lose_nothing(self):
        expected = None
        for streams in ((), (0,), (1,), (2,), (0, 1), (1, 2), (0, 2), (0, 1, 2)):
            with self.case(closed=streams):
                command = "".join(f"exec {stream}>&-; " for stream in streams) + 'exec "$@"'
                finished = subprocess.run(
                    ["sh", "-c", command, "sh", PROGRAM, "simplify", "scan.ply", *self.outputs()],
                    cwd=self.folder, check=False, capture_output=True,
                )  # fmt: skip
                self.assertEqual(finished.returncode, 0, finished.stderr)
                found = (self.folder / "base.ply").read_bytes()
                expected = expected or found
                self.assertEqual(found, expected)


class TwoRuns(Interruption):
    group = "M two runs with one output"

    def commands(self):
        return [[*self.arguments("decimate"), "--faces", faces] for faces in ("5000", "4000")]

    def test_leave_the_whole_result_of_one_of_them(self):
        self.write_scan("decimate")
        results = []
        for command in self.commands():
            self.assertEqual(measure(command, self.folder).code, 0)
            results.append([(self.folder / name).read_bytes() for name in ("base.ply", "correspondence.ply")])
        self.assertNotEqual(results[0][0], results[1][0])
        for round_number in range(soak(300)):
            type(self).cases += 1
            with self.subTest(round=round_number):
                self.reset_outputs()
                runs = [subprocess.Popen([PROGRAM, *command], cwd=self.folder) for command in self.commands()]
                self.assertEqual([run.wait(timeout=MOST_SECONDS) for run in runs], [0, 0])
                # Each file is whole; which run renamed it last may differ from file to file.
                for i, name in enumerate(("base.ply", "correspondence.ply")):
                    self.assertIn((self.folder / name).read_bytes(), [result[i] for result in results])
                self.assertEqual(self.files(), sorted((*OUTPUTS, "scan.ply")))


if __name__ == "__main__":
    unittest.main()
