#!/usr/bin/env python3
"""Checks that the engine is a line: a file includes only files above it in its folder's CMake list, files of folders
further left, and public headers that rank no higher than its folder. io/ stands on the public headers alone. Also: no include circles anywhere, no file over
1000 lines, no file in src/ that no list names, and nothing in src/ from outside the C++ library.

    tools/layers.py [ROOT]      prints every breach, exits 1 if there is one; prints the median file length of src/
"""

import pathlib
import re
import statistics
import sys

from sources import ROOT, layers, sources

# The public headers in order, each with the folder it ranks with.
PUBLIC = {"version.h": "base", "base.h": "base", "math.h": "math", "shape.h": "geometry", "solids.h": "geometry",
          "definitions.h": "geometry", "profile.h": "geometry", "distance.h": "collision", "world.h": "world",
          "layout.h": "world", "record.h": "world", "difference.h": "world", "batch.h": "world", "scenario.h": "scenario", "session.h": "scenario",
          "io.h": "io"}
MAX_LINES = 1000
# Headers that belong to the compiler, not to a library: the floating-point control state and the vector types.
COMPILER_HEADERS = {"xmmintrin.h", "immintrin.h"}


def includes(path):
    """(line number, "<" or '"', what) of every include."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if match:
            yield number, match.group(1), match.group(2)


def check_order(root, line, breaches):
    """The rules for src/ and include/."""
    rank = {folder: i for i, folder in enumerate([folder for folder, _ in line] + ["io"])}
    position = {name: i for i, name in enumerate(name for _, names in line for name in names)}
    public = list(PUBLIC)

    for path in sorted((root / "include" / "sudar").glob("*.h")):
        if path.name not in PUBLIC:
            breaches.append(f"{path.relative_to(root)}: public header without a rank in tools/layers.py")
            continue
        for number, kind, what in includes(path):
            name = what.removeprefix("sudar/")
            if kind == '"' or ("/" in what and name not in PUBLIC):
                breaches.append(f"include/sudar/{path.name}:{number}: a public header includes only public ones: {what}")
            elif name in PUBLIC and public.index(name) >= public.index(path.name):
                breaches.append(f"include/sudar/{path.name}:{number}: includes upward: {what}")

    for path in sources(root, ("src",)):
        name = path.relative_to(root / "src").as_posix()
        if name not in position:
            breaches.append(f"src/{name}: no sudar_folder() lists it")
            continue
        for number, kind, what in includes(path):
            where = f"src/{name}:{number}"
            if what.startswith("sudar/"):
                if what[6:] not in PUBLIC:
                    breaches.append(f"{where}: no such public header: {what}")
                elif rank[PUBLIC[what[6:]]] > rank[name.split("/")[0]]:
                    breaches.append(f"{where}: includes upward: {what} ranks with {PUBLIC[what[6:]]}")
            elif kind == '"' and what not in position:
                breaches.append(f"{where}: not a listed file of the engine: {what}")
            elif kind == '"' and position[what] >= position[name]:
                breaches.append(f"{where}: includes upward: {what}")
            elif kind == "<" and ("/" in what or what.endswith(".h")) and what not in COMPILER_HEADERS:
                breaches.append(f"{where}: not of the C++ library: {what}")
    for name in position:
        if not (root / "src" / name).exists():
            breaches.append(f"src/{name}: listed, but does not exist")


def check_io(root, breaches):
    """io/ includes its own files by their path from the root, public headers, and libraries."""
    for path in sources(root, ("io",)):
        for number, kind, what in includes(path):
            where = f"{path.relative_to(root)}:{number}"
            if kind == '"' and not (what.startswith("io/") and (root / what).is_file()):
                breaches.append(f"{where}: not a file of io/: {what}")
            elif what.startswith("sudar/") and what[6:] not in PUBLIC:
                breaches.append(f"{where}: no such public header: {what}")


def check_circles(root, breaches):
    """Follows includes in every folder; a file met again while it is still open closes a circle."""
    bases = [root / "include", root / "src", root / "app", root / "scenarios", root / "tests", root]
    graph = {}
    for path in sources(root):
        targets = []
        for _, _, what in includes(path):
            for base in [path.parent, *bases]:
                if (base / what).is_file():
                    targets.append((base / what).resolve())
                    break
        graph[path.resolve()] = targets

    done, trail = set(), []

    def visit(path):
        if path in trail:
            circle = [p.relative_to(root.resolve()).as_posix() for p in trail[trail.index(path):]]
            breaches.append("include circle: " + " → ".join([*circle, circle[0]]))
        elif path not in done:
            trail.append(path)
            for target in graph.get(path, []):
                visit(target)
            trail.pop()
            done.add(path)

    for path in graph:
        visit(path)


def check(root):
    """All breaches, as lines of text."""
    breaches = []
    check_order(root, layers(root), breaches)
    check_io(root, breaches)
    check_circles(root, breaches)
    for path in sources(root):
        lines = len(path.read_text().splitlines())
        if lines > MAX_LINES:
            breaches.append(f"{path.relative_to(root)}: {lines} lines, at most {MAX_LINES} are allowed")
    return breaches


def main():
    root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    breaches = check(root)
    print("\n".join(breaches), end="\n" if breaches else "")
    lengths = [len(path.read_text().splitlines()) for path in sources(root, ("src",))]
    if lengths:
        print(f"src/: {len(lengths)} files, {sum(lengths)} lines, median {statistics.median(lengths):g}, "
              f"longest {max(lengths)}")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
