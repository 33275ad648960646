#!/usr/bin/env python3
"""What the program took in silence, and what lost its work: numbers out of range, paths that are none, plugins that took
the others down, runs that were interrupted. Each is tried from outside.

    tests/app/bad_input_test.py PROGRAM
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

program = pathlib.Path(sys.argv[1]).resolve()
failures = []


def expect(true, message):
    if not true:
        failures.append(message)


def run(*arguments, **more):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL, **more)
    return done.returncode, done.stdout, done.stderr


def refused(arguments, *words):
    """Exit code 2, one short line that holds the words."""
    code, out, err = run(*arguments)
    expect(code == 2 and out == "", f"{arguments}: exit {code}, {out[:200]}")
    expect(all(w in err for w in words), f"{arguments}: {err[:300]} does not say {words}")
    expect(len(err) < 600 and "bad_alloc" not in err, f"{arguments}: {err[:600]}")


def numbers():
    for bad in ("nan", "inf", "-inf", "-1", "1e300", "", "soon", "0x10", "1 2"):
        refused(["run", "wall", "--seconds=" + bad] if bad else ["run", "wall", "--seconds", ""], "--seconds")
        refused(["render", "wall", "-o", "a.png", "--at=" + bad] if bad else ["render", "wall", "-o", "a.png", "--at", ""], "--at")
    for bad in ("-1", "99999999999999999999", "1.5", "nan", "1e3"):
        refused(["run", "wall", "--steps=" + bad], "--steps", bad)
    for option, bad in (("--dt", "nan"), ("--dt", "inf"), ("--dt", "-0.1"), ("--dt", "0"), ("--substeps", "nan"),
                        ("--substeps", "0"), ("--time-factor", "nan"), ("--time-factor", "-1")):
        refused(["run", "wall", f"{option}={bad}", "--steps", "1"], option[2:].replace("-", "_"))
    for option in ("--dt", "--substeps", "--solver", "--broad", "--record", "--csv", "--save", "--load", "--keys", "--set"):
        refused(["run", "wall", option, ""], option, "empty")
        refused(["run", "wall", option + "="], option)
    for camera in ("nan,0,0,1,1,1", "1,1,1,inf,0,0", "1,1,1,0,0,0,nan", "1,1,1,0,0,0,179", "1e300,0,0,1,1,1"):
        refused(["render", "wall", "-o", "a.png", "--camera=" + camera], "--camera")
    for size in ("0x0", "1e9x2", "-16x16", "nanxnan", "640", "640x", "x480", "99999x99999", "1e2x1e2"):
        refused(["render", "wall", "-o", "a.png", "--size=" + size], "--size")
        refused(["wall", "--size=" + size], "--size")
    for option, bad in (("--fps", "0"), ("--fps", "nan"), ("--samples", "5"), ("--samples", "-1")):
        refused(["render", "wall", "-o", "a.png", f"{option}={bad}"], option, bad)
    for bad in ("0", "-1", "nan", "99999999"):
        refused(["verify", "V01", "--jobs=" + bad], "--jobs", bad)
        refused(["bench", "--repeat=" + bad], "--repeat", bad)
        refused(["bench", "--picture", "--bodies=" + bad], "--bodies", bad)
    for bad in ("nan", "inf", "3.5", "1e99"):
        refused(["run", "wall", "--set", "rows=" + bad], "rows")
        refused(["run", "wall", "--config", "substeps=" + bad], "substeps", bad)
    for keys in ("0:nosuch", "nan:up", "inf:up", "-1:up", "0:Up", "0:up+nosuch", "0:up, down"):
        refused(["run", "vehicle", "--keys=" + keys], "keys")
    for bad in ("a@-1", "a@nan", "a@1e99", "a@", "@3", "a@1.5"):
        refused(["run", "wall", "--steps", "1", "--save", bad], "--save")


def paths(folder):
    (folder / "empty").touch()
    (folder / "text").write_text("no recording at all, just a text")
    os.mkfifo(folder / "pipe")
    for verb in (["replay"], ["run", "wall", "--load"]):
        refused([*verb, "/"], "/", "folder")
        refused([*verb, str(folder / "missing")], "missing", "no such file")
        refused([*verb, str(folder / "empty")], str(folder / "empty"))
        refused([*verb, str(folder / "text")], str(folder / "text"), "is not a")
        refused([*verb, str(folder / "pipe")], str(folder / "pipe"), "no regular file")
    refused(["render", "/", "-o", str(folder / "a.png")], "folder")
    refused(["render", str(folder / "missing"), "-o", str(folder / "a.png")], "no such file")
    for option in ("--csv", "--record", "--save"):
        at = "@1" if option == "--save" else ""
        refused(["run", "wall", "--steps", "2", option, str(folder) + at], str(folder), "folder")
        refused(["run", "wall", "--steps", "2", option, str(folder / "no" / "file") + at], "no folder")
        if option != "--save":
            refused(["run", "wall", "--steps", "2", option, "/dev/full"], "/dev/full", "No space left")
    refused(["render", "wall", "-o", str(folder / "no" / "a.png")], "no folder")
    refused(["run", "wall", "--csv", str(folder / "x"), "--record", str(folder / "x")], "--csv")
    run("run", "cradle", "--steps", "20", "--record", str(folder / "tape"), "--save", str(folder / "state") + "@10")
    for name, verb in (("tape", ["replay"]), ("state", ["run", "cradle", "--load"])):
        whole = (folder / name).read_bytes()
        (folder / "short").write_bytes(whole[: len(whole) // 2])
        refused([*verb, str(folder / "short")], "short", "cut short or damaged")
    tape = bytearray((folder / "tape").read_bytes())
    tape[8] = 77
    (folder / "later").write_bytes(tape)
    refused(["replay", str(folder / "later")], "later", "version", "77")
    if os.geteuid() != 0:
        (folder / "tape").chmod(0)
        refused(["replay", str(folder / "tape")], "Permission denied")


def names():
    for near, meant in (("wal", "wall"), ("dominos", "dominoes"), ("spining_ball", "spinning_ball")):
        refused(["run", near], f"did you mean '{meant}'?")
    for far in ("xyzzy", "a", "/", "quantum_chromodynamics"):
        code, _, err = run("run", far)
        expect(code == 2 and "did you mean" not in err, f"{far}: {err}")


def start(folder, *more):
    """A run that would last for hours; goes on when it has written something."""
    files = [folder / name for name in ("tape", "course.csv")]
    p = subprocess.Popen([program, "run", "wall", "--seconds", "1e6", "--record", files[0], "--csv", files[1], *more],
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for _ in range(600):
        parts = [f.with_name(f.name + ".part") if f.with_name(f.name + ".part").exists() else f for f in files]
        if p.poll() is not None or all(f.exists() and f.stat().st_size > 300000 for f in parts[:1]):
            break
        time.sleep(0.05)
    return p, files


def rows_of(csv):
    text = csv.read_text()
    expect(text.endswith("\n"), f"{csv} ends in the middle of a row")
    lines = text.splitlines()
    header = lines[0].count(",")
    expect(all(line.count(",") == header for line in lines), f"{csv} has a broken row")
    return len(lines) - 2  # the header and the start


def interruptions(folder):
    for sent in (signal.SIGINT, signal.SIGTERM):
        here = folder / sent.name
        here.mkdir()
        p, (tape, csv) = start(here)
        p.send_signal(sent)
        _, err = p.communicate(timeout=30)
        expect(p.returncode == 130, f"{sent.name}: exit {p.returncode}")
        expect("interrupted after step" in err and "tape" in err and "course.csv" in err, f"{sent.name}: {err}")
        steps = int(err.split("step ")[1].split(",")[0])
        code, out, err = run("replay", tape, "--check")
        expect(code == 0 and f"{steps} steps" in out and "cut off" not in out, f"{sent.name}: {out} {err}")
        expect(rows_of(csv) == steps, f"{sent.name}: {rows_of(csv)} rows, {steps} steps")
        expect(not list(here.glob("*.part")), f"{sent.name}: parts are left")


def kills(folder):
    here = folder / "killed"
    here.mkdir()
    p, (tape, csv) = start(here)
    p.kill()
    p.communicate()
    code, out, err = run("replay", tape, "--check")
    expect(code == 0 and "cut off" in out, f"killed: {code} {out} {err}")
    whole = tape.read_bytes()
    (here / "half").write_bytes(whole[: len(whole) - 1000])  # in the middle of a step
    code, out, err = run("replay", here / "half", "--check")
    expect(code == 0 and "cut off" in out, f"killed in a step: {code} {out} {err}")
    (here / "none").write_bytes(whole[:500])  # in the middle of the start
    refused(["replay", str(here / "none")], "none")
    rows_of(csv)


def full_disks(folder):
    """A limit of the file's size does as a full disk does."""
    limit = lambda: __import__("resource").setrlimit(__import__("resource").RLIMIT_FSIZE, (400000, 400000))
    old = folder / "old"
    old.write_bytes(b"what was there")
    for option in ("--record", "--csv"):
        code, _, err = run("run", "wall", "--seconds", "1000", option, old, preexec_fn=limit)
        expect(code == 2 and "cannot be written" in err and str(old) in err, f"full {option}: {code} {err}")
        expect(old.read_bytes() == b"what was there", f"full {option}: the old file is gone")
        fresh = folder / ("fresh" + option)
        code, _, err = run("run", "wall", "--seconds", "1000", option, fresh, preexec_fn=limit)
        expect(code == 2 and "cannot be written" in err, f"full {option}: {code} {err}")
    code, out, err = run("replay", folder / "fresh--record", "--check")
    expect(code == 0 and "cut off" in out, f"what a full disk leaves: {out} {err}")
    rows_of(folder / "fresh--csv")
    expect(not list(folder.glob("*.part")), "parts are left")


