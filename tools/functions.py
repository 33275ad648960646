#!/usr/bin/env python3
"""Checks that no C++ function is longer than 120 lines. (clang-tidy's readability-function-size says the same, but needs
minutes, since it compiles every file.)

    tools/functions.py [ROOT]   prints every breach and exits 1 if there is one; prints the longest function
"""

import pathlib
import re
import sys

from sources import ROOT, sources, without_comments

MAX_LINES = 120


def functions(text):
    """(first line, last line, head) of every outermost function body. A brace opens a function if what stands between
    it and the statement before has parentheses and is no class, enum or namespace; one that follows a name without a
    space (x{1}) is an initialiser."""
    text = without_comments(text)
    text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: "\n" * m.group().count("\n"), text, flags=re.M)
    line, head, opened = 1, "", []  # of each open brace: "function", "initialiser" or "other"
    for previous, character in zip(" " + text, text):
        line += character == "\n"
        if "function" in opened:
            if character == "{":
                opened.append("other")
            elif character == "}" and opened.pop() == "function":
                yield first, line, " ".join(head.split())
                head = ""
        elif character == "{":
            scope = re.search(r"\b(namespace|class|struct|enum|union)\b[^()]*$", re.sub(r"alignas\([^)]*\)", "", head))
            if not previous.isspace():
                opened.append("initialiser")
            elif "(" in head and not scope:
                first = line - head.lstrip().count("\n")
                opened.append("function")
            else:
                opened.append("other")
                head = ""
        elif character == "}":
            if opened and opened.pop() != "initialiser":
                head = ""
        elif character == ";":
            head = ""
        else:
            head += character


def main():
    root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    found = [(last - first + 1, path.relative_to(root), first, name)
             for path in sources(root) if path.suffix != ".py"
             for first, last, name in functions(path.read_text())]
    breaches = [entry for entry in found if entry[0] > MAX_LINES]
    for lines, path, first, name in breaches:
        print(f"{path}:{first}: {lines} lines, at most {MAX_LINES} are allowed: {name[:80]}")
    if found:
        lines, path, first, _ = max(found)
        print(f"{len(found)} functions, the longest has {lines} lines: {path}:{first}")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
