"""The rows for figures that are made up."""

import unittest

import tables
from made_up import comparison, generated, runs


class DigitsTest(unittest.TestCase):
    def test_they_are_three_or_so(self):
        for value, digits in ((12345.6, "12,346"), (98.76, "98.8"), (1.234, "1.23"), (0.5, "0.500"), (0.00213, "0.0021")):
            self.assertEqual(tables.digits(value), digits)


class HeadTest(unittest.TestCase):
    def test_numbers_are_on_the_right(self):
        self.assertEqual(tables.head_text(["a", "b", "c"], 1), "| a | b | c |\n|---|---:|---:|")


class ComparisonRowsTest(unittest.TestCase):
    def rows(self, measured, *programs):
        return list(tables.comparison_rows(measured, programs, "foldless"))

    def test_the_scan_stands_in_the_first_row_and_the_ratio_in_the_others(self):
        measured = comparison(foldless=runs([4.0, 6.0]), peer=runs([1.0, 2.0]))
        self.assertEqual(
            self.rows(measured, "foldless", "peer"),
            [
                "| scan | 1,000 | foldless | 10 | 5.00 | 10.0 | 500 |  |",
                "|  |  | peer | 10 | 1.50 | 3.00 | 500 | 3.50 (3.00–4.00) |",
            ],
        )

    def test_a_program_that_stops_early_says_where(self):
        measured = comparison(foldless=runs([4.0]), peer=runs([1.0], faces_out=396))
        self.assertIn("| 396, no further |", self.rows(measured, "foldless", "peer")[1])

    def test_a_program_that_goes_below_the_count_is_as_good(self):
        measured = comparison(foldless=runs([4.0]), peer=runs([1.0], faces_out=9))
        self.assertIn("| 9 |", self.rows(measured, "foldless", "peer")[1])

    def test_a_program_that_fails_says_why(self):
        measured = comparison(foldless=runs([4.0]))
        measured.failures["peer"] = "not done after 5 s"
        row = self.rows(measured, "foldless", "peer")[1]
        self.assertEqual(row, "|  |  | peer | failed: not done after 5 s |  |  |  |  |")

    def test_every_row_has_each_column(self):
        measured = comparison(foldless=runs([4.0]), peer=runs([1.0]))
        measured.failures["other"] = "why"
        for row in self.rows(measured, "foldless", "peer", "other"):
            self.assertEqual(row.count("|"), len(tables.COLUMNS) + 1)


class SlopeRowsTest(unittest.TestCase):
    def test_scans_have_no_part_in_it(self):
        comparisons = [generated(1000, a=0.001), comparison(a=runs([99.0])), generated(4000, a=0.008)]
        self.assertEqual(list(tables.slope_rows(comparisons, ["a"])), ["| a | 2 | 1.50 | 1.00 | 2.00 |"])

    def test_one_size_gives_no_row(self):
        self.assertEqual(list(tables.slope_rows([generated(1000, a=1.0)], ["a"])), [])


class SpeedUpRowsTest(unittest.TestCase):
    def test_it_is_of_wall_time(self):
        measured = comparison(one=runs([4.0], seconds=[4.0]), two=runs([5.0], seconds=[2.5]))
        rows = list(tables.speed_up_rows(measured, {1: "one", 2: "two"}, True))
        self.assertEqual(rows, ["| scan | 2 | 1.60 (1.60–1.60) | 1.25 (1.25–1.25) | yes |"])

    def test_other_bytes_are_told(self):
        measured = comparison(one=runs([4.0]), two=runs([4.0]))
        self.assertIn("| NO |", next(tables.speed_up_rows(measured, {1: "one", 2: "two"}, False)))


if __name__ == "__main__":
    unittest.main()
