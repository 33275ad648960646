#!/usr/bin/env python3
"""Generates docs/thesis.md: where each section, equation and figure of the thesis lives in the code.

    tools/thesis_index.py --write   writes docs/thesis.md
    tools/thesis_index.py           exits 1 if docs/thesis.md is not up to date or an anchor is wrong

An anchor is the word "thesis" and references, anywhere in a source file: thesis (3.16), (3.18) · thesis §3.4 ·
thesis fig. 9 · thesis table 1 · in a test: thesis erratum drag. The thesis numbers only its figures; sections and
equations are numbered here in their order.
"""

import re
import sys

from sources import ROOT, generate, sources

TITLE = "М. Тинтор, „Развој графичког импулсног симулатора динамике крутих тела“, дипломски рад, Београд 2007"

# Sections with what they hold: (reference, what it is).
CONTENTS = [
    ("§1", "Introduction"),
    ("§2", "Survey of methods"),
    ("§3", "The proposed solution"),
    ("§3.1", "State of a rigid body"),
    ("(3.1)", "orientation as a quaternion: Ω = (d sin(α/2), cos(α/2))"),
    ("§3.2", "Integration"),
    ("(3.2)", "ẋ(t+Δt) = ẋ(t) + ẍ(t) Δt"),
    ("(3.3)", "x(t+Δt) = x(t) + ẋ(t+Δt) Δt: symplectic Euler"),
    ("§3.3", "The main loop: six steps"),
    ("(3.4)", "Δt = k/f, divided into n sub-steps"),
    ("§3.4", "External forces"),
    ("(3.5)", "gravity: F = m g"),
    ("(3.6)", "drag: F = −A v − B v²"),
    ("§3.5", "Collisions with friction"),
    ("(3.7)", "Δv_cm = p / m"),
    ("(3.8)", "Δω = I⁻¹ (r × p)"),
    ("(3.9)", "r = x_contact − x"),
    ("(3.10)", "Δv = Δv_cm + Δω × r = K_a p"),
    ("(3.11)", "K_a = E/m − r̃ I⁻¹ r̃"),
    ("(3.12)", "Δu = Δv_a − Δv_b = K p"),
    ("(3.13)", "K = K_a + K_b"),
    ("(3.14)", "p = K⁻¹ Δu"),
    ("(3.15)", "bodies collide if u·n < 0"),
    ("(3.16)", "static friction: p = K⁻¹ (−e u_n n − u), if |p_t| ≤ μ_s p_n"),
    ("(3.17)", "dynamic friction: p = p_n (n − μ_d t)"),
    ("(3.18)", "p_n = −(1+e) u_n / (n·K (n − μ_d t))"),
    ("§3.6", "Iterative processing of collisions and contacts"),
    ("(3.19)", "restitution of contacts rises from −1 in the first pass to 0 in the last"),
    ("§3.7", "Correction of positions"),
    ("(3.20)", "Δu_e = (b/Δt) max(0, δ − δ_max)"),
    ("(3.21)", "x_new = x_old + (v_real + v_bias) Δt"),
    ("§3.8", "Joints"),
    ("(3.22)", "bar: Δu = −u_n n"),
    ("(3.23)", "ball joint: Δu = −u"),
    ("(3.24)", "hinge: two ball joints on the common axis"),
    ("§3.9", "Detection of collisions and contacts"),
    ("(3.25)", "broad phase by brute force"),
    ("(3.26)", "broad phase by spatial hashing"),
    ("(3.27)", "broad phase by sweep and prune"),
    ("(3.28)", "narrow phase: bounding spheres first"),
    ("(3.29)", "narrow phase: separating axes (face normals, edge × edge)"),
    ("(3.30)", "contact: point, line segment or polygon"),
    ("§4", "Implementation"),
    ("table 1", "Size of the prototype"),
    ("§5", "Examples of simulations"),
    ("§6", "Conclusion and future work"),
    ("§A", "Appendix: mass properties of polyhedra"),
    ("(A.1)", "V_i = a·(b × c) / 6"),
    ("(A.2)", "X_i = (a + b + c) / 4"),
    ("(A.3)", "V = Σ V_i"),
    ("(A.4)", "X V = Σ X_i V_i"),
    ("(A.5)", "inertia from the covariance of tetrahedra"),
    ("fig. 1", "the main loop"),
    ("fig. 2", "collision of two bodies"),
    ("fig. 3", "ball joints and hinges"),
    ("fig. 4", "one step of the separating-axis test"),
    ("fig. 5", "classes of the core"),
    ("fig. 6", "sticks that slip where friction is small"),
    ("fig. 7", "a wall broken by a ball"),
    ("fig. 8", "a net that catches falling cubes"),
    ("fig. 9", "towers of 10, 15 and 25 cubes"),
    ("fig. 10", "a vehicle on terrain with obstacles"),
    ("fig. 11", "the domino effect"),
    ("fig. 12", "tangential impulse of a spinning ball"),
    ("fig. 13", "a chain with hinges in free fall"),
]

