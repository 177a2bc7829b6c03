"""Runs a loader of meshes on one file, in a process of its own with limits, and names what became of it.

A loader is a command that takes a file and the name of its output. It ends as foldless does: 0 if it has read the file,
3 or 4 if it refuses it, 7 if memory ran out.
"""

import os
import resource
import signal
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from encoded_meshes import written_base

PROCESSOR_SECONDS = 10
SECONDS = 120  # for a loader that waits
BYTES_OF_ADDRESSES = 4 << 30

REFUSED = "refused"
NO_FACES = "accepted, no faces"
ACCEPTED = "accepted, altered"
OUT_OF_RANGE = "accepted, index out of range"
READ = "read"  # until it is known what was read
EXACT = "exact"
ALTERED = "altered"
CRASHED = "crashed"
HUNG = "hung"
OUT_OF_MEMORY = "out of memory"
OF_MALFORMED = (REFUSED, NO_FACES, ACCEPTED, OUT_OF_RANGE, CRASHED, HUNG, OUT_OF_MEMORY)
OF_HONEST = (EXACT, ALTERED, REFUSED, CRASHED, HUNG, OUT_OF_MEMORY)
# By exit code; all others are crashes.
ENDS = {0: READ, 3: REFUSED, 4: REFUSED, 7: OUT_OF_MEMORY, -signal.SIGXCPU: HUNG}


@dataclass(frozen=True)
class Loader:
    """`command` makes the arguments of a run, `mesh` reads its output: points and faces."""

    name: str
    command: Callable
    mesh: Callable
    bytes_of_addresses: int = BYTES_OF_ADDRESSES  # resource.RLIM_INFINITY for none


def foldless(program, **limits):
    """A scan that has few enough faces already is its own base mesh. Each thread more would take addresses."""

    def command(file, output):
        return [program, "simplify", "--quiet", "--threads", "2", "--faces", "1000000000", "-o", output, file]

    return Loader("foldless", command, written_base, **limits)


def listed_mesh(path):
    """A mesh as the programs of bench/loaders write it. Of one that is too long they write the counts alone."""
    counts, *rows = [line.split() for line in path.read_text(encoding="ascii").splitlines()]
    points, faces = map(int, counts)
    if len(rows) != points + faces:
        return [], [()]  # which is no mesh of any file
    return [tuple(map(float, row)) for row in rows[:points]], [tuple(map(int, row)) for row in rows[points:]]


def peer(name, program):
    return Loader(name, lambda file, output: [*program, file, output], listed_mesh)


def limited(loader):
    """For preexec_fn: bounds addresses and processor time, and keeps no memory of a crash."""

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (loader.bytes_of_addresses, loader.bytes_of_addresses))
        resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    return limit


def ended(loader, command, folder):
    """READ, or the outcome."""
    quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    try:
        run = subprocess.run(command, cwd=folder, timeout=SECONDS, check=False, preexec_fn=limited(loader), **quiet)
    except subprocess.TimeoutExpired:
        return HUNG
    return ENDS.get(run.returncode, CRASHED)


def turned(points, face):
    """The corners of a face, from the least on."""
    corners = [points[corner] for corner in face]
    least = corners.index(min(corners))
    return corners[least:] + corners[:least]


def same(mesh, other):
    """The same faces with the same corners; loaders may number both as they like."""
    return sorted(turned(mesh[0], face) for face in mesh[1]) == sorted(turned(other[0], face) for face in other[1])


def of_accepted(mesh, expected):
    points, faces = mesh
    if any(not 0 <= corner < len(points) for face in faces for corner in face):
        return OUT_OF_RANGE
    if expected is None:
        return ACCEPTED if faces else NO_FACES
    return EXACT if all(faces) and same(mesh, expected) else ALTERED


def outcome(loader, file, folder):
    """What a loader makes of a LoaderFile."""
    output = Path(folder) / "output.ply"
    output.unlink(missing_ok=True)
    path = Path(folder) / f"input.{file.suffix}"
    path.write_bytes(file.data)
    end = ended(loader, [os.fspath(word) for word in loader.command(path, output)], folder)
    path.unlink()
    return of_accepted(loader.mesh(output), file.mesh) if end == READ else end


def is_right(file, found):
    return found == (REFUSED if file.mesh is None else EXACT)
