#!/usr/bin/env python3
"""Checks that a library needs nothing of another: symbols.py --nm NM CALLER CALLED

Prints each symbol that CALLER leaves undefined and CALLED defines, and each that both define, of which a program that
links both would take one for the other. Exits with 1 if there is any.
"""

import argparse
import subprocess
import sys

# Letters of nm(1). Weak and unique definitions (inline functions, templates) are left out: who needs one has its own.
UNDEFINED = set("Uvw")
STRONG = set("TDBRGSC")


def symbols(nm, library):
    """The names that a library leaves undefined, and those that it alone defines."""
    dynamic = ["--dynamic"] if ".so" in library else []
    command = [nm, "--format=posix", "--extern-only", *dynamic, library]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    entries = [line.split()[:2] for line in lines if line.strip() and not line.endswith(":")]
    undefined = {name for name, letter in entries if letter in UNDEFINED}
    defined = {name for name, letter in entries if letter in STRONG}
    if not defined:
        sys.exit(f"{library}: no symbols found")
    return undefined - defined, defined


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nm", required=True)
    parser.add_argument("caller")
    parser.add_argument("called")
    arguments = parser.parse_args()
    needed, own = symbols(arguments.nm, arguments.caller)
    _, offered = symbols(arguments.nm, arguments.called)
    for name in sorted(needed & offered):
        print(f"{arguments.caller} needs {name} of {arguments.called}")
    for name in sorted(own & offered):
        print(f"{arguments.caller} and {arguments.called} both define {name}")
    sys.exit(1 if (needed | own) & offered else 0)


if __name__ == "__main__":
    main()
