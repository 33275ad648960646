#!/usr/bin/env python3
"""What the window shows of 2,000 bodies with shadows, and what the physics thread feels of it.
    bench/window.py [build/release/bin/sudar] [--seconds 6] [--rounds 3]
Opens the real window on a virtual screen of 1280 × 720, OpenGL in software, on the heap of bench/heap.cc. The cases take
turns (minutes apart the same machine is another machine), and the table shows medians over the rounds. Processor time
comes from /proc: what draws runs at niceness 10 and physics at 0, which tells their threads apart; "others" are the cores
that other programs used meanwhile. Each case ends with a recording, which a run without a window has to repeat to the
same state. (needs Xvfb and xdotool)
"""
import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../tests/app/window"))
import harness

TICK = os.sysconf("SC_CLK_TCK")
FULL = "1280x720"
CASES = {  # size and quality of the window; keys pressed before; is the camera turned meanwhile?
    "runs, hardly a picture": ("320x32", "plain", [], False),
    "runs, plain picture": (FULL, "plain", [], False),
    "runs, plain picture, no panels": (FULL, "plain", ["Tab"], False),
    "runs, fine picture": (FULL, "fine", [], False),
    "paused, plain picture turns": (FULL, "plain", ["p"], True),
    "paused, nothing moves": (FULL, "plain", ["p"], False),
}


def thread_seconds(pid):
    """Processor time so far, s: of the physics thread, of those that draw."""
    physics = drawing = 0
    for task in os.listdir(f"/proc/{pid}/task"):
        with open(f"/proc/{pid}/task/{task}/stat") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        used = (int(fields[11]) + int(fields[12])) / TICK
        if int(fields[16]) == 0:
            physics += used
        else:
            drawing += used
    return physics, drawing


def machine_seconds():
    """Processor time so far that any program used, s."""
    with open("/proc/stat") as file:
        user, nice, system, _, _, irq, softirq = map(int, file.readline().split()[1:8])
    return (user + nice + system + irq + softirq) / TICK


class Window:
    def __init__(self, program, screen, folder, size, quality, keys):
        self.command = [program, "--scenarios", os.path.join(os.path.dirname(program), "../lib/bench")]
        self.screen, self.folder, self.status = screen, folder, os.path.join(folder, "status")
        self.environment = dict(os.environ, DISPLAY=screen.display, LIBGL_ALWAYS_SOFTWARE="1")
        self.program = subprocess.Popen([*self.command, "--size", size, "--quality", quality, "--status", self.status,
                                         "heap"], cwd=folder, env=self.environment)
        self.until(lambda s: s["steps"] > 150)  # the heap has reached the ground
        self.do("mousemove", 700, 200)
        if keys:
            self.do("key", *keys)
            self.until(lambda s: s["paused"] or not s["panels"])

    def do(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def state(self):
        with open(self.status) as file:
            return json.load(file)

    def until(self, holds):
        while not os.path.exists(self.status) or not holds(self.state()):
            time.sleep(0.05)

    def turn(self, seconds):
        """The camera to and fro, an event every 10 ms."""
        moves = [x for i in range(int(100 * seconds))
                 for x in ("mousemove", 600 + abs(i % 200 - 100), 200, "sleep", 0.01)]
        self.do("mousedown", 2, *moves, "mouseup", 2)

    def measure(self, seconds, turning):
        def now():
            return (time.monotonic(), machine_seconds(), *thread_seconds(self.program.pid),
                    sum(thread_seconds(self.screen.server.pid)), self.state())
        start, machine, physics, drawing, server, before = now()
        self.turn(seconds) if turning else time.sleep(seconds)
        end, machine2, physics2, drawing2, server2, after = now()
        passed, physics, drawing, server = end - start, physics2 - physics, drawing2 - drawing, server2 - server
        pictures, steps = after["pictures"] - before["pictures"], after["steps"] - before["steps"]
        return {"pictures/s": pictures / passed, "ms a picture": 1e3 * drawing / max(1, pictures),
                "steps/s": steps / passed, "ms a step": 1e3 * physics / steps if steps else 0,
                "X server": server / passed, "others": (machine2 - machine - physics - drawing - server) / passed}

    def replays(self):
        """Records some steps; does a run without a window come to the same state?"""
        self.do("key", "ctrl+shift+r")
        self.until(lambda s: s["recording"])
        steps = self.state()["steps"]
        self.until(lambda s: s["steps"] > steps + 20)
        self.do("key", "ctrl+shift+r")
        self.until(lambda s: s["message"].startswith("Recorded: "))
        told = self.state()["message"]
        file = os.path.join(self.folder, re.search(r"out/[^\s,]+", told)[0])
        replay = subprocess.run([*self.command, "replay", "--check", file], capture_output=True, text=True)
        return replay.returncode == 0 and re.search(r"state (\w+)", told)[0] in replay.stdout

    def close(self):
        self.program.kill()
        self.program.wait()
        os.remove(self.status)


def main():
    options = argparse.ArgumentParser(description="frames a second of the window, and steps a second beside them")
    options.add_argument("program", nargs="?", default="build/release/bin/sudar")
    options.add_argument("--seconds", type=float, default=6, help="of each measurement")
    options.add_argument("--rounds", type=int, default=3)
    o = options.parse_args()
    screen, results, same = harness.Screen("1280x720x24"), {}, True
    for _ in range(o.rounds):
        for name, (size, quality, keys, turning) in CASES.items():
            with tempfile.TemporaryDirectory() as folder:
                window = Window(os.path.abspath(o.program), screen, folder, size, quality, keys)
                results.setdefault(name, []).append(window.measure(o.seconds, turning))
                if "p" not in keys:
                    same = window.replays() and same
                window.close()
    screen.close()
    columns = list(next(iter(results.values()))[0])
    print(" " * 32 + "".join(f"{c:>14}" for c in columns))
    for name, rounds in results.items():
        print(f"{name:32}" + "".join(f"{statistics.median(r[c] for r in rounds):14.2f}" for c in columns))
    print("all recordings replay without a window to the same state" if same else "A RECORDING DIFFERS")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
