#!/usr/bin/env python3
"""Draws the pictures of the pages in docs/ again: those under which stands the command that drew them.

    tools/pictures.py build/release/bin/sudar [docs/PAGE.md …]      all pages, or some

    ![what it shows](folder/picture.png)
    *`sudar render SCENE …`*
"""

import argparse
import pathlib
import re
import shlex
import subprocess

from sources import ROOT

PICTURE = re.compile(r"^!\[[^\]]*\]\(([^)]+\.png)\)\s*\*?`sudar (render [^`]+)`", flags=re.M)


def pictures(page):
    """[(file, words of the command)]"""
    return [(page.parent / name, shlex.split(command)) for name, command in PICTURE.findall(page.read_text())]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("pages", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    for page in options.pages or sorted((ROOT / "docs").rglob("*.md")):
        for file, words in pictures(page):
            file.parent.mkdir(exist_ok=True)
            subprocess.run([options.program, *words, "-o", file], check=True)


if __name__ == "__main__":
    main()
