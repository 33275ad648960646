"""Time: step back, scrub, play backwards, branches and their ghosts, undo; curves of what is measured, and their files."""
import csv
import os
import subprocess
import xml.etree.ElementTree

import harness


class Time(harness.WindowTest):
    def test_back_and_on(self):
        self.open("dominoes")
        self.until(lambda s: s["steps"] > 150, "the run moves")
        steps = self.pause()["steps"]
        late = self.picture()
        for key, less in (("comma", 1), ("Left", 1), ("shift+comma", 10), ("shift+Left", 10)):
            self.key(key)
            steps -= less
            self.until(lambda s: s["steps"] == steps, f"{key} goes {less} steps back")
        # The strip, with the mouse: pressed, then pulled.
        end = self.state()["end"]
        x, y = self.place("timeline", 0.25)
        self.click_at(x, y)
        s = self.until(lambda s: abs(s["steps"] - 0.25 * end) < 0.02 * end, "a click on the strip goes there")
        self.until_changed(late, "fewer dominoes have fallen")
        self.drag(1, (x, y), (x + 60, y), self.place("timeline", 0.75))
        self.until(lambda s: abs(s["steps"] - 0.75 * end) < 0.02 * end, "the strip is pulled")
        self.key("End")
        self.until(lambda s: s["steps"] == end, "End goes to the newest step")
        self.until_picture(lambda now: harness.changed(late, now) < 25, "the picture is as it was")
        # Backwards to the beginning, where it pauses; and on from there: nothing is another one.
        self.key("plus", "plus", "plus", "shift+space")
        # (A slow machine may have come all the way before anybody looks.)
        self.until(lambda s: s["steps"] < end, "Shift+Space plays backwards")
        s = self.until(lambda s: s["steps"] == 0 and s["paused"], "it pauses at the beginning")
        self.assertEqual(s["end"], end)
        self.key("space")
        self.until(lambda s: s["steps"] > end, "it runs on, beyond what was known")
        self.assertEqual(self.pause()["branches"], ["main"])

    def test_branches_undo_and_recording(self):
        self.open("dominoes")
        self.key("ctrl+shift+r")
        self.until(lambda s: s["recording"] and s["steps"] > 120, "a recording goes on through all of it")
        s = self.pause()
        end, bodies = s["end"], s["bodies"]
        self.press("timeline", 0.3)
        self.until(lambda s: s["steps"] < 0.4 * end, "back")
        self.xdotool("mousemove", 640, 200)
        self.key("b")
        s = self.until(lambda s: s["bodies"] == bodies + 1, "B shoots a ball")
        left = s["steps"]
        self.assertEqual((s["branches"], s["end"]), (["main", "2"], left))
        self.key("space")
        self.until(lambda s: s["steps"] > left + 40 and s["ghosts"] > 0, "it goes otherwise: the old future is a ghost")
        now = self.pause()
        with_ghost = self.picture()
        self.key("h")
        self.until(lambda s: s["ghosts"] == 0, "H hides the ghost")
        self.until_changed(with_ghost, "no ghost")
        # Named, left, come back to.
        self.press("rename branch")
        self.until(lambda s: "branch name" in s["places"], "a field opens")
        self.key("ctrl+a")
        self.xdotool("type", "--delay", "5", "a ball")
        self.key("Return")
        self.until(lambda s: s["branches"] == ["main", "a ball"], "it has a name")
        self.press("branch")
        self.press("branch: main")
        s = self.until(lambda s: s["branch"] == 1, "the old one is shown")
        self.assertEqual((s["bodies"], s["end"]), (bodies, end))
        self.press("branch")
        self.press("branch: a ball")
        self.until(lambda s: s["branch"] == 2 and s["steps"] == now["steps"] and s["bodies"] == bodies + 1, "and the new")
        # Undo, redo; what goes on from an undone edit is another branch.
        self.key("ctrl+z")
        self.until(lambda s: s["bodies"] == bodies and s["steps"] == left, "Ctrl+Z goes back to before the shot")
        self.key("ctrl+shift+z")
        self.until(lambda s: s["bodies"] == bodies + 1 and s["steps"] == left, "Ctrl+Shift+Z does it again")
        self.key("ctrl+z")
        self.until(lambda s: s["bodies"] == bodies, "undone")
        self.key("period")
        self.until(lambda s: s["steps"] == left + 1 and len(s["branches"]) == 3 and s["bodies"] == bodies, "a third branch")
        self.press("delete other branches")
        self.until(lambda s: len(s["branches"]) == 1, "the others are gone")
        self.key("ctrl+shift+r")
        self.replayed()

    def test_save_and_open(self):
        self.open("towers")
        self.until(lambda s: s["steps"] > 30, "the run moves")
        self.pause()
        self.xdotool("mousemove", 640, 200)
        self.key("b", "period")
        s = self.until(lambda s: s["bodies"] == 52 and s["paused"], "a ball is shot")
        saved, energy = self.next_pictures()["steps"], self.state()["energy"]
        os.mkdir(os.path.join(self.folder.name, "deep"))
        self.key("ctrl+s")
        self.until(lambda s: s["typing"], "Ctrl+S asks for a name")
        self.key("ctrl+a")
        self.xdotool("type", "--delay", "5", "mine")
        self.press("file: confirm")
        self.until(lambda s: s["message"].endswith("/mine.run"), "it is saved")
        self.key("bracketright")
        self.until(lambda s: s["scene"] != "towers", "another scene")
        self.key("ctrl+o")
        self.until(lambda s: "file: deep/" in s["places"] and "file: mine.run" in s["places"], "Ctrl+O shows files and folders")
        self.press("file: deep/")
        self.until(lambda s: "file: mine.run" not in s["places"], "a click leads into a folder")
        self.press("file: ..")
        self.press("file: mine.run")
        self.press("file: confirm")
        s = self.until(lambda s: s["scene"] == "towers", "it is open")
        self.assertEqual((s["steps"], s["bodies"], s["energy"], s["paused"]), (saved, 52, energy, True))
        self.key("period")
        self.until(lambda s: s["end"] == saved + 1, "it goes on")
        self.key("comma")
        self.until(lambda s: s["end"] == saved + 1 and s["steps"] == saved, "and back")
        # The command line takes it, too; what is no saved run is told so.
        file = os.path.join(self.folder.name, "mine.run")
        run = subprocess.run([harness.PROGRAM, "run", "towers", "--load", file, "--steps", str(saved + 5)],
                             capture_output=True, text=True)
        self.assertIn(f"towers: {saved + 5} steps", run.stdout, run.stderr)
        with open(file, "w") as broken:
            broken.write("nothing")
        self.key("ctrl+o")
        self.press("file: mine.run")
        self.press("file: confirm")
        self.until(lambda s: "mine.run" in s["message"] and "not" in s["message"], "a bad file is told so")

    def test_curves(self):
        self.open("towers")
        s = self.until(lambda s: s["steps"] > 60 and s["curves"].get("total energy", 0) > 50, "energy is measured")
        self.assertEqual(list(s["curves"]), ["total energy", "kinetic energy", "potential energy"])
        self.pause()
        # A curve of the selected body, of its past, too.
        self.click_at(*self.pixel_of([0, 10, 0]))
        self.until(lambda s: s["selected_at"], "a cube is selected")
        self.press("add curve")
        self.until(lambda s: "curves of body" in s["places"], "what can be measured")
        self.press("curves of body")
        self.until(lambda s: "curve: body.y" in s["places"], "of a body")
        self.press("curve: body.y")
        end = self.state()["end"]
        def measured(s): return next((n for name, n in s["curves"].items() if name.endswith(".y")), 0)
        s = self.until(lambda s: measured(s) == end + 1, "its past is measured, too")
        name = next(name for name in s["curves"] if name.endswith(".y"))
        plain = self.plotted()
        for what, act in (("log", lambda: self.press("log", 0.3)), ("linear again", lambda: self.press("log", 0.3)),
                          ("one curve less", lambda: self.press("show kinetic energy", 0.5)),
                          ("against another", lambda: (self.press("over"), self.press(f"over {name}"))),
                          ("against time", lambda: (self.press("over"), self.press("over time")))):
            before = self.plotted()
            act()
            self.until_plotted(before, what)
        # The wheel zooms, the right button shows all again, a click goes to that step.
        self.xdotool("mousemove", *self.place("plot", 0.5))
        for what, act in (("closer", lambda: self.click(4, 3)),
                          ("pulled", lambda: self.drag(1, self.place("plot", 0.5), self.place("plot", 0.3))),
                          ("all", lambda: self.click(3))):
            before = self.plotted()
            act()
            self.until_plotted(before, what)
        self.assertEqual(self.state()["steps"], end)
        self.click_at(*self.place("plot", 0.5))
        self.until(lambda s: abs(s["steps"] - end / 2) < 0.03 * end, "a click goes to that step")
        # Files, with where they come from.
        self.press("export CSV")
        with open(self.file_told("Curves: ")) as file:
            text = file.read()
        self.assertIn("# scenario: towers\n", text)
        rows = list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))
        self.assertEqual(len(rows), end + 1)
        self.assertAlmostEqual(float(rows[3]["total energy [J]"]),
                               float(rows[3]["kinetic energy [J]"]) + float(rows[3]["potential energy [J]"]), delta=0.01)
        self.press("export SVG")
        self.until(lambda s: s["message"].endswith(".svg"), "an SVG")
        picture = xml.etree.ElementTree.parse(self.file_told("Curves: "))
        self.assertIn("scenario: towers", next(picture.iter("{http://www.w3.org/2000/svg}desc")).text)
        self.assertGreater(sum(len(path.get("d")) for path in picture.iter("{http://www.w3.org/2000/svg}path")), 1000)
        self.press(f"remove {name}")
        self.until(lambda s: name not in s["curves"], "a curve is removed")

    def plotted(self):
        self.next_pictures()
        return self.screen.pixels(self.state()["places"]["plot"])

    def until_plotted(self, before, what):
        self.until(lambda s: harness.changed(before, self.plotted()) > 20, f"the plot shows: {what}")


if __name__ == "__main__":
    harness.main()
