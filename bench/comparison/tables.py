"""The figures as markdown."""

from figures import points, ratio, slope

COLUMNS = [
    "scan", "faces in", "program", "faces out", "CPU s", "wall s", "peak bytes per input face", "foldless' CPU time over this",
]  # fmt: skip
SLOPE_COLUMNS = ["program", "models", "slope", "µs per face, smallest", "µs per face, largest"]
SPEED_UP_COLUMNS = ["scan", "threads", "speed-up", "CPU time over that of the first count", "same bytes"]
MICRO = 1e-6


def row_text(cells):
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def head_text(columns, words):
    """The first two lines of a table; the first `words` columns hold words, the others numbers."""
    return row_text(columns) + "\n|" + "---|" * words + "---:|" * (len(columns) - words)


def digits(value):
    """About three significant digits, as a plain number."""
    for least, decimals in ((100, 0), (10, 1), (1, 2), (0.1, 3)):
        if value >= least:
            return f"{value:,.{decimals}f}"
    return f"{value:.4f}"


def spread_text(spread):
    return f"{digits(spread.median)} ({digits(spread.least)}–{digits(spread.most)})"


def faces_out_text(comparison, program):
    """The count, and the one that was asked for if the program went no further before."""
    faces = max(run.faces_out for run in comparison.runs[program])
    return f"{faces:,}" if faces <= comparison.faces_asked else f"{faces:,}, no further"


def program_cells(comparison, program, reference):
    if program in comparison.failures:
        return [program, f"failed: {comparison.failures[program]}", "", "", "", ""]
    bytes_per_face = comparison.median(program, "peak_memory_bytes") / comparison.faces_in()
    own = program == reference
    return [
        program,
        faces_out_text(comparison, program),
        digits(comparison.median(program, "cpu_seconds")),
        digits(comparison.median(program, "seconds")),
        f"{bytes_per_face:,.0f}",
        "" if own else spread_text(ratio(comparison, reference, program, "cpu_seconds")),
    ]


def comparison_rows(comparison, programs, reference):
    """A row for each program; the scan stands in the first."""
    for number, program in enumerate(programs):
        scan = [comparison.scan, f"{comparison.faces_in():,}"] if number == 0 else ["", ""]
        yield row_text(scan + program_cells(comparison, program, reference))


def slope_cells(program, pairs):
    per_face = [digits(y / x / MICRO) for x, y in pairs]
    return [program, len(pairs), f"{slope(pairs):.2f}", per_face[0], per_face[-1]]


def slope_rows(comparisons, programs):
    """A row for each program that decimated generated models of different sizes."""
    generated = [comparison for comparison in comparisons if comparison.is_generated]
    for program in programs:
        pairs = points(generated, program)
        if slope(pairs) is not None:
            yield row_text(slope_cells(program, pairs))


def speed_up_rows(comparison, by_threads, same_bytes):
    """A row for each thread count but the first. `by_threads`: the program of each count."""
    (_, one), *others = by_threads.items()
    for threads, program in others:
        speed_up = ratio(comparison, one, program, "seconds")
        more_work = ratio(comparison, program, one, "cpu_seconds")
        cells = [comparison.scan, threads, spread_text(speed_up), spread_text(more_work), "yes" if same_bytes else "NO"]
        yield row_text(cells)
