"""How many cases a test runs, as tests/soak.h has it."""

import os


def soak(full):
    """A hundredth of `full`, or the share that FOLDLESS_SOAK says: 100 for all. At least one."""
    return max(1, int(full * float(os.environ.get("FOLDLESS_SOAK", "1")) / 100))
