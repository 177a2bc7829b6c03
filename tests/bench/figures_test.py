"""Medians, ratios and slopes of figures of which they are known."""

import unittest

from figures import Run, points, ratio, rotated, slope
from made_up import comparison, generated, runs

REPORT = {
    "input": {"faces": 100},
    "output": {"faces": 4},
    "cpu_seconds": {"read": 9.0, "setup": 0.5, "decimate": 1.0, "verify": 9.0, "write": 9.0},
    "seconds": {"read": 9.0, "setup": 1.0, "decimate": 2.0, "verify": 9.0, "write": 9.0},
    "peak_memory_bytes": 7,
}


class RunTest(unittest.TestCase):
    def test_setup_and_decimation_count_and_nothing_else(self):
        self.assertEqual(Run.of_report(REPORT), Run(100, 4, 1.5, 3.0, 7))


class RatioTest(unittest.TestCase):
    def test_it_is_of_runs_of_one_round(self):
        # The second round was ten times as slow for both; medians alone would give 2 / 1 as well, but no spread of 2 to 3.
        measured = comparison(a=runs([2.0, 30.0, 2.0]), b=runs([1.0, 10.0, 1.0]))
        found = ratio(measured, "a", "b", "cpu_seconds")
        self.assertEqual((found.median, found.least, found.most), (2.0, 2.0, 3.0))

    def test_it_is_of_the_figure_that_is_named(self):
        measured = comparison(a=runs([1.0], seconds=[6.0]), b=runs([1.0], seconds=[2.0]))
        self.assertEqual(ratio(measured, "a", "b", "seconds").median, 3.0)

    def test_programs_with_other_numbers_of_rounds_have_none(self):
        with self.assertRaises(ValueError):
            ratio(comparison(a=runs([1.0, 2.0]), b=runs([1.0])), "a", "b", "cpu_seconds")


class MedianTest(unittest.TestCase):
    def test_one_slow_run_does_not_count(self):
        self.assertEqual(comparison(a=runs([1.0, 50.0, 2.0])).median("a", "cpu_seconds"), 2.0)

    def test_of_two_runs_it_lies_between(self):
        self.assertEqual(comparison(a=runs([1.0, 2.0])).median("a", "cpu_seconds"), 1.5)


class SlopeTest(unittest.TestCase):
    def test_powers_have_their_exponent(self):
        for exponent in (0.5, 1, 2):
            pairs = [(size, 3e-6 * size**exponent) for size in (1e4, 2e4, 7e4, 1e6)]
            self.assertAlmostEqual(slope(pairs), exponent)

    def test_it_is_least_squares(self):
        self.assertAlmostEqual(slope([(1, 1), (10, 100), (100, 100)]), 1.0)

    def test_one_size_has_none(self):
        self.assertIsNone(slope([]))
        self.assertIsNone(slope([(10, 1)]))
        self.assertIsNone(slope([(10, 1), (10, 2)]))


class PointsTest(unittest.TestCase):
    def test_they_are_in_the_order_of_size_and_leave_out_who_took_no_part(self):
        comparisons = [generated(300, a=3.0, b=9.0), generated(100, a=1.0)]
        self.assertEqual(points(comparisons, "a"), [(100, 1.0), (300, 3.0)])
        self.assertEqual(points(comparisons, "b"), [(300, 9.0)])


class RotatedTest(unittest.TestCase):
    def test_each_program_is_at_each_place_once(self):
        orders = [rotated(["a", "b", "c"], number) for number in range(3)]
        self.assertEqual(orders, [["a", "b", "c"], ["b", "c", "a"], ["c", "a", "b"]])
        self.assertEqual(rotated(["a", "b", "c"], 3), orders[0])


if __name__ == "__main__":
    unittest.main()
