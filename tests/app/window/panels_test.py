"""The panels: every item of the menus, buttons, the scenario list, parameters, engine settings; recorded where they change
the run."""
import harness


class Panels(harness.WindowTest):
    def test_every_menu_item(self):
        self.open("wall")
        self.until(lambda s: s["steps"] > 10, "the run moves")
        seen, pressed = set(), {"Quit"}

        def choose(menu, item, holds):
            before = self.next_pictures()
            self.press(menu)
            opened = self.until(lambda s: item in s["places"], f"{menu} opens with {item}")
            seen.update(set(opened["places"]) - set(before["places"]))
            pressed.add(item)
            self.press(item)
            self.until(lambda s: holds(before, s), f"{menu}/{item}")

        def becomes(**fields):
            return lambda before, now: all(now[k] == v for k, v in fields.items())

        def turns(field):
            return lambda before, now: now[field] != before[field]

        choose("File", "Save this run", lambda b, n: "file: confirm" in n["places"])
        self.press("file: cancel")
        choose("File", "Open a saved run", lambda b, n: "file: confirm" in n["places"])
        self.press("file: cancel")
        self.until(lambda s: "file: confirm" not in s["places"], "Cancel closes it")
        choose("Run", "Pause, run", becomes(paused=True))
        choose("Run", "Step", lambda b, n: n["steps"] == b["steps"] + 1)
        choose("Run", "Ten steps", lambda b, n: n["steps"] == b["steps"] + 10)
        choose("Run", "Step back", lambda b, n: n["steps"] == b["steps"] - 1)
        choose("Run", "Ten steps back", lambda b, n: n["steps"] == max(0, b["steps"] - 10))
        choose("Run", "To the newest step", lambda b, n: n["steps"] == n["end"])
        choose("Run", "Play backwards, pause", lambda b, n: n["steps"] < n["end"] - 2)
        choose("Run", "Play backwards, pause", becomes(paused=True))
        choose("Run", "Restart", lambda b, n: n["run"] == b["run"] + 1 and n["steps"] == 0)
        choose("Run", "Faster", becomes(speed=2))
        choose("Run", "Real time", becomes(speed=1))
        choose("Run", "Slower", becomes(speed=0.5))
        choose("Run", "Record into out/, stop", becomes(recording=True))
        choose("Run", "Record into out/, stop", becomes(recording=False))
        choose("Run", "Picture into out/", lambda b, n: n["message"].startswith("Picture: "))
        choose("Run", "Movie into out/, stop", becomes(filming=True))
        choose("Run", "Movie into out/, stop", becomes(filming=False))

        self.click_at(620, 440)
        self.until(lambda s: s["selected"] >= 0, "a brick is selected")
        choose("Show", "Show the selected body, or all", turns("eye"))
        choose("Show", "Show all", turns("eye"))
        choose("Show", "Follow the selected body", becomes(follow=True))
        choose("Show", "Follow the selected body", becomes(follow=False))
        choose("Edit", "Shoot a ball", lambda b, n: n["bodies"] == b["bodies"] + 1)
        choose("Edit", "Add a box under the mouse", lambda b, n: n["bodies"] == b["bodies"] + 1)
        choose("Edit", "Add a sphere under the mouse", lambda b, n: n["bodies"] == b["bodies"] + 1)
        choose("Edit", "Undo: back to before the last edit", lambda b, n: n["bodies"] == b["bodies"] - 1)
        choose("Edit", "Redo: to behind the next edit", lambda b, n: n["bodies"] == b["bodies"] + 1)
        choose("Edit", "Remove the selected body", lambda b, n: n["bodies"] == b["bodies"] - 1 and n["selected"] == -1)

        for item, field in (("Contacts", "contacts_shown"), ("Joints", "joints_shown"), ("Forces", "forces_shown"),
                            ("Axes", "axes_shown"), ("Names", "labels_shown"),
                            ("Boxes of the broad phase", "boxes_shown"),
                            ("Cells or tree of the broad phase", "cells_shown"), ("Edges only", "wireframe"),
                            ("Sleeping bodies pale", "sleep_shown"), ("Ghost of the other branch", "ghost_shown"),
                            ("Plots", "plots"), ("Plots", "plots"), ("Help", "help")):
            choose("Show", item, turns(field))
        self.key("F1")
        for n, what in enumerate(("body", "speed", "island", "sleep")):
            choose("Show", f"Colour by {what}", becomes(colouring=n))
        choose("Show", "Next colours", becomes(colouring=0))
        choose("Show", "Full screen", becomes(fullscreen=True))
        choose("Show", "Full screen", becomes(fullscreen=False))
        choose("Run", "Next scenario", turns("scene"))
        choose("Run", "Previous scenario", becomes(scene="wall"))
        choose("Run", "Search scenarios", becomes(typing=True))
        self.key("Escape")
        self.until(lambda s: not s["typing"], "Esc leaves the search")
        choose("Show", "Panels", becomes(panels=False))
        self.key("Tab")
        self.until(lambda s: s["panels"], "Tab brings the panels back")
        self.assertEqual(seen - pressed, set(), "items that this test does not press")
        self.press("Run")
        self.press("Quit")
        self.assertEqual(self.program.wait(harness.PATIENCE), 0)

    def test_every_key_is_tested(self):
        """Each of these is pressed in one of the tests of this folder; a new one needs a test, and its place here."""
        tested = """Ctrl+O Ctrl+S Space . Shift+. , Shift+, Shift+Space End Ctrl+Z Ctrl+Shift+Z H F4 R + - 1 [ ] Ctrl+K F Home Ctrl+F B Insert Shift+Insert Delete C J O N G Shift+G K Z X L
                    Tab F1 F11 Ctrl+P V Ctrl+Shift+R Esc Ctrl+Q"""
        self.assertEqual(sorted(self.open("cradle")["shortcuts"]), sorted(tested.split()))

    def test_buttons(self):
        self.open("cradle")
        self.press("button: Pause, run")
        self.until(lambda s: s["paused"], "the pause button")
        steps = self.next_pictures()["steps"]
        self.press("button: Step")
        self.until(lambda s: s["steps"] == steps + 1, "the step button")
        self.press("button: Restart")
        self.until(lambda s: s["run"] == 2 and s["steps"] == 0, "the restart button")
        self.press("button: Faster")
        self.until(lambda s: s["speed"] == 2, "the + button")
        self.press("button: Slower")
        self.until(lambda s: s["speed"] == 1, "the − button")

    def test_list_and_search_with_the_mouse(self):
        self.open("cradle")
        self.press("scenario: elastic_row")
        self.until(lambda s: s["scene"] == "elastic_row", "a click in the list starts a scenario")
        self.press("search")
        self.xdotool("type", "--delay", "5", "dominoes")
        self.until(lambda s: "scenario: dominoes" in s["places"] and "scenario: elastic_row" not in s["places"],
                   "the list is narrowed")
        self.press("scenario: dominoes")
        self.until(lambda s: s["scene"] == "dominoes", "a click starts what was found")

    def test_a_parameter_and_a_setting_are_recorded(self):
        before = self.open("wall")
        self.key("ctrl+shift+r")
        self.until(lambda s: s["recording"] and s["steps"] > 20, "Ctrl+Shift+R records")
        # The slider of "rows", pulled to the left with the mouse: a new run in the same recording.
        x, y = self.place("rows", 0.33)
        self.drag(1, (x, y), (x - 10, y), (x - 20, y))
        s = self.until(lambda s: s["run"] == before["run"] + 1, "a new value restarts")
        self.assertLess(s["parameters"]["rows"], before["parameters"]["rows"])
        self.assertLess(s["bodies"], before["bodies"])
        self.assertTrue(s["recording"])
        self.until(lambda s: s["steps"] > 20, "the new run goes on")
        # Ctrl and a click: the slider becomes a field.
        self.xdotool("keydown", "ctrl", "mousemove", *self.place("columns", 0.2), "mousedown", 1, "mouseup", 1,
                     "keyup", "ctrl")
        self.xdotool("key", "3", "Return")
        s = self.until(lambda s: s["parameters"]["columns"] == 3, "a typed value restarts")
        self.assertEqual(s["run"], before["run"] + 2)
        # A box to tick.
        self.press("ball", 0.1)
        s = self.until(lambda s: s["parameters"]["ball"] == 0, "a ticked box restarts")
        # Another broad phase from the list of them: the run goes on with it.
        self.press("broad")
        self.press("broad: sweep")
        self.until(lambda s: s["config"]["broad"] == "sweep", "the broad phase is exchanged")
        # Numbers typed into fields.
        for field, value in (("substeps", "2"), ("dt", "0.005")):
            self.press(field, 0.3)
            self.key("ctrl+a", *(digit.replace(".", "period") for digit in value), "Return")
            s = self.until(lambda s: float(s["config"][field]) == float(value), f"{field} is exchanged")
        self.assertEqual(s["run"], before["run"] + 3)
        # And from the start: parameters and settings stay.
        self.key("r")
        s = self.until(lambda s: s["run"] == before["run"] + 4 and s["steps"] > 20, "R restarts")
        self.assertEqual(s["parameters"]["columns"], 3)
        self.assertEqual((s["config"]["broad"], s["config"]["substeps"], float(s["config"]["dt"])), ("sweep", "2", 0.005))
        self.key("ctrl+shift+r")
        self.replayed()

    def test_the_solver(self):
        self.open("towers")
        self.press("solver")
        self.press("solver: impulse_2007")
        self.until(lambda s: s["config"]["solver"] == "impulse_2007", "the solver")
        self.press("impulse_2007")
        self.press("shock_propagation", 0.05)
        self.until(lambda s: s["config"]["impulse_2007.shock_propagation"] == "true", "an option of the solver")


if __name__ == "__main__":
    harness.main()
