"""The row of foldless in the table of loaders (scripts/loaders): no malformed file is accepted, no honest one is altered."""

import resource
import unittest

import loader_outcomes
from faults import SANITIZED
from loader_files import LoaderFile, honest_files, malformed_files
from loader_outcomes import ACCEPTED, ALTERED, EXACT, NO_FACES, OUT_OF_RANGE, REFUSED
from program import PROGRAM, ProgramTest

POINTS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
FACES = [(0, 2, 1), (0, 1, 3)]


class Foldless(ProgramTest):
    def expect_of_all(self, expected, files):
        limits = {"bytes_of_addresses": resource.RLIM_INFINITY} if SANITIZED else {}
        loader = loader_outcomes.foldless(PROGRAM, **limits)
        for file in files:
            with self.subTest(file=file.name):
                self.assertEqual(loader_outcomes.outcome(loader, file, self.folder), expected)

    def test_refuses_what_is_malformed(self):
        self.expect_of_all(REFUSED, malformed_files())

    def test_reads_what_is_honest(self):
        self.expect_of_all(EXACT, honest_files())


class Judge(unittest.TestCase):
    """What the outcomes are told apart by."""

    def test_names_and_orders_do_not_matter(self):
        other = [POINTS[i] for i in (3, 2, 1, 0)], [(3, 2, 0), (2, 3, 1)]
        self.assertEqual(loader_outcomes.of_accepted(other, (POINTS, FACES)), EXACT)

    def test_a_face_turned_round_or_missing_or_moved_is_altered(self):
        for mesh in (
            (POINTS, [(0, 1, 2), FACES[1]]),
            (POINTS, FACES[:1]),
            (POINTS, [*FACES, FACES[0]]),
            (POINTS, [*FACES, ()]),
            ([(0.0, 0.0, 5e-324), *POINTS[1:]], FACES),
        ):
            self.assertEqual(loader_outcomes.of_accepted(mesh, (POINTS, FACES)), ALTERED)

    def test_what_is_accepted_of_a_malformed_file_is_named(self):
        self.assertEqual(loader_outcomes.of_accepted((POINTS, FACES), None), ACCEPTED)
        self.assertEqual(loader_outcomes.of_accepted((POINTS, []), None), NO_FACES)
        for corner in (4, -1):
            self.assertEqual(loader_outcomes.of_accepted((POINTS, [(0, 1, corner)]), None), OUT_OF_RANGE)

    def test_a_file_is_right_if_it_is_refused_or_exact(self):
        malformed, honest = LoaderFile("a", "ply", b""), LoaderFile("b", "ply", b"", (POINTS, FACES))
        self.assertTrue(loader_outcomes.is_right(malformed, REFUSED))
        self.assertTrue(loader_outcomes.is_right(honest, EXACT))
        self.assertFalse(loader_outcomes.is_right(honest, REFUSED))
        self.assertFalse(loader_outcomes.is_right(malformed, ACCEPTED))


if __name__ == "__main__":
    unittest.main()
