#!/usr/bin/env python3
"""Checks the order of the layers in a source tree: layers.py ROOT

Prints each breach as `file:line: what` and exits with 1 if there is any. A layer includes only itself and the layers
below it, by <foldless/LAYER/x.h>. Every source file on disk is named in the CMakeLists.txt of its layer, since what is
not listed is not built and not checked. No two headers define a type of the same name, since decimate and verify do not
see each other and yet meet in one program, where the linker would take either's functions for both.
"""

import re
import sys
from pathlib import Path

# Each layer and what it may include besides itself. decimate and verify know nothing of each other: the one is the
# independent judge of the other. Neither knows of repair, which happens only when it is asked for.
MAY_INCLUDE = {
    "predicates": set(),
    "io": {"predicates"},
    "images": {"predicates", "io"},
    "decimate": {"predicates", "io"},
    "verify": {"predicates", "io"},
    "repair": {"predicates", "io"},
    "bake": {"predicates", "io", "images", "decimate", "verify"},
    "report": {"predicates", "io", "decimate", "verify", "repair", "images", "bake"},
    "tools": {"predicates", "io", "decimate", "verify", "repair", "images", "bake", "report"},
    "models": {"predicates", "io"},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]*)[>"]')

NAMESPACE = re.compile(r"^namespace ([\w:]+) \{")
TYPE = re.compile(r"^(?:struct|class|enum class|enum|union) (\w+)\b(?!<)[^;]*$")


def breach_of_include(layer, bracket, path):
    """What is wrong with including `path` in `layer`, or None."""
    if bracket == '"':
        return f'"{path}" is not included as <foldless/LAYER/x.h>'
    if not path.startswith("foldless/"):
        return None
    if ".." in path:
        return f"<{path}> leaves its layer by `..`"
    included = path.split("/")[1]
    if included not in MAY_INCLUDE:
        return f"<{path}> is of no known layer"
    if included != layer and included not in MAY_INCLUDE[layer]:
        return f"{layer} includes <{path}>, but {included} is not below {layer}"
    return None


def breaches_of_file(layer, file):
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        breach = match and breach_of_include(layer, match[1], match[2])
        if breach:
            yield f"{file}:{number}: {breach}"


def breaches_of_layer(layer, folder):
    cmake_lists = folder / "CMakeLists.txt"
    if not cmake_lists.is_file():
        yield f"{cmake_lists}:1: is missing"
        return
    listed = set(re.findall(r"[\w./-]+", cmake_lists.read_text(encoding="utf-8")))
    for file in sorted(folder.rglob("*")):
        if file.suffix not in {".h", ".cpp"}:
            continue
        if file.relative_to(folder).as_posix() not in listed:
            yield f"{file}:1: is not listed in {cmake_lists}"
        yield from breaches_of_file(layer, file)


def types_of_header(header):
    """Each type that a header defines outside classes, with its namespace and line."""
    namespace = ""
    for number, line in enumerate(header.read_text(encoding="utf-8").splitlines(), 1):
        if match := NAMESPACE.match(line):
            namespace = match[1]
        elif match := TYPE.match(line):
            yield f"{namespace}::{match[1]}", number


def types_defined_twice(root):
    first = {}
    for layer in MAY_INCLUDE:
        for header in sorted((root / layer).rglob("*.h")):
            for name, number in types_of_header(header):
                if name in first:
                    yield f"{header}:{number}: {name} is defined in {first[name]} too"
                first.setdefault(name, header)


def breaches(root):
    for layer in MAY_INCLUDE:
        yield from breaches_of_layer(layer, root / layer)
    yield from types_defined_twice(root)


def main(arguments):
    if len(arguments) != 2:
        sys.exit(__doc__)
    found = list(breaches(Path(arguments[1])))
    print("\n".join(found) if found else "the layers keep their order")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv)
