#!/usr/bin/env python3
"""Draws what bench_broad_phase measured: docs/broad_phase.csv → docs/pictures/broad_phase_*.svg, a picture a plot.

    tools/broad_phase_plot.py [CSV [FOLDER]]
"""

import csv
import math
import pathlib
import sys

from sources import ROOT

WIDTH, HEIGHT = 640, 400
LEFT, RIGHT, TOP, BOTTOM = 64, 128, 16, 48  # margins
COLOURS = {"brute": "#888888", "grid": "#1b9e77", "sweep": "#d95f02", "kinetic_sweep": "#7570b3", "tree": "#111111"}
# Plot → (column of the abscissa, its label).
PLOTS = {
    "n": ("n", "number of proxies n"),
    "lattice": ("n", "number of proxies n, in a lattice"),
    "spread": ("spread", "largest size / smallest (n = 10,000)"),
    "moving": ("moving", "share that moves (n = 31,623)"),
}


class Logarithmic:
    """An axis: values to pixels, and a tick at every power of ten."""

    def __init__(self, values, first, last):
        self.low, self.high = math.floor(math.log10(min(values)) + 1e-9), math.ceil(math.log10(max(values)) - 1e-9)
        self.first, self.last = first, last

    def __call__(self, value):
        return self.first + (self.last - self.first) * (math.log10(value) - self.low) / (self.high - self.low)

    def ticks(self):
        return range(self.low, self.high + 1)


def power(exponent):
    if -1 <= exponent <= 3:
        return f"{10.0 ** exponent:g}"
    return "10" + "".join("⁻" if c == "-" else "⁰¹²³⁴⁵⁶⁷⁸⁹"[int(c)] for c in str(exponent))


def text(x, y, words, anchor="middle", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{extra}>{words}</text>'


def draw(rows, column, label):
    """The picture of one plot: µs per update against a column, a line a kind."""
    x = Logarithmic([float(r[column]) for r in rows], LEFT, WIDTH - RIGHT)
    y = Logarithmic([float(r["update_us"]) for r in rows], HEIGHT - BOTTOM, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="sans-serif" font-size="13">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for t in x.ticks():
        at = x(10.0 ** t)
        out.append(f'<path d="M{at:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>')
        out.append(text(at, HEIGHT - BOTTOM + 18, power(t)))
    for t in y.ticks():
        at = y(10.0 ** t)
        out.append(f'<path d="M{LEFT} {at:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>')
        out.append(text(LEFT - 6, at + 4, power(t), "end"))
    middle = (TOP + HEIGHT - BOTTOM) / 2
    out.append(text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10, label))
    out.append(text(18, middle, "µs per update", extra=f' transform="rotate(-90 18 {middle})"'))
    ends = []  # of the lines: where their names stand
    for kind, colour in COLOURS.items():
        points = [(x(float(r[column])), y(float(r["update_us"]))) for r in rows if r["broad"] == kind]
        if not points:
            continue
        path = " ".join(f"{px:.1f},{py:.1f}" for px, py in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out.extend(f'<circle cx="{px:.1f}" cy="{py:.1f}" r="3" fill="{colour}"/>' for px, py in points)
        ends.append((points[-1][1], kind, colour))
    lowest = -math.inf
    for height, kind, colour in sorted(ends):
        lowest = max(height, lowest + 15)
        out.append(text(WIDTH - RIGHT + 10, lowest + 4, kind, "start", f' fill="{colour}"'))
    return "\n".join(out) + "\n</svg>\n"


def main():
    source = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "broad_phase.csv"
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "docs" / "pictures"
    with source.open() as file:
        rows = list(csv.DictReader(file))
    for plot, (column, label) in PLOTS.items():
        picture = draw([r for r in rows if r["plot"] == plot], column, label)
        (folder / f"broad_phase_{plot}.svg").write_text(picture)


if __name__ == "__main__":
    main()
