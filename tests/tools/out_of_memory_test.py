"""Group N: memory that runs out at any moment. Either the run succeeds, or exit code 7, one line, and nothing is written."""

import os
import random
import resource
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from encoded_meshes import encoded, extension, obj, ply_binary, small_mesh, stl_binary
from faults import MEGABYTE, OUTPUTS, SANITIZED, FaultTest, measure
from meshes import hill, sphere
from program import limit
from soak import soak

LEAST_MEGABYTES = 16
MORE_THAN_ENOUGH = 10000
STEPS = 600
LEAST_STEPS = 6
FAILING_CALLS = 2000
SEED = 20240608
TOLD = "foldless: out of memory\n"
NOBODY = 65534


class OutOfMemory(FaultTest):
    def expect_done_or_told(self, run, files):
        """Success with new outputs, or exit code 7 with old ones; True for the latter."""
        self.assertIn(run.code, (0, 7), f"{run.stdout}\n{run.stderr}")
        if run.code == 0:
            self.assertEqual(run.stderr, "")
            return False
        self.assertEqual(run.stderr, TOLD)
        self.assertEqual(run.stdout, "")
        self.expect_old_outputs(*files)
        return True


@unittest.skipIf(SANITIZED, "sanitizers reserve more memory than any limit leaves")
class AddressSpace(OutOfMemory):
    group = "N address space"

    # The scan and the options.
    RUNS = {
        "simplify": ("ply little endian", ["--faces", "38000"]),
        "simplify with one thread": ("ply little endian", ["--faces", "38000", "--threads", "1"]),
        "simplify with many threads": ("ply little endian", ["--faces", "38000", "--threads", "16"]),
        "simplify from text": ("obj", ["--faces", "39000", "--no-verify"]),
        "simplify from stl": ("stl binary", ["--faces", "39000", "--no-verify", "--threads", "3"]),
    }

    def need(self, name, options):
        """The least limit, in megabytes to a quarter of itself, with which the run succeeds."""
        megabytes = LEAST_MEGABYTES
        while self.run_within(name, options, megabytes).code != 0:
            self.assertLess(megabytes, MORE_THAN_ENOUGH)
            megabytes += megabytes // 4
        return megabytes

    def run_within(self, name, options, megabytes):
        bound = limit(resource.RLIMIT_AS, int(megabytes * MEGABYTE))
        return self.simplify(name, "--quiet", *options, preexec_fn=bound)

    def test_that_is_limited_at_any_size_is_told(self):
        mesh = sphere(100, 200)
        for what, (encoding, options) in self.RUNS.items():
            name = f"scan.{extension(encoding)}"
            data = encoded(encoding, mesh).data
            self.reset_folder()
            (self.folder / name).write_bytes(data)
            need = self.need(name, options)
            steps = max(LEAST_STEPS, soak(STEPS) // len(self.RUNS))
            ended = 0
            for step in range(steps):
                megabytes = LEAST_MEGABYTES + (2 * need - LEAST_MEGABYTES) * step / (steps - 1)
                with self.case(run=what, megabytes=megabytes):
                    (self.folder / name).write_bytes(data)
                    ended += self.expect_done_or_told(self.run_within(name, options, megabytes), [name])
            self.assertGreater(ended, 0, "the limits are low enough")
            # How much is enough depends on how many threads come in time to take a share of the work.
            self.assertEqual(self.run_within(name, options, MORE_THAN_ENOUGH).code, 0, "the limits ended the others")

    def test_that_does_not_hold_the_file_is_told(self):
        with self.case(file="large"):
            with open(self.folder / "large.stl", "wb") as file:
                file.write(stl_binary(small_mesh()).data)
                file.truncate(1 << 30)
            run = measure(
                ["simplify", "large.stl", "-o", "base.ply"], self.folder, preexec_fn=limit(resource.RLIMIT_AS, 256 * MEGABYTE)
            )
            self.assertEqual((run.code, run.stderr), (7, TOLD))
            self.expect_old_outputs("large.stl")

    def test_that_does_not_hold_a_thread_is_told(self):
        """The stack of a thread takes 8 MB of address space each."""
        with self.case(threads=1024):
            (self.folder / "scan.ply").write_bytes(ply_binary(sphere(40, 80)).data)
            run = self.simplify(
                "scan.ply",
                "--quiet",
                "--threads",
                "1024",
                "--faces",
                "5000",
                preexec_fn=limit(resource.RLIMIT_AS, 400 * MEGABYTE),
            )
            self.expect_done_or_told(run, ["scan.ply"])

    def test_threads_that_the_system_refuses_are_told(self):
        if os.geteuid() != 0:
            self.skipTest("only root may run the program as a user that has no other processes")
        with self.case(threads="none"):
            (self.folder / "scan.ply").write_bytes(ply_binary(sphere(40, 80)).data)
            self.folder.chmod(0o777)
            for name in OUTPUTS:
                (self.folder / name).chmod(0o666)
            try:
                run = self.simplify(
                    "scan.ply", "--quiet", "--threads", "8", "--faces", "5000", user=NOBODY, preexec_fn=limit(resource.RLIMIT_NPROC, 1)
                )
            except PermissionError:
                self.skipTest("another user may not start the program")
            self.expect_done_or_told(run, ["scan.ply"])


@unittest.skipIf(SANITIZED, "sanitizers have an allocator of their own")
class FailingMalloc(OutOfMemory):
    group = "N failing malloc"

    @classmethod
    def setUpClass(cls):
        compiler = shutil.which("cc") or shutil.which("gcc")
        if compiler is None:
            raise unittest.SkipTest("there is no C compiler")
        cls.build = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.build.cleanup)
        cls.library = Path(cls.build.name) / "failing_malloc.so"
        source = Path(__file__).with_name("failing_malloc.c")
        subprocess.run([compiler, "-shared", "-fPIC", "-O2", "-o", cls.library, source], check=True)

    def environment(self, call, and_all_later):
        later = {"FAILING_MALLOC_AND_ALL_LATER": "1"} if and_all_later else {}
        return os.environ | {"LD_PRELOAD": str(self.library), "FAILING_MALLOC": str(call)} | later

    def calls(self):
        """Nearly all calls at the start, where a run differs from call to call, and some of the many that follow."""
        most = soak(FAILING_CALLS)
        random_calls = random.Random(SEED)
        first = sorted(random_calls.sample(range(1, FAILING_CALLS + 1), most))
        return first + [int(FAILING_CALLS * 1.5 ** random_calls.uniform(0, 16)) for _ in range(most // 2)]

    def commands(self):
        """The command, the files that it reads, and how often it is tried in comparison to the first."""
        points, faces = sphere(10, 20)
        thirds = [tuple(x / 3 for x in point) for point in points], faces
        simplify = [
            "simplify", "--quiet", "-o", "base.ply", "--report", "report.json", "--correspondence", "correspondence.ply"
        ]
        verify = ["verify", "--quiet", "--report", "report.json", "--violations", "correspondence.ply"]
        return {
            "simplify": ([*simplify, "scan.ply"], {"scan.ply": ply_binary((points, faces)).data}),
            "simplify one thread": ([*simplify, "--threads", "1", "scan.obj"], {"scan.obj": obj(thirds).data}),
            "simplify trimmed": (
                [*simplify, "--boundary", "trim", "scan.ply"], {"scan.ply": ply_binary(hill(12), vertex="double").data}
            ),
            "verify": ([*verify, "made.ply", "scan.ply"], {"scan.ply": ply_binary((points, faces)).data, "made.ply": None}),
            "info": (["info", "--json", "scan.stl"], {"scan.stl": stl_binary((points, faces)).data}),
        }

    def prepare(self, files):
        for name, data in files.items():
            (self.folder / name).write_bytes(data if data is not None else self.made)

    def test_at_any_call_is_told(self):
        (self.folder / "scan.ply").write_bytes(ply_binary(sphere(10, 20)).data)
        self.assertEqual(measure(["simplify", "scan.ply", "-o", "made.ply"], self.folder).code, 0)
        self.made = (self.folder / "made.ply").read_bytes()
        shortened = set()
        for name, (command, files) in self.commands().items():
            self.reset_folder()
            for and_all_later in (False, True):
                for call in self.calls():
                    with self.case(command=name, call=call, and_all_later=and_all_later):
                        self.prepare(files)
                        run = measure(command, self.folder, env=self.environment(call, and_all_later))
                        if command[0] == "info" and run.code == 0:
                            continue
                        if self.expect_done_or_told(run, files):
                            shortened.add((name, and_all_later))
        self.assertEqual(len(shortened), 2 * len(self.commands()), "each command ran out of memory at some call")


if __name__ == "__main__":
    unittest.main()
