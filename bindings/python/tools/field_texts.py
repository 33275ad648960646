#!/usr/bin/env python3
"""Writes the comments beside the fields of definitions.h, and beside the shapes of shape.h, as a C++ table: the texts that
Python shows as docstrings. One place for each text.

    field_texts.py OUTPUT DEFINITIONS.H SHAPE.H
"""

import json
import pathlib
import re
import sys


def definitions(text):
    """(definition, field, text): the field is empty for the definition's own comment, which stands above it or behind
    its opening brace."""
    above, name = [], None
    for line in text.splitlines():
        head = re.match(r"struct (\w+) \{(?:\s*// (.*))?$", line)
        if head:
            name = head[1]
            yield name, "", head[2] or " ".join(above)
        elif line == "};":
            name = None
        comment = re.match(r"// (.*)", line)
        above = above + [comment[1]] if comment else []
        if not name:
            continue
        # "Real stiffness = 0, damping = 0;  // text" declares two.
        code, _, comment = line.partition("//")
        declared = re.match(r"  (?:const )?[\w:]+(?:<[\w:]+>)? (\w.*);\s*$", code)
        if declared:
            plain = re.sub(r"\{[^}]*\}|\([^)]*\)", "", declared[1])
            for field in plain.split(","):
                yield name, re.match(r"\s*(\w+)", field)[1], comment.strip()


def shapes(text):
    """("Shape", function, text) of every maker of shapes. The extruded outline has a name of its own in Python."""
    for name, arguments, comment in re.findall(r"^Shape (\w+)\((.*)\);[ \t]*(?:// (.*))?$", text, re.M):
        yield "Shape", "extrude" if name == "prism" and "span" in arguments else name, comment


def main():
    output, header, shape = map(pathlib.Path, sys.argv[1:])
    rows = [*definitions(header.read_text()), *shapes(shape.read_text())]
    lines = [f"    {{{', '.join(json.dumps(cell, ensure_ascii=False) for cell in row)}}}," for row in rows if row[2]]
    output.write_text("// Written by bindings/python/tools/field_texts.py.\n#include \"definition.h\"\n\n"
                      "namespace sudar::python {\n\nstd::span<const FieldText> field_texts() {\n"
                      "  static constexpr FieldText texts[] = {\n" + "\n".join(lines) + "\n  };\n  return texts;\n}\n\n}\n")


if __name__ == "__main__":
    main()
