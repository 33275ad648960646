"""Opens the real window on a virtual screen, presses real keys and mouse buttons, reads the state that the program tells
with --status, and the pixels of the screen. Nothing here depends on how fast the machine is: whatever is expected is
waited for.

A test file ends with  harness.main(): TEST_FILE PROGRAM  (needs Xvfb and xdotool)
"""
import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = None
PATIENCE = float(os.environ.get("PATIENCE", 180))  # s, for anything that is waited for
WIDTH, HEIGHT = 960, 924                           # of the window, at the screen's top left
PICTURE = 600                                      # its rows down to here show the scene, below are timeline and plots
SIDE = 300                                         # width of the panel at the left


class Screen:
    """A virtual screen of its own; X chooses a free number for it, and keeps its pixels in a file."""

    def __init__(self, size="1000x980x24"):
        self.folder = tempfile.TemporaryDirectory()
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", size, "-nolisten", "tcp",
             "-fbdir", self.folder.name], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as numbers:
            self.display = ":" + numbers.readline().strip()

    def pixels(self, place=None):
        """Every third pixel of every third row of the part where bodies are drawn, as (red, green, blue), or of another
        place: left, top, right, bottom."""
        left, top, right, bottom = place or (SIDE + 10, 30, WIDTH - 10, PICTURE)
        with open(os.path.join(self.folder.name, "Xvfb_screen0"), "rb") as file:
            data = file.read()
        header = struct.unpack(">25I", data[:100])  # the XWD format
        start, row = header[0] + 12 * header[19], header[12]
        picture = []
        for y in range(top, bottom, 3):
            line = data[start + y * row + 4 * left:start + y * row + 4 * right]
            picture += zip(line[2::12], line[1::12], line[0::12])
        return picture

    def close(self):
        self.server.terminate()
        self.server.wait()
        self.folder.cleanup()


def changed(before, after):
    """How many of the pixels differ clearly."""
    return sum(1 for a, b in zip(before, after) if a != b and max(abs(x - y) for x, y in zip(a, b)) > 24)


