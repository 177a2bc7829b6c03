"""A plot with two logarithmic axes, as SVG: a line for each series, its name at the end of the line."""

import dataclasses
import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 1020, 600
LEFT, RIGHT, TOP, BOTTOM = 84, 350, 56, 64  # margins; the names stand in the right one
LINE_OF_TEXT = 19
MARGIN = 1.25  # factor between the outermost values and the frame
# Of Okabe and Ito: told apart by colour-blind readers, too. The first is the one to look at.
COLOURS = ["#000000", "#d55e00", "#e69f00", "#0072b2", "#56b4e9", "#009e73", "#cc79a7", "#999999"]
PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k")]
MOST_DECADES_WITH_ALL_LABELS = 1.8


@dataclasses.dataclass(frozen=True)
class Series:
    name: str
    line: list  # (x, y) > 0, by x
    loose: list = dataclasses.field(default_factory=list)  # (x, y) > 0 beside the line

    def points(self):
        return [*self.line, *self.loose]

    def end(self):
        """The point where the name belongs."""
        return self.line[-1] if self.line else max(self.loose)


@dataclasses.dataclass(frozen=True)
class Titles:
    title: str
    x: str
    y: str


@dataclasses.dataclass(frozen=True)
class Axis:
    """Places values between `low` and `high` at the pixels from `start` to `end`."""

    low: float
    high: float
    start: float
    end: float

    @staticmethod
    def around(values, start, end):
        return Axis(min(values) / MARGIN, max(values) * MARGIN, start, end)

    def place(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.start + share * (self.end - self.start)

    def decades(self):
        return math.log10(self.high / self.low)


def ticks(axis):
    """(value, whether it has a label, whether it is a power of ten) of the grid: 1 to 9 times each power of ten."""
    labelled = (1, 2, 5) if axis.decades() < MOST_DECADES_WITH_ALL_LABELS else (1,)
    for power in range(math.floor(math.log10(axis.low)), math.ceil(math.log10(axis.high)) + 1):
        for digit in range(1, 10):
            value = digit * 10.0**power
            if axis.low <= value <= axis.high:
                yield value, digit in labelled, digit == 1


def label(value):
    """3000000 -> "3M", 0.01 -> "0.01"."""
    for size, prefix in PREFIXES:
        if value >= size:
            return f"{value / size:g}{prefix}"
    return f"{value:g}"


def spread_out(places, distance, low, high):
    """Places in the same order that are at least so far apart, as near as is simple to the given ones, within low and
    high if there is room."""
    order = sorted(range(len(places)), key=places.__getitem__)
    moved = list(places)
    lowest = low
    for index in order:
        moved[index] = max(moved[index], lowest)
        lowest = moved[index] + distance
    highest = high
    for index in reversed(order):
        moved[index] = min(moved[index], highest)
        highest = moved[index] - distance
    return moved


def text(x, y, words, **attributes):
    named = "".join(f' {key.replace("_", "-")}="{value}"' for key, value in attributes.items())
    return f'<text x="{x:.1f}" y="{y:.1f}"{named}>{escape(words)}</text>'


def segment(x1, y1, x2, y2, colour, width=1):
    return f'<path d="M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" stroke="{colour}" stroke-width="{width}" fill="none"/>'


def grid(x_axis, y_axis):
    for value, has_label, is_power in ticks(x_axis):
        x = x_axis.place(value)
        yield segment(x, y_axis.start, x, y_axis.end, "#c4c4c4" if is_power else "#ececec")
        if has_label:
            yield text(x, y_axis.start + LINE_OF_TEXT, label(value), text_anchor="middle")
    for value, has_label, is_power in ticks(y_axis):
        y = y_axis.place(value)
        yield segment(x_axis.start, y, x_axis.end, y, "#c4c4c4" if is_power else "#ececec")
        if has_label:
            yield text(x_axis.start - 8, y + 5, label(value), text_anchor="end")


def frame(x_axis, y_axis, titles):
    yield (
        f'<path d="M{x_axis.start:.1f} {y_axis.end:.1f}V{y_axis.start:.1f}H{x_axis.end:.1f}" stroke="#444" fill="none"/>'
    )
    middle = (y_axis.start + y_axis.end) / 2
    yield text(x_axis.start, TOP - 24, titles.title, font_size=17, font_weight="bold")
    yield text((x_axis.start + x_axis.end) / 2, HEIGHT - 16, titles.x, text_anchor="middle")
    yield text(22, middle, titles.y, text_anchor="middle", transform=f"rotate(-90 22 {middle:.1f})")


def curve(series, colour, x_axis, y_axis):
    places = [(x_axis.place(x), y_axis.place(y)) for x, y in series.line]
    if places:
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
        yield f'<path d="M{path}" stroke="{colour}" stroke-width="2.5" stroke-linejoin="round" fill="none"/>'
    for x, y in places:
        yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}"/>'
    for x, y in series.loose:
        ring = f'cx="{x_axis.place(x):.1f}" cy="{y_axis.place(y):.1f}" r="4.5"'
        yield f'<circle {ring} fill="white" stroke="{colour}" stroke-width="2"/>'


def names(all_series, colours, x_axis, y_axis):
    """Each name at the height of the end of its line, or near it; a thin line leads there."""
    ends = [(x_axis.place(series.end()[0]), y_axis.place(series.end()[1])) for series in all_series]
    heights = spread_out([y for _, y in ends], LINE_OF_TEXT, y_axis.end, y_axis.start)
    for series, colour, (x, y), height in zip(all_series, colours, ends, heights, strict=True):
        yield segment(x + 6, y, x_axis.end + 12, height, colour, 0.8)
        yield f'<circle cx="{x_axis.end + 12:.1f}" cy="{height:.1f}" r="4" fill="{colour}"/>'
        yield text(x_axis.end + 22, height + 5, series.name)


def svg(all_series, titles):
    """The whole picture. Series without points are left out."""
    all_series = [series for series in all_series if series.points()]
    if not all_series:
        raise ValueError("there is nothing to plot")
    values = [point for series in all_series for point in series.points()]
    x_axis = Axis.around([x for x, _ in values], LEFT, WIDTH - RIGHT)
    y_axis = Axis.around([y for _, y in values], HEIGHT - BOTTOM, TOP)
    colours = [COLOURS[number % len(COLOURS)] for number in range(len(all_series))]
    parts = [*grid(x_axis, y_axis), *frame(x_axis, y_axis, titles)]
    for series, colour in reversed(list(zip(all_series, colours))):  # the first on top
        parts += curve(series, colour, x_axis, y_axis)
    parts += names(all_series, colours, x_axis, y_axis)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
        'font-family="Helvetica, Arial, DejaVu Sans, sans-serif" font-size="14" fill="#222">\n'
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    )
    return "\n".join([head, *parts, "</svg>\n"])
