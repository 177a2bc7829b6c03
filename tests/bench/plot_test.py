"""Where the plot puts what, on figures that are made up."""

import unittest
import xml.etree.ElementTree as ElementTree

import plot

TITLES = plot.Titles("title", "x", "y")
SVG = "{http://www.w3.org/2000/svg}"


def parsed(*series):
    return ElementTree.fromstring(plot.svg(list(series), TITLES))


def texts(picture):
    return [element.text for element in picture.iter(f"{SVG}text")]


class AxisTest(unittest.TestCase):
    def test_equal_factors_are_equal_distances(self):
        axis = plot.Axis(1, 100, 0, 200)
        self.assertEqual([axis.place(value) for value in (1, 10, 100)], [0, 100, 200])

    def test_an_axis_may_go_upwards(self):
        self.assertEqual(plot.Axis(1, 100, 300, 100).place(10), 200)

    def test_long_axes_have_labels_at_powers_of_ten_alone(self):
        labelled = [value for value, has_label, _ in plot.ticks(plot.Axis(1, 1000, 0, 1)) if has_label]
        self.assertEqual(labelled, [1, 10, 100, 1000])

    def test_short_axes_have_labels_between_them(self):
        labelled = [value for value, has_label, _ in plot.ticks(plot.Axis(4, 30, 0, 1)) if has_label]
        self.assertEqual(labelled, [5, 10, 20])


class LabelTest(unittest.TestCase):
    def test_it_is_short(self):
        for value, label in ((0.01, "0.01"), (1, "1"), (20, "20"), (10000, "10k"), (2e6, "2M"), (1.5e6, "1.5M")):
            self.assertEqual(plot.label(value), label)


class SpreadOutTest(unittest.TestCase):
    def test_places_that_are_apart_stay(self):
        self.assertEqual(plot.spread_out([50, 10, 90], 10, 0, 100), [50, 10, 90])

    def test_places_that_are_close_are_moved_apart_in_their_order(self):
        self.assertEqual(plot.spread_out([52, 50, 51], 10, 0, 100), [70, 50, 60])

    def test_they_stay_within_the_frame(self):
        self.assertEqual(plot.spread_out([99, 98], 10, 0, 100), [100, 90])
        self.assertEqual(plot.spread_out([-5, 3], 10, 0, 100), [0, 10])


class SvgTest(unittest.TestCase):
    def test_a_series_is_a_line_with_a_dot_for_each_point(self):
        picture = parsed(plot.Series("a", [(10, 1), (100, 10), (1000, 100)]))
        dots = [element for element in picture.iter(f"{SVG}circle") if element.get("fill") == plot.COLOURS[0]]
        self.assertEqual(len(dots), 3 + 1)  # and one beside the name
        self.assertIn("a", texts(picture))

    def test_points_beside_the_line_are_rings(self):
        picture = parsed(plot.Series("a", [], [(10, 1), (100, 10)]))
        rings = [element for element in picture.iter(f"{SVG}circle") if element.get("fill") == "white"]
        self.assertEqual(len(rings), 2)

    def test_every_point_lies_within_the_frame(self):
        picture = parsed(plot.Series("a", [(10, 1e-4), (1e7, 3e3)]), plot.Series("b", [(10, 5), (1e7, 6)], [(3, 9)]))
        for dot in picture.iter(f"{SVG}circle"):
            self.assertTrue(plot.LEFT <= float(dot.get("cx")) <= plot.WIDTH - plot.RIGHT + 12)
            self.assertTrue(plot.TOP <= float(dot.get("cy")) <= plot.HEIGHT - plot.BOTTOM)

    def test_names_do_not_overlap(self):
        series = [plot.Series(f"name {number}", [(10, 1), (100, 2 + number / 100)]) for number in range(7)]
        heights = sorted(float(e.get("y")) for e in parsed(*series).iter(f"{SVG}text") if e.text.startswith("name"))
        self.assertTrue(all(b - a >= plot.LINE_OF_TEXT - 0.11 for a, b in zip(heights, heights[1:])))

    def test_words_may_hold_any_character(self):
        self.assertIn("a < b & c", texts(parsed(plot.Series("a < b & c", [(1, 1), (2, 2)]))))

    def test_one_point_is_a_plot(self):
        self.assertIn("a", texts(parsed(plot.Series("a", [(10, 1)]))))

    def test_series_without_points_are_left_out(self):
        self.assertNotIn("b", texts(parsed(plot.Series("a", [(10, 1)]), plot.Series("b", []))))
        with self.assertRaises(ValueError):
            plot.svg([plot.Series("b", [])], TITLES)


if __name__ == "__main__":
    unittest.main()
