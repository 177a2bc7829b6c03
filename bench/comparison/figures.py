"""What was measured, and what follows from it: medians, ratios from one round, slopes."""

import dataclasses
import math
import statistics


@dataclasses.dataclass(frozen=True)
class Run:
    """What one run took to set up and decimate, without reading, verifying and writing."""

    faces_in: int
    faces_out: int
    cpu_seconds: float
    seconds: float
    peak_memory_bytes: int  # of the whole process

    @staticmethod
    def of_report(report):
        """From a report of foldless, or the line that a peer prints: it has the same keys."""
        cpu_seconds, seconds = report["cpu_seconds"], report["seconds"]
        return Run(
            report["input"]["faces"],
            report["output"]["faces"],
            cpu_seconds["setup"] + cpu_seconds["decimate"],
            seconds["setup"] + seconds["decimate"],
            report["peak_memory_bytes"],
        )


@dataclasses.dataclass
class Comparison:
    """One scan, decimated to one count by each program in each round."""

    scan: str
    faces_asked: int
    is_generated: bool = False
    runs: dict = dataclasses.field(default_factory=dict)  # by program: one Run for each round
    failures: dict = dataclasses.field(default_factory=dict)  # by program: why there are no runs

    def faces_in(self):
        return next(iter(self.runs.values()))[0].faces_in

    def median(self, program, figure):
        """The median over the rounds of a figure of Run, by its name."""
        return statistics.median(getattr(run, figure) for run in self.runs[program])


@dataclasses.dataclass(frozen=True)
class Spread:
    median: float
    least: float
    most: float

    @staticmethod
    def of(values):
        values = list(values)
        return Spread(statistics.median(values), min(values), max(values))


def ratio(comparison, above, below, figure):
    """Spread over the rounds of a figure of the one program over that of the other, each from the same round: what else
    the machine does then weighs on both alike."""
    pairs = zip(comparison.runs[above], comparison.runs[below], strict=True)
    return Spread.of(getattr(first, figure) / getattr(second, figure) for first, second in pairs)


def points(comparisons, program, figure="cpu_seconds"):
    """(faces in, median of the figure) of each comparison that the program took part in, by size."""
    taken = [comparison for comparison in comparisons if program in comparison.runs]
    return sorted((comparison.faces_in(), comparison.median(program, figure)) for comparison in taken)


def slope(pairs):
    """That of log y over log x, by least squares; None for fewer than two different x. 1: time grows as the size does."""
    if len({x for x, _ in pairs}) < 2:
        return None
    return statistics.linear_regression([math.log(x) for x, _ in pairs], [math.log(y) for _, y in pairs]).slope


def rotated(programs, number):
    """The order of the programs in the round of that number: none is always the first, or behind the same one's heat."""
    start = number % len(programs)
    return programs[start:] + programs[:start]
