"""What is shown: marks over the picture, colours, panels, help, full screen; pictures and movies of it."""
import os
import struct
import subprocess
import zlib

import harness


def png(path):
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


class Show(harness.WindowTest):
    def toggles(self, key, field):
        plain = self.picture()
        was = self.state()[field]
        self.key(key)
        self.until(lambda s: s[field] != was, f"{key} turns {field}")
        self.until_changed(plain, field, 4)
        self.key(key)
        self.until(lambda s: s[field] == was, f"{key} turns {field} back")
        self.until_picture(lambda now: harness.changed(plain, now) == 0, f"the picture without {field}")

    def test_marks(self):
        self.open("vehicle")
        self.pause_at_start()
        while self.state()["contacts"] <= 3:  # until the vehicle stands on its wheels
            steps = self.state()["steps"]
            self.assertLess(steps, 500)
            self.key("shift+period")
            self.until(lambda s: s["steps"] == steps + 10, "ten steps")
        self.xdotool("mousemove", 640, 50)
        for key, field in (("c", "contacts_shown"), ("j", "joints_shown"), ("o", "forces_shown"), ("x", "axes_shown"),
                           ("n", "labels_shown"), ("g", "boxes_shown"), ("shift+g", "cells_shown"),
                           ("z", "wireframe"), ("F1", "help"), ("shift+slash", "help"), ("Tab", "panels")):
            with self.subTest(key):
                self.toggles(key, field)

    def test_cells_of_the_grid(self):
        self.open("dominoes")
        self.pause()
        self.press("broad")
        self.press("broad: grid")
        self.until(lambda s: s["config"]["broad"] == "grid", "the grid is chosen")
        self.xdotool("mousemove", 640, 50)
        steps = self.state()["steps"]
        self.key("period")
        self.until(lambda s: s["steps"] > steps, "a step is made")
        self.next_pictures()
        self.toggles("shift+g", "cells_shown")

    def test_colours_and_sleep(self):
        self.open("wall")
        self.until(lambda s: s["steps"] > 200, "bricks fly")
        self.pause()
        by_body = before = self.picture()
        for colouring in (1, 2, 3, 0):
            self.key("k")
            self.until(lambda s: s["colouring"] == colouring, "K changes the colours")
            self.until_changed(before, f"colouring {colouring}", 500)
            before = self.picture()
        self.assertEqual(harness.changed(by_body, before), 0)
        self.key("plus", "plus", "plus", "p")  # ten times real time
        self.until(lambda s: s["asleep"] > 20, "bricks fall asleep")
        self.pause()
        self.toggles("l", "sleep_shown")

    def test_full_screen(self):
        self.open("cradle")
        for full, size in ((True, [1000, 980]), (False, [harness.WIDTH, harness.HEIGHT])):
            self.key("F11")
            self.until(lambda s: s["fullscreen"] == full and s["window"] == size, "F11")

    def test_screenshots(self):
        self.open("net")
        self.key("ctrl+p")
        file = self.file_told("Picture: ")
        width, height, pixels = png(file)
        self.assertGreater(width, 600)
        self.assertGreater(height, 500)
        self.assertGreater(len(set(pixels)), 50, "the picture is of one colour")
        self.key("ctrl+p")
        self.until(lambda s: "net-2.png" in os.listdir(os.path.dirname(file)), "another picture")

    def test_movie(self):
        self.open("cradle")
        self.key("v")
        self.until(lambda s: s["filming"], "V films")
        steps = self.state()["steps"]
        self.until(lambda s: s["steps"] > steps + 100, "the run goes on")
        self.key("v")
        self.until(lambda s: not s["filming"], "V ends the movie")
        file = self.file_told("Movie: ")
        self.assertTrue(os.path.basename(file).startswith("cradle"), file)
        seconds = subprocess.check_output(["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of",
                                           "csv=p=0", file], text=True)
        self.assertGreater(float(seconds), 0.9)


if __name__ == "__main__":
    harness.main()
