#!/usr/bin/env python3
"""Runs the real command, as a user does: `sudar verify --quick --json --report DIR`, --list, --set and what it refuses.

    tests/verify/command_test.py PROGRAM
"""

import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tempfile

program = sys.argv[1]
KEYS = ["id", "name", "solver", "quantity", "unit", "parameters", "exact", "got", "error", "tolerance", "pass", "seconds"]
failures = []


def expect(true, message):
    if not true:
        failures.append(message)


def run(*arguments):
    return subprocess.run([program, "verify", *arguments], capture_output=True, text=True)


class Page(html.parser.HTMLParser):
    """Where a page leads to, and whether every element is closed."""

    VOID = {"meta", "link", "circle", "line", "rect", "polygon", "polyline", "path"}
    OPTIONAL = {"th", "td", "p"}

    def __init__(self, text):
        super().__init__()
        self.links, self.open = [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.links += [value for name, value in attributes if name == "href"]
        if tag not in self.VOID | self.OPTIONAL:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in self.VOID | self.OPTIONAL:
            expect(self.open and self.open.pop() == tag, f"</{tag}> without its beginning")


def catalogue():
    listed = run("--full", "--list")
    ids = re.findall(r"^(V\w+) ", listed.stdout, re.M)
    expect(listed.returncode == 0, "--list fails")
    expect(len(ids) == len(set(ids)) == 63, f"{len(ids)} cases are listed, not 63")


def results(folder):
    done = run("--quick", "--json", "--report", str(folder))
    entries = json.loads(done.stdout)
    expect(all(list(e) == KEYS for e in entries), "an entry has other keys than documented")
    # Known failures are no failure of the command: exit 1 tells a regression, or a known one that passes.
    expect(done.returncode == 0, f"exit code {done.returncode}: {done.stderr}")
    failed = {e["id"] for e in entries if not e["pass"]}
    if failed:
        one = sorted(failed)[0]
        told = run(one, "--quick")
        expect(told.returncode == 0 and "fails as known" in told.stdout, f"{one}: {told.returncode} {told.stdout}")
        expect(run(one, "--quick", "--strict").returncode == 1, f"{one} --strict is let through")
    expect(run("V07", "--quick", "--strict").returncode == 0, "V07 --strict")


def pages(folder):
    expect((folder / "index.html").exists(), "no index")
    for file in folder.glob("*.html"):
        text = file.read_text()
        page = Page(text)
        expect(not page.open, f"{file.name}: {page.open} stay open")
        expect("nan" not in re.sub(r"[a-z]nan|nan[a-z]", "", text), f"{file.name} draws what is no number")
        for link in page.links:
            expect((folder / link).exists(), f"{file.name} leads to {link}, which is not there")


def laws():
    one = json.loads(run("V07", "--set", "angle=45", "--json").stdout)
    expect({e["parameters"]["angle"] for e in one} == {45}, "--set does not reach the case")
    for bad, why in ((["V99"], "is no case"), (["V07", "--set", "colour=1"], "is no parameter"),
                     (["V07", "--set", "angle=500"], "angle: 500 given, V07 expects 1 … 179.5 °"),
                     (["V07", "--set", "angle=steep"], "a number expected"), (["V07", "--set", "angle"], "NAME=VALUE"),
                     (["V10", "--set", "balls=2.5"], "2.5 given, V10 expects a whole number 2 … 20"),
                     (["--solver", "newton"], "expected: "), (["--quick", "--full"], "exclude each other")):
        refused = run(*bad)
        expect(refused.returncode != 0 and why in refused.stderr, f"{bad}: {refused.returncode} {refused.stderr}")


with tempfile.TemporaryDirectory() as temporary:
    catalogue()
    results(pathlib.Path(temporary) / "report")
    pages(pathlib.Path(temporary) / "report")
    laws()
print("\n".join(failures) or "sudar verify does what it says")
sys.exit(1 if failures else 0)
