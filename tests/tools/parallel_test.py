"""Group O: the bytes of a result depend neither on the number of threads nor on the run."""

import unittest

from encoded_meshes import encoded
from faults import FaultTest, measure
from meshes import hill, sphere
from soak import soak

THREADS = (1, 2, 3, 4, 8, 16)
RUNS = 200
# The mesh and the options; without a target a run goes on until every edge is refused.
MODELS = {
    "a closed surface": (lambda: sphere(24, 48), []),
    "a border that is kept": (lambda: hill(24), ["--faces", "300"]),
    "a border that is trimmed": (lambda: hill(20), ["--boundary", "trim"]),
}


class Parallel(FaultTest):
    group = "O parallel"

    def results(self, options, threads):
        """The files that a run writes, and the parts of its reports that tell no times and no threads."""
        simplify = self.simplify("scan.ply", "--quiet", *options, "--threads", str(threads))
        self.assertEqual(simplify.code, 0, simplify.stderr)
        told = self.json_of("report.json")
        verify = measure(
            [
                "verify",
                "base.ply",
                "scan.ply",
                "--report",
                "report.json",
                "--violations",
                "violations.ply",
                "--threads",
                str(threads),
            ],
            self.folder,
        )
        self.assertEqual(verify.code, 0, verify.stderr)
        files = [(self.folder / name).read_bytes() for name in ("base.ply", "correspondence.ply", "violations.ply")]
        parts = [told[key] for key in ("input", "output", "stop_reason", "collapses", "displacement", "certificate")]
        return files, parts, self.json_of("report.json")["certificate"], verify.stderr

    def test_runs_write_the_same_bytes(self):
        for name, (make, options) in MODELS.items():
            data = encoded("ply little endian", make()).data
            first = None
            for threads in THREADS:
                for run in range(soak(RUNS)):
                    with self.case(model=name, threads=threads, run=run):
                        (self.folder / "scan.ply").write_bytes(data)
                        found = self.results(options, threads)
                        first = first or found
                        self.assertEqual(found, first)


if __name__ == "__main__":
    unittest.main()
