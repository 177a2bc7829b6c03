"""Runs foldless, the generator and the peers."""

import dataclasses
import hashlib
import json
import subprocess
import sys
from pathlib import Path

from figures import Run

# The name in the table, and the program of bench/peers.
PEERS = {
    "CGAL, edge length": "cgal_edge_length",
    "CGAL, Lindstrom-Turk": "cgal_lindstrom_turk",
    "OpenMesh, quadrics": "openmesh_quadric",
    "OpenMesh, quadrics + Hausdorff 1 %": "openmesh_quadric_hausdorff",
    "meshoptimizer": "meshoptimizer",
}


class Failure(Exception):
    """A run without a result; the text says why."""


def build_peers(sources, build):
    """The peers that can be built here: the program of each name. What building says goes to standard error."""
    configure = ["cmake", "-S", sources, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
    for command in (configure, ["cmake", "--build", build]):
        subprocess.run(command, stdout=sys.stderr, check=True)
    built = (build / "built.txt").read_text(encoding="ascii").split()
    return {name: build / program for name, program in PEERS.items() if program in built}


def install_foldless(build, prefix):
    """The program as its users have it: installed from this build. What installing says goes to standard error."""
    subprocess.run(["cmake", "--install", build, "--prefix", prefix], stdout=sys.stderr, check=True)
    return prefix / "bin/foldless"


def last_line(words):
    lines = words.strip().splitlines()
    return lines[-1] if lines else "no message"


def finished(timeout, *command):
    """The process, which has ended with code 0. Raises Failure for another end."""
    words = [str(word) for word in command]
    print("compare:", *words, file=sys.stderr, flush=True)
    try:
        process = subprocess.run(
            words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=timeout, check=False
        )
    except subprocess.TimeoutExpired:
        raise Failure(f"not done after {timeout:g} s") from None
    if process.returncode != 0:
        # The row names the scan already, and where it lies is nobody's concern.
        reason = last_line(process.stderr)
        for word in words:
            reason = reason.replace(word, Path(word).name) if "/" in word else reason
        raise Failure(f"exit code {process.returncode}: {reason.removeprefix('foldless: ')}")
    return process


@dataclasses.dataclass
class Peer:
    program: Path
    folder: Path  # for its result, which nobody reads
    timeout: float

    def run(self, scan, faces):
        output = self.folder / f"{self.program.name}.ply"
        return Run.of_report(json.loads(finished(self.timeout, self.program, scan, output, faces).stdout))


@dataclasses.dataclass
class Foldless:
    """Keeps the distinct outputs of each scan, to be verified when the clock no longer runs."""

    program: Path
    folder: Path
    timeout: float
    outputs: dict = dataclasses.field(default_factory=dict)  # by scan: the output of each hash

    def simplify(self, scan, output, *options):
        report = self.folder / "report.json"
        words = ["simplify", scan, "-o", output, "--no-verify", "--quiet", "--report", report]
        finished(self.timeout, self.program, *words, *options)
        return Run.of_report(json.loads(report.read_text(encoding="utf-8")))

    def faces_reached(self, scan, faces):
        """The count down to which the scan goes, or the nearest to `faces` that is at most that."""
        options = [] if faces is None else ["--faces", faces]
        return self.simplify(scan, self.folder / "first.ply", *options).faces_out

    def run(self, scan, faces, threads):
        output = self.folder / "base.ply"
        run = self.simplify(scan, output, "--faces", faces, "--threads", threads)
        digest = hashlib.sha256(output.read_bytes()).hexdigest()
        output.rename(self.folder / f"{digest}.ply")
        self.outputs.setdefault(scan, {})[digest] = self.folder / f"{digest}.ply"
        return run

    def same_bytes(self, scan):
        return len(self.outputs[scan]) == 1

    def verify(self, scan):
        """Raises Failure unless each output is certified."""
        for output in self.outputs[scan].values():
            finished(self.timeout, self.program, "verify", output, scan, "--quiet")
