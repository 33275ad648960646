"""The window from outside: opens the real program on a virtual screen, presses real keys and mouse buttons, and reads
the state that it tells with --status. Nothing here depends on how fast the machine is: every expectation is waited for.

Usage: window_test.py PROGRAM  (needs Xvfb and xdotool)
"""
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

PROGRAM = None
PATIENCE = float(os.environ.get("PATIENCE", 60))  # s, for anything that is waited for


class Screen:
    """A virtual screen of its own; X chooses a free number for it."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1000x700x24", "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as numbers:
            self.display = ":" + numbers.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()


def png_pixels(path):
    """Width, height and the rows' bytes with their filters still on: enough to see that there is a picture."""
    with open(path, "rb") as file:
        data = file.read()
    width, height = struct.unpack(">II", data[16:24])
    packed, at = b"", 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    return width, height, zlib.decompress(packed)


class Window(unittest.TestCase):
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

    def open(self, *arguments):
        self.program = subprocess.Popen([PROGRAM, "--size", "960x640", "--status", self.status, *arguments],
                                        cwd=self.folder.name, env=self.environment)
        return self.until(lambda s: True, "the first picture")

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
            time.sleep(0.05)
        self.fail(f"not in {PATIENCE} s: {what}; state {self.state()}")

    def xdotool(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def key(self, name, held=0.1):
        *modifiers, last = name.split("+")
        for m in modifiers:
            self.xdotool("keydown", m)
        self.xdotool("keydown", last)
        time.sleep(held)
        self.xdotool("keyup", last)
        for m in reversed(modifiers):
            self.xdotool("keyup", m)

    def paused(self):
        self.key("space")
        return self.until(lambda s: s["paused"], "Space pauses")

    def test_pause_step_restart_quit(self):
        first = self.open("dominoes")
        self.assertEqual(first["scene"], "dominoes")
        self.until(lambda s: s["steps"] > first["steps"], "the run moves by itself")
        self.paused()
        before = self.state()["steps"]
        time.sleep(0.5)
        before = self.state()["steps"]
        self.key("period")
        self.until(lambda s: s["steps"] == before + 1, "a step of one")
        self.key("Right")
        self.until(lambda s: s["steps"] == before + 2, "a step by the arrow")
        self.key("shift+period")
        self.until(lambda s: s["steps"] == before + 12, "ten steps")
        self.key("r")
        s = self.until(lambda s: s["run"] == 2, "R restarts")
        self.assertEqual(s["steps"], 0)
        self.assertTrue(s["paused"])
        self.key("p")
        self.until(lambda s: not s["paused"] and s["steps"] > 0, "P runs")
        self.key("ctrl+q")
        self.assertEqual(self.program.wait(PATIENCE), 0)

    def test_every_scenario_in_turn(self):
        names = [e["name"] for e in json.loads(subprocess.check_output([PROGRAM, "list", "--json"]))]
        self.open(names[0])
        for name in names[1:] + names[:1]:
            self.key("bracketright")
            self.until(lambda s: s["scene"] == name and s["steps"] > 0, f"] leads to {name}")
        self.key("bracketleft")
        self.until(lambda s: s["scene"] == names[-1], "[ leads back")

    def test_search_takes_the_keys(self):
        self.open("cradle")
        self.key("ctrl+k")
        time.sleep(1)
        for letter in "wall":
            self.key(letter)
        self.key("Return")
        s = self.until(lambda s: s["scene"] == "wall", "Ctrl+K finds the wall")
        self.assertFalse(s["paused"] or s["help"] or s["contacts_shown"])

    def test_speed_and_what_is_shown(self):
        self.open("cradle")
        self.key("minus")
        self.until(lambda s: s["speed"] == 0.5, "slower")
        self.key("equal")
        self.key("equal")
        self.until(lambda s: s["speed"] == 2, "faster")
        for key, field in (("c", "contacts_shown"), ("j", "joints_shown"), ("x", "axes_shown"), ("z", "wireframe"),
                           ("F1", "help")):
            self.key(key)
            self.until(lambda s: s[field], f"{key} shows {field}")
            self.key(key)
            self.until(lambda s: not s[field], f"{key} hides {field}")
        self.key("Tab")
        self.until(lambda s: not s["panels"], "Tab hides the panels")

    def test_camera(self):
        start = self.open("dominoes")["eye"]
        self.xdotool("mousemove", 700, 60)
        self.xdotool("mousedown", 2)
        time.sleep(0.2)
        self.xdotool("mousemove", 760, 90)
        time.sleep(0.2)
        self.xdotool("mouseup", 2)
        turned = self.until(lambda s: s["eye"] != start, "the middle button turns")["eye"]
        self.xdotool("click", 4)
        self.until(lambda s: s["eye"] != turned, "the wheel comes closer")

    def test_drag_shoot_add_delete_recorded(self):
        bodies = self.open("wall")["bodies"]
        self.key("ctrl+shift+r")
        self.until(lambda s: s["recording"], "Ctrl+Shift+R records")
        self.xdotool("mousemove", 620, 440)
        self.xdotool("mousedown", 1)
        s = self.until(lambda s: s["dragging"], "the mouse takes a brick")
        self.assertGreaterEqual(s["selected"], 0)
        grabbed = s["selected_at"]
        self.xdotool("mousemove", 660, 200)
        self.until(lambda s: s["selected_at"] and s["selected_at"][1] > grabbed[1] + 1, "the brick rises")
        self.xdotool("mouseup", 1)
        self.until(lambda s: not s["dragging"], "the mouse lets go")
        self.key("b")
        self.until(lambda s: s["bodies"] == bodies + 1, "B shoots a ball")
        self.key("Insert")
        self.until(lambda s: s["bodies"] == bodies + 2, "Insert adds a box")
        self.key("shift+Insert")
        self.until(lambda s: s["bodies"] == bodies + 3, "Shift+Insert adds a sphere")
        self.key("Delete")
        self.until(lambda s: s["bodies"] == bodies + 2 and s["selected"] == -1, "Delete removes the brick")
        self.key("ctrl+shift+r")
        self.until(lambda s: not s["recording"], "the recording ends")
        self.replayed("wall")

    def test_screenshot(self):
        self.open("net")
        self.key("ctrl+p")
        self.until(lambda s: s["message"].startswith("Picture: "), "Ctrl+P writes a picture")
        width, height, pixels = png_pixels(os.path.join(self.folder.name, "out", "net.png"))
        self.assertGreater(width, 600)
        self.assertGreater(height, 500)
        self.assertGreater(len(set(pixels)), 50, "the picture is of one colour")

    def test_movie(self):
        self.open("cradle")
        self.key("v")
        self.until(lambda s: s["filming"], "V films")
        steps = self.state()["steps"]
        self.until(lambda s: s["steps"] > steps + 20, "the run goes on")
        self.key("v")
        self.until(lambda s: not s["filming"] and s["message"], "V ends the movie")
        made = os.listdir(os.path.join(self.folder.name, "out"))
        self.assertTrue(any(name.startswith("cradle") for name in made), made)

    def place(self, widget, share=0.5):
        """Where the widget stands; the side panel is scrolled until it is seen."""
        self.next_pictures()
        if widget not in self.state()["places"]:
            self.xdotool("mousemove", 150, 590)
        for wheel in [4] * 8 + [5] * 16:
            if widget in self.state()["places"]:
                break
            self.xdotool("click", wheel)
            self.next_pictures()
        left, top, right, bottom = self.until(lambda s: widget in s["places"], f"{widget} is seen")["places"][widget]
        return left + share * (right - left), (top + bottom) / 2

    def next_pictures(self):
        """Waits until whatever was pressed has been answered and shown."""
        picture = self.state()["pictures"]
        self.until(lambda s: s["pictures"] > picture + 1, "the next picture")

    def press(self, widget, share=0.5):
        self.xdotool("mousemove", *map(int, self.place(widget, share)), "click", 1)

    def replayed(self, scene):
        """The last recording of the scene, replayed without a window, leads to the same state."""
        told = self.until(lambda s: s["message"].startswith("Recorded: "), "the recording is written")["message"]
        file = re.search(r"Recorded: (\S+),", told)[1]
        replay = subprocess.run([PROGRAM, "replay", "--check", os.path.join(self.folder.name, file)],
                                capture_output=True, text=True)
        self.assertEqual(replay.returncode, 0, replay.stdout + replay.stderr)
        self.assertEqual(re.search(r"state (\w+)", replay.stdout)[1], re.search(r"state (\w+)", told)[1])

    def test_a_parameter_and_a_setting_are_recorded(self):
        before = self.open("wall")
        self.key("ctrl+shift+r")
        self.until(lambda s: s["recording"] and s["steps"] > 20, "Ctrl+Shift+R records")
        # The slider of "rows", pulled to the left with the mouse: a new run in the same recording.
        x, y = self.place("rows", 0.33)
        self.xdotool("mousemove", int(x), int(y), "mousedown", 1)
        self.xdotool("mousemove", int(x) - 10, int(y), "mousemove", int(x) - 20, int(y), "mouseup", 1)
        s = self.until(lambda s: s["run"] == before["run"] + 1, "a new value restarts")
        self.assertLess(s["parameters"]["rows"], before["parameters"]["rows"])
        self.assertLess(s["bodies"], before["bodies"])
        self.assertTrue(s["recording"])
        self.until(lambda s: s["steps"] > 20, "the new run goes on")
        # Another broad phase from the list of them: the run goes on with it.
        self.press("broad")
        self.press("broad: sweep")
        self.until(lambda s: s["config"]["broad"] == "sweep", "the broad phase is exchanged")
        # A number typed into a field.
        self.press("substeps")
        self.xdotool("key", "ctrl+a", "2", "Return")
        s = self.until(lambda s: s["config"]["substeps"] == "2", "the sub-steps are exchanged")
        self.assertEqual(s["run"], before["run"] + 1)
        # And from the start: parameters and settings stay.
        self.key("r")
        s = self.until(lambda s: s["run"] == before["run"] + 2 and s["steps"] > 20, "R restarts")
        self.assertLess(s["parameters"]["rows"], before["parameters"]["rows"])
        self.assertEqual((s["config"]["broad"], s["config"]["substeps"]), ("sweep", "2"))
        self.key("ctrl+shift+r")
        self.replayed("wall")


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
