"""Files of other projects, odd and broken: refused by name and at once, or read as they are."""

import os
import unittest
from pathlib import Path

import plain_reader
from faults import ALL_FACES, FaultTest, measure

ROOT = Path(__file__).resolve().parents[2]
SCANS = Path(os.environ.get("FOLDLESS_SCANS", ROOT.parent / "shared/models"))
FOLDER = Path(os.environ.get("FOLDLESS_ODD_FILES", SCANS.parent / "corpus"))


class Corpus(FaultTest):
    group = "corpus"

    def each_run(self):
        """The path of each mesh, and what became of it."""
        if not FOLDER.is_dir():
            self.skipTest(f"no folder {FOLDER}")
        for path in sorted(FOLDER.rglob("*")):
            if path.suffix.lower() in plain_reader.READERS:
                with self.case(file=path.name):
                    outputs = ["-o", "base.ply", "--report", "report.json"]
                    yield path, measure(["simplify", path, *outputs, "--faces", ALL_FACES, "--quiet"], self.folder)

    # Before the other test: a process that reads large files itself cannot measure the memory of small ones.
    def test_a_refusal_has_a_reason_and_takes_no_time(self):
        refused = 0
        for path, run in self.each_run():
            if run.code != 0:
                self.assertIn(run.code, (3, 4))
                self.expect_reason(run, run.code, path, r"\A[^\n]+\Z")
                self.expect_old_outputs()
                self.expect_modest(run, path.stat().st_size)
                refused += 1
        self.assertGreater(refused, 0)

    def test_what_is_read_is_each_face_of_the_file_bit_for_bit(self):
        read = 0
        for path, run in self.each_run():
            if run.code == 0:
                wanted = list(map(repr, plain_reader.triangles(path)))
                found = list(map(repr, plain_reader.triangles(self.folder / "base.ply")))
                self.assertTrue(found == wanted, "what was written is not what the file spells")
                read += 1
        self.assertGreater(read, 0)


if __name__ == "__main__":
    unittest.main()
