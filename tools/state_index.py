#!/usr/bin/env python3
"""Generates docs/state.md: every array of the state, with its type, unit, and the stage of the step that writes it.

    tools/state_index.py --write   writes docs/state.md
    tools/state_index.py           exits 1 if docs/state.md is not up to date or a field is not described

The source is src/*/fields.def, which also generates the arrays, saving, loading and hashing.
"""

import re
import sys

from sources import ROOT, generate

LINE = re.compile(r'^(\w*FIELD)\(([\w:]+), (\w+), "([^"]*)", "([^"]*)"\)(?: *// (.*))?$')
TITLES = {"FIELD": "Bodies", "SHAPE_FIELD": "Shapes of bodies", "JOINT_FIELD": "Joints", "CONTACT_FIELD": "Touching pairs"}

HEAD = """# The state of a world

What decides every later bit is state: it is saved, loaded and hashed. All else is a function of it, and rebuilt. The
arrays below lie by slot (`src/base/slots.h`); a stage named *operation* is a change by the user, the others are stages of
the step (`src/world/stages.h`). Written by `tools/state_index.py --write` from `src/*/fields.def`.
"""

TAIL = """
## Besides the arrays

In this order in a snapshot (`src/world/snapshot.cc`): the settings; bodies; their shapes; the names of the bodies; the materials
set for pairs; joints, with their definitions; forces; touching pairs; sensors, with their memories; the table of pairs
(`src/collision/narrow/pairs.h`: manifolds, cached axes); the fat boxes that decide which pairs exist; the clock. Geometry
stands before all of these: it is stored once by content, and is not hashed.

Snapshots, recordings and saved runs begin with a version and with a number that follows from the names and types of all
these fields (`src/base/file_header.h`): a file of another layout is refused, and the message says so.
"""


def fields(root):
    """{macro: [(name, type, unit, stage, meaning)]} of every fields.def, and the complaints."""
    found, complaints = {}, []
    for path in sorted(root.glob("src/*/fields.def")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if not re.match(r"\w*FIELD\(", line):
                continue
            match = LINE.match(line)
            if match is None or not match[6]:
                complaints.append(f"{path.relative_to(root).as_posix()}:{number}: not FIELD(type, name, unit, stage) // meaning")
                continue
            macro, kind, name, unit, stage, meaning = match.groups()
            found.setdefault(macro, []).append((name, kind.removeprefix("std::").removesuffix("_t"), unit, stage, meaning))
    return found, complaints


def page(found):
    lines = [HEAD]
    for macro, rows in found.items():
        lines += [f"## {TITLES[macro]}", "", "| field | type | unit | written by | |", "|---|---|---|---|---|"]
        lines += ["| " + " | ".join((f"`{name}`", kind, unit if unit != "1" else "", stage, meaning)) + " |"
                  for name, kind, unit, stage, meaning in rows] + [""]
    return "\n".join(lines).rstrip() + "\n" + TAIL


def main():
    found, complaints = fields(ROOT)
    complaints += generate(ROOT / "docs" / "state.md", page(found), write=sys.argv[1:] == ["--write"])
    print("\n".join(complaints), end="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
