#!/usr/bin/env python3
"""Golden motions: hashes of poses and velocities that every build must reproduce, bit by bit.

    tools/golden.py                    builds the presets release and double, and compares
    tools/golden.py PROGRAM…           compares what these golden_motions print; builds nothing
    tools/golden.py --matrix           builds {g++, clang++} × {O0, O2, O3} × {float, double}, and compares each
    tools/golden.py --write REASON     renews the files where release and double differ from them, and keeps the reason

The exit code is 1 where a motion differs. tests/golden holds a file for each precision, float.json and double.json, and
the reasons for which they were renewed, newest first, reasons.md. What moves is listed in tests/golden/motions.cc. A
change of speed or structure keeps all hashes; one that is meant to change motion renews them and says why.
"""

import argparse
import datetime
import json
import pathlib
import subprocess
import sys

from sources import ROOT, sudar_version

FOLDER = ROOT / "tests" / "golden"
TARGET = "golden_motions"
COMPILERS, OPTIMISATIONS, PRECISIONS = ("g++", "clang++"), ("O0", "O2", "O3"), ("float", "double")
REASONS_HEAD = "# Why the golden motions were renewed, newest first\n\nWritten by `tools/golden.py --write REASON`.\n"


def differences(expected, found):
    """What differs, in words, a line a motion, between two {name: {step: hash}}; what is a variation of nothing, too."""
    lines = [f"{name}: is not written down" for name in found if name not in expected]
    lines += [f"{name}: moves as without that setting" for name, hashes in found.items()
              if " " in name and hashes == found.get(name.split()[0])]
    for name, hashes in expected.items():
        if name not in found:
            lines.append(f"{name}: did not run")
            continue
        other = found[name]
        step = next((s for s in {**hashes, **other} if hashes.get(s) != other.get(s)), None)
        if step is not None:
            lines.append(f"{name}: differs at step {step}: {other.get(step, 'no such step')}, "
                         f"expected {hashes.get(step, 'no such step')}")
    return lines


def call(*words):
    """Runs a command quietly; where it fails, its output is the error."""
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, words))} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def build(folder, *options):
    call("cmake", *options)
    call("cmake", "--build", folder, "--target", TARGET)
    return folder / "bin" / TARGET


def build_preset(name):
    return build(ROOT / "build" / name, "--preset", name)


def build_cell(compiler, optimisation, precision):
    folder = ROOT / "build" / "golden" / f"{compiler}-{optimisation}-{precision}"
    return build(folder, "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=", f"-DCMAKE_CXX_COMPILER={compiler}",
                 f"-DCMAKE_CXX_FLAGS=-{optimisation}", f"-DSUDAR_DOUBLE={'ON' if precision == 'double' else 'OFF'}",
                 "-DSUDAR_STATIC_SCENARIOS=ON", "-DSUDAR_APP=OFF")


def compare(title, program):
    """Prints and returns what differs in the motions of a program from those written down for its precision."""
    printed = json.loads(call(program))
    file = FOLDER / f"{printed['precision']}.json"
    lines = differences(json.loads(file.read_text())["motions"], printed["motions"])
    print(f"{title}: {len(printed['motions'])} motions, " + (f"{len(lines)} differ from {file.relative_to(ROOT)}" if lines
                                                             else "all as written down"), flush=True)
    print("".join(f"  {line}\n" for line in lines), end="", flush=True)
    return lines


def renew(reason, programs, version):
    """Writes what the programs print, and the reason where that is something new."""
    changed = []
    for program in programs:
        text = call(program)
        file = FOLDER / f"{json.loads(text)['precision']}.json"
        if not file.exists() or file.read_text() != text:
            file.write_text(text)
            changed.append(file.name)
    if not changed:
        print("nothing differs: nothing renewed")
        return
    log = FOLDER / "reasons.md"
    entries = log.read_text().removeprefix(REASONS_HEAD) if log.exists() else ""
    log.write_text(f"{REASONS_HEAD}\n- {datetime.date.today()}, {version}, {' and '.join(changed)}: {reason}\n{entries.lstrip()}")
    print(f"renewed {' and '.join(changed)}")


def version():
    """The version, and the commit on which the change stands."""
    return f"{sudar_version()} on {call('git', 'rev-parse', '--short', 'HEAD').strip()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="*", type=pathlib.Path, metavar="PROGRAM")
    parser.add_argument("--matrix", action="store_true")
    parser.add_argument("--write", metavar="REASON")
    arguments = parser.parse_args()
    if arguments.write is not None:
        if not arguments.write.strip():
            parser.error("--write needs a reason")
        renew(arguments.write.strip(), arguments.programs or [build_preset("release"), build_preset("double")], version())
        return 0
    if arguments.matrix:
        cells = [(c, o, p) for c in COMPILERS for o in OPTIMISATIONS for p in PRECISIONS]
        found = [compare(" ".join(cell), build_cell(*cell)) for cell in cells]
    else:
        found = [compare(p, p) for p in arguments.programs] or [compare(n, build_preset(n)) for n in ("release", "double")]
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main())
