#!/usr/bin/env python3
"""The pages of docs/scenes: what is written by hand above a marker stays, what stands below it is generated.

    tools/scene_pages.py build/release/bin/sudar             exits 1 if a page is missing or not up to date
    tools/scene_pages.py build/release/bin/sudar --write     writes the generated parts, and the overview README.md

Generated are the numbers that a scene must reach, with those that this version reaches, its parameters and its keys.
Where the text by hand speaks of `--set NAME=VALUE …`, that run is made, too. What is found may change with the engine:
the comparison leaves it out. Pictures are drawn by tools/pictures.py.
"""

import argparse
import json
import re
import shlex
import subprocess
import sys

from sources import ROOT, generate

FOLDER = ROOT / "docs" / "scenes"
MARKER = "<!-- below: tools/scene_pages.py -->\n"
EXPECTED = ("", "must be", "is", "at")
COLUMNS = 3  # of the overview


def ask(program, *words):
    """What the program prints as JSON. A run whose checks fail prints it, too."""
    out = subprocess.run([program, *words, "--json"], capture_output=True, text=True)
    if out.returncode not in (0, 1) or not out.stdout:
        raise SystemExit(f"sudar {shlex.join(words)}: {out.stderr}")
    return json.loads(out.stdout)


def number(value):
    return "–" if value is None else re.sub(r"e([+-])0*", lambda m: "e" + m.group(1).strip("+"), f"{value:.4g}")


def table(head, rows):
    cells = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |\n" for row in cells)


def demand(check):
    if check["op"] == "holds":
        return "true"
    within = f" ± {number(check['tolerance'])}" if check["op"] == "=" else ""
    sign = "" if check["op"] == "=" else check["op"] + " "
    return f"{sign}{number(check['limit'])}{within} {check['unit']}".rstrip()


def finding(check):
    if check["op"] == "holds":
        return "true" if check["value"] else "false"
    return number(check["value"]) + ("" if check["pass"] else ": **fails**" if check["pass"] is False else ": not reached")


def checks_of(program, name, options):
    rows = [(c["name"], demand(c), finding(c), number(c["at"]) + " s")
            for c in ask(program, "run", name, *shlex.split(options))["checks"]]
    return f"\n`{' '.join(['sudar run', name, options]).rstrip()}`\n\n" + table(EXPECTED, rows)


def parameters_of(scene):
    rows = []
    for p in scene["parameters"]:
        switch = p["kind"] == "boolean"
        value = ("on" if p["value"] else "off") if switch else number(p["value"])
        low_high = "on, off" if switch else f"{number(p['low'])} … {number(p['high'])}"
        rows.append((f"`{p['name']}`", value, low_high, p["about"]))
    return "\n## Parameters\n\n" + table(("", "default", "range", ""), rows) if rows else ""


def keys_of(scene):
    rows = [(k["key"], k["does"]) for k in scene["keys"]]
    return "\n## Keys\n\n" + table(("key", ""), rows) if rows else ""


def runs_of(by_hand):
    """The options of the runs whose numbers a page shows."""
    return ["", *(" ".join(options.split()) for options in re.findall(r"`(--set\s[^`]*)`", by_hand))]


def page_of(program, scene, by_hand):
    checks = "".join(checks_of(program, scene["name"], options) for options in runs_of(by_hand))
    return by_hand + MARKER + "\n## Numbers\n" + checks + parameters_of(scene) + keys_of(scene)


def stable(page):
    """A page without what the engine found, and without the expectations that themselves depend on the run."""
    def row(match):
        name, limit = match.group(1), match.group(2)
        return f"|{name}|{limit if limit.strip()[0] in '<>t' else ''}|"
    return re.sub(r"^\|([^|\n]*)\|([^|\n]*)\|[^|\n]*\| [0-9.e-]+ s \|$", row, page, flags=re.M)


def overview(scenes):
    groups = {}
    for scene in scenes:
        groups.setdefault(scene["place"].split("/")[0], []).append(scene)
    text = ("# The scenes\n\nEach is one file in `scenarios/`, a test, and a page here. `sudar NAME` opens one in the window,\n"
            "`sudar run NAME` checks its numbers, `sudar render NAME -o picture.png` draws it.\n")
    for group, members in groups.items():
        rows = []
        for i in range(0, len(members), COLUMNS):
            some = members[i:i + COLUMNS] + [None] * (COLUMNS - len(members[i:i + COLUMNS]))
            rows.append([s and f"[![{s['name']}]({s['name']}.png)]({s['name']}.md)" or "" for s in some])
            rows.append([s and f"[{s['place'].split('/')[1]}]({s['name']}.md): {s['about']}" or "" for s in some])
        text += f"\n## {group}\n\n" + table([""] * COLUMNS, rows)
    return text


def complaints_about(program, scene, write):
    page = FOLDER / f"{scene['name']}.md"
    title = f"# {scene['place'].split('/')[1]}\n"
    text = page.read_text() if page.exists() else ""
    if not text.startswith(title) or MARKER not in text or not page.with_suffix(".png").exists():
        return [f"docs/scenes/{page.name}: needs the title {title.strip()!r}, a text, the line {MARKER.strip()}, a picture"]
    new = page_of(program, scene, text.partition(MARKER)[0])
    if write:
        page.write_text(new)
    elif stable(new) != stable(text):
        return [f"docs/scenes/{page.name} is not up to date: run tools/scene_pages.py --write"]
    return []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    scenes = ask(options.program, "list")
    complaints = generate(FOLDER / "README.md", overview(scenes), options.write)
    for scene in scenes:
        complaints += complaints_about(options.program, scene, options.write)
    known = {scene["name"] for scene in scenes} | {"README"}
    complaints += [f"docs/scenes/{p.name}: there is no such scene" for p in FOLDER.iterdir() if p.stem not in known]
    print("\n".join(complaints), end="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
