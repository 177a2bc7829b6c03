"""Comparisons with figures that are made up."""

from figures import Comparison, Run


def runs(cpu_seconds, faces_in=1000, faces_out=10, seconds=None, memory=500_000):
    """One Run for each time."""
    walls = seconds or [2 * time for time in cpu_seconds]
    return [Run(faces_in, faces_out, cpu, wall, memory) for cpu, wall in zip(cpu_seconds, walls, strict=True)]


def comparison(**runs_of_programs):
    return Comparison("scan", 10, runs=runs_of_programs)


def generated(faces_in, **seconds):
    """A generated model of that size, decimated once by each program."""
    taken = {program: runs([time], faces_in) for program, time in seconds.items()}
    return Comparison(f"model {faces_in}", 10, True, taken)