class WindowTest(unittest.TestCase):
    screen = None

    @classmethod
    def setUpClass(cls):
        for tool in ("Xvfb", "xdotool"):
            if not shutil.which(tool):
                raise RuntimeError(f"{tool} is not installed: tools/packages.txt lists the packages that tests need")
        cls.screen = Screen()

    @classmethod
    def tearDownClass(cls):
        cls.screen.close()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.status = os.path.join(self.folder.name, "status")
        self.environment = dict(os.environ, DISPLAY=self.screen.display, LIBGL_ALWAYS_SOFTWARE="1")
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.program = None

    def tearDown(self):
        if self.program and self.program.poll() is None:
            self.program.kill()
            self.program.wait()
        self.folder.cleanup()

    def open(self, scene, *arguments):
        self.program = subprocess.Popen(
            [PROGRAM, "--size", f"{WIDTH}x{HEIGHT}", "--quality", "plain", "--status", self.status, scene, *arguments],
            cwd=self.folder.name, env=self.environment)
        s = self.until(lambda s: True, "the first picture")
        self.assertEqual(s["scene"], scene)
        self.xdotool("mousemove", 640, 330)
        return s

    # --- looking ---

    def state(self):
        try:
            with open(self.status) as file:
                return json.load(file)
        except FileNotFoundError:
            return None

    def until(self, holds, what):
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            if self.program.poll() is not None:
                self.fail(f"the program ended with {self.program.returncode} before {what}")
            s = self.state()
            if s and holds(s):
                return s
            time.sleep(0.005)
        state = {key: value for key, value in self.state().items() if key not in ("places", "config")}
        self.fail(f"not in {PATIENCE} s: {what}; state {state}")

    def next_pictures(self):
        """Waits until whatever was pressed has been answered and shown."""
        picture = self.state()["pictures"]
        return self.until(lambda s: s["pictures"] > picture + 1, "the next pictures")

    def picture(self):
        self.next_pictures()
        return self.screen.pixels()

    def until_picture(self, holds, what):
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            if holds(self.picture()):
                return
        self.fail(f"not in {PATIENCE} s: {what}")

    def until_changed(self, before, what, least=25):
        self.until_picture(lambda now: changed(before, now) >= least, f"the picture shows {what}")

    def pixel_of(self, point, field_of_view=0.7):
        """Where a point of the scene is seen on the screen."""
        s = self.state()
        eye, target = s["eye"], s["target"]
        def dot(a, b): return sum(x * y for x, y in zip(a, b))
        def unit(a): return [x / math.sqrt(dot(a, a)) for x in a]
        ahead = unit([t - e for t, e in zip(target, eye)])
        right = unit([-ahead[2], 0, ahead[0]])
        up = [right[1] * ahead[2] - right[2] * ahead[1], right[2] * ahead[0] - right[0] * ahead[2],
              right[0] * ahead[1] - right[1] * ahead[0]]
        way = [p - e for p, e in zip(point, eye)]
        left, top, width, height = s["area"]
        scale = height / (2 * math.tan(field_of_view / 2) * dot(way, ahead))
        return round(left + width / 2 + scale * dot(way, right)), round(top + height / 2 - scale * dot(way, up))

    # --- doing ---

    def xdotool(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def click(self, button=1, times=1):
        """Where the mouse is. (xdotool's own click takes a rest of 0.1 s.)"""
        self.xdotool(*["mousedown", button, "mouseup", button] * times)

    def click_at(self, x, y):
        self.xdotool("mousemove", x, y, "mousedown", 1, "mouseup", 1)

    def key(self, *names):
        self.xdotool("key", "--delay", "5", *names)

    def pause(self):
        if not self.state()["paused"]:
            self.key("p")
        self.until(lambda s: s["paused"], "P pauses")
        return self.next_pictures()

    def pause_at_start(self):
        """However long the machine took to get here: what moves in the scene still does."""
        self.pause()
        run = self.state()["run"]
        self.key("r")
        self.until(lambda s: s["run"] == run + 1 and s["steps"] == 0, "R restarts")
        return self.next_pictures()

    def place(self, widget, share=0.5):
        """Where the widget stands; the side panel is scrolled until it is seen."""
        pictures = self.next_pictures()["pictures"]
        s = self.until(lambda s: widget in s["places"] or s["pictures"] > pictures + 6, "a list has opened, if it opens")
        if widget not in s["places"]:
            self.xdotool("mousemove", 150, HEIGHT - 50)
            for wheel in [4] * 8 + [5] * 16:
                if widget in self.state()["places"]:
                    break
                self.click(wheel)
                self.next_pictures()
        s = self.until(lambda s: widget in s["places"], f"{widget} is seen")
        left, top, right, bottom = s["places"][widget]
        floor = HEIGHT - 30  # of the side panel
        if right < s["area"][0] and bottom > floor:  # half of it is under the edge
            self.xdotool("mousemove", 150, HEIGHT - 50)
            self.click(5)
            left, top, right, bottom = self.next_pictures()["places"][widget]
        return int(left + share * (right - left)), (top + bottom) // 2

    def press(self, widget, share=0.5):
        self.click_at(*self.place(widget, share))

    def choose(self, menu, item):
        """An item of a menu, with the mouse."""
        self.press(menu)
        self.until(lambda s: item in s["places"], f"the menu {menu} opens")
        self.press(item)

    def drag(self, button, *way):
        """From the first point over the others with the button held."""
        self.xdotool("mousemove", *way[0], "mousedown", button)
        for point in way[1:]:
            self.xdotool("mousemove", *point)
        self.xdotool("mouseup", button)

    def file_told(self, prefix):
        """The file that the last message names."""
        message = self.until(lambda s: s["message"].startswith(prefix), f"the message {prefix}")["message"]
        return os.path.join(self.folder.name, re.search(r"out/[^\s,:]+", message)[0])

    def replayed(self):
        """The last recording, replayed without a window, leads to the same state."""
        file = self.file_told("Recorded: ")
        told = self.state()["message"]
        replay = subprocess.run([PROGRAM, "replay", "--check", file], capture_output=True, text=True)
        self.assertEqual(replay.returncode, 0, replay.stdout + replay.stderr)
        self.assertEqual(re.search(r"state (\w+)", replay.stdout)[1], re.search(r"state (\w+)", told)[1])


def main():
    global PROGRAM
    # The test file imports this module by name, so the program's path belongs there.
    sys.modules["harness"].PROGRAM = PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main(module="__main__")