PLUGIN = """
struct Entry { const char *abi, *name, *place, *about; double seconds, picture; void *create, *destroy; };
static struct Entry entry = %s;
const struct Entry *sudar_scenario(void) { return %s; }
"""


def plugins(folder):
    usual = program.parent.parent / "lib" / "sudar" / "scenarios"
    if not usual.exists():
        return  # linked in
    here = folder / "plugins"
    here.mkdir()
    whole = (usual / "train.so").read_bytes()
    (here / "train.so").write_bytes(whole)
    bad = {"empty.so": b"", "text.so": b"no library", "head.so": whole[:64], "page.so": whole[:5000],
           "half.so": whole[: len(whole) // 2], "last.so": whole[:-2000]}
    machine = bytearray(whole)
    machine[18] ^= 0x55
    bad["machine.so"] = bytes(machine)
    for name, content in bad.items():
        (here / name).write_bytes(content)
    os.mkfifo(here / "pipe.so")
    (here / "folder.so").mkdir()
    (here / "dangling.so").symlink_to("nowhere")
    sources = {"null_entry.so": ("{0}", "0"), "null_abi.so": ("{0}", "&entry"), "foreign.so": ('{"other"}', "&entry")}
    compiler = shutil.which("cc")
    for name, values in sources.items() if compiler else ():
        subprocess.run([compiler, "-shared", "-fPIC", "-x", "c", "-", "-o", here / name], input=PLUGIN % values, text=True, check=True)
    code, out, err = run("--scenarios", here, "list")
    expect(code == 0 and out.startswith("train ") and out.count("\n") == 1, f"plugins: exit {code}: {out} {err}")
    expected = {*bad, "pipe.so", "folder.so", "dangling.so", *(sources if compiler else ())}
    for name in sorted(expected):
        lines = [line for line in err.splitlines() if f" {name} refused: " in line]
        expect(len(lines) == 1, f"{name}: {lines or err}")
    expect(len(err.splitlines()) == len(expected), f"more than a line each: {err}")


def benches():
    code, out, err = run("bench", "spin")
    expect(code == 0 and "spin" in out and "less is better" in out, f"bench spin: {code} {out} {err}")
    refused(["bench", "--thesis", "spin"], "spin", "not known")
    refused(["bench", "wal"], "did you mean 'wall'")


with tempfile.TemporaryDirectory() as temporary:
    os.chdir(temporary)
    for test in (numbers, names, benches):
        test()
    for test in (paths, interruptions, kills, full_disks, plugins):
        here = pathlib.Path(temporary) / test.__name__
        here.mkdir()
        test(here)
print("\n".join(failures) or "bad input is refused by name, and no work is lost")
sys.exit(1 if failures else 0)