# Mistakes of the thesis: (key, what it says, what is so and what Sudar does).
ERRATA = [
    ("volume", "(A.1): a tetrahedron's volume is a·(b × c)/4",
     "It is a·(b × c)/6; with /4 every mass is 1.5 times too big."),
    ("drag", "(3.6): F = −A v − B v²",
     "v² has no direction: F = −A v − B |v| v. It is integrated implicitly, v ← v/(1 + h (A + B|v|)/m), because the "
     "explicit form explodes where time runs fast."),
    ("sliding", "(3.18): the numerator is −(1+e) Δu_n",
     "Δu_n is what is sought; the approach speed u_n belongs there."),
    ("bar", "(3.22): the bar's impulse is K⁻¹(−u_n n)",
     "That pushes off the bar's axis and adds energy in 16.6 % of random states. The impulse acts along the bar: "
     "p = −(u_n/(n·K n)) n."),
    ("correction", "(3.20): Δu_e is called an impulse",
     "It is a velocity. The impulse that reaches it is Δu_e n/(n·K n), accumulated and never negative."),
    ("cost", "§3.3: with n sub-steps the speed of computation grows n times",
     "The cost does."),
    ("cone", "(3.16): the friction cone is tested for each increment of the impulse",
     "The cone limits the accumulated impulse. Tested per increment, a train moves that static friction should hold. "
     "(Option friction_per_increment shows it.)"),
    ("one-point", "§3.9: a contact is reduced to one point, the centre of the intersection",
     "One point cannot carry a tilting moment: in the prototype every tower of fig. 9 falls within 10 s. Sudar solves up "
     "to four points of the contact polygon. (Option one_point_contact shows it.)"),
]

REFERENCE = r"(?:\([3A]\.\d+\)|§[1-6A](?:\.\d)?|fig\. \d+|table 1|erratum [a-z-]+)"
ANCHOR = re.compile(rf"\bthesis ({REFERENCE}(?:(?:, | and | · ){REFERENCE})*)")


def anchors(root):
    """{reference: ["path:line", …]} of all sources, and the complaints about references that do not exist."""
    known = {reference for reference, _ in CONTENTS} | {f"erratum {key}" for key, _, _ in ERRATA}
    places, complaints = {}, []
    for path in sources(root, ("include", "src", "scenarios", "bench", "app", "tests")):
        name = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for match in ANCHOR.finditer(line):
                for reference in re.findall(REFERENCE, match.group(1)):
                    if reference not in known:
                        complaints.append(f"{name}:{number}: the thesis has no {reference}")
                    places.setdefault(reference, []).append((name, number))
    return places, complaints


def links(found):
    return ", ".join(f"[{name}:{number}](../{name}#L{number})" for name, number in found) or "–"


def page(places):
    """The text of docs/thesis.md."""
    lines = ["# The thesis in the code", "", TITLE + ".", "",
             "Each section, equation and figure of the thesis, and where it lives. Written by `tools/thesis_index.py --write`",
             "from anchors in the sources. The thesis numbers only its figures; sections and equations are numbered here in",
             "their order, (3.…) in its chapter 3 and (A.…) in its appendix, and the equations stand as corrected below. A",
             "dash: not in the code (yet, or because it is prose).", "", "| | | code |", "|---|---|---|"]
    for reference, what in CONTENTS:
        strong = "**" if reference[0] == "§" else ""
        cell = what.replace("|", "\\|")
        where = "" if strong and reference not in places else links(places.get(reference, []))
        lines.append(f"| {reference} | {strong}{cell}{strong} | {where} |")
    lines += ["", "## Mistakes of the thesis that Sudar does not repeat", "",
              "| | the thesis | what is so | regression test |", "|---|---|---|---|"]
    for key, says, fact in ERRATA:
        cells = [cell.replace("|", "\\|") for cell in (key, says, fact)]
        lines.append(f"| {' | '.join(cells)} | {links(places.get('erratum ' + key, []))} |")
    return "\n".join(lines) + "\n"


def main():
    target = ROOT / "docs" / "thesis.md"
    places, complaints = anchors(ROOT)
    complaints += [f"no test has the anchor: thesis erratum {key}" for key, _, _ in ERRATA
                   if not any(name.startswith("tests/") for name, _ in places.get("erratum " + key, []))]
    complaints += generate(target, page(places), write=sys.argv[1:] == ["--write"])
    print("\n".join(complaints), end="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
