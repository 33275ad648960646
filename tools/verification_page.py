#!/usr/bin/env python3
"""Holds docs/verification.md against a report of all cases: Sudar's row of the table of engines, how many cases pass,
and that exactly the cases that fail are explained.

    sudar verify --full --report DIR; tools/verification_page.py DIR [--write]

Says what differs, and puts the row and the numbers right with --write.
"""

import argparse
import html
import pathlib
import re
import sys

from sources import ROOT

PAGE = ROOT / "docs" / "verification.md"
ENGINE = "**Sudar, impulse_2007, 60/4**"


def cells(row):
    return [html.unescape(cell) for cell in re.findall(r"<t[dh][^>]*>([^<]*)", row)]


def row_of_sudar(index):
    return "| " + " | ".join([ENGINE] + cells(re.search(r'<tr class="ours">(.*)</tr>', index).group(1))[1:]) + " |"


def verdicts(index):
    """Whether each case passes, by its number."""
    found = re.findall(r'<a href="(\w+)\.html">.*<td class="(good|bad)">', index)
    return {number: kind == "good" for number, kind in found}


def counts(passed):
    catalogue = [number for number in passed if number[0] == "V"]
    right = [number for number in catalogue if passed[number]]
    geometry = {"V37", "V38", "V39", "V40"}
    return (f"{len(right)} of {len(catalogue)} cases pass, {len(set(right) - geometry)} of the "
            f"{len(set(catalogue) - geometry)} that have a solver; {len(catalogue) - len(right)} fail.")


def compare(page, index):
    """The page as it should be, and what it does not explain or explains in vain."""
    passed = verdicts(index)
    page = re.sub(r"^\| " + re.escape(ENGINE) + r" \|.*$", lambda m: row_of_sudar(index), page, flags=re.M)
    page = re.sub(r"^\d+ of \d+ cases pass, [^.]*\.", lambda m: counts(passed), page, flags=re.M)
    explained = set(re.findall(r"^\| ([VBE]\d+b?) [^|]*\|", page, flags=re.M))
    failed = {number for number, right in passed.items() if not right}
    return page, ([f"{number} fails and is not explained" for number in sorted(failed - explained)] +
                  [f"{number} is explained and passes" for number in sorted(explained - failed)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("report", type=pathlib.Path, help="folder that `sudar verify --full --report` wrote")
    parser.add_argument("--write", action="store_true", help="put the page right")
    options = parser.parse_args()
    before = PAGE.read_text()
    after, differences = compare(before, (options.report / "index.html").read_text())
    if options.write:
        PAGE.write_text(after)
    elif after != before:
        differences.append("docs/verification.md: row or numbers differ; --write puts them right")
    print("\n".join(differences) or "docs/verification.md agrees")
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main())
