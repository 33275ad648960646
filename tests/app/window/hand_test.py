"""The hand in the scene: camera, select, drag, twist, follow, shoot, add, delete; all of it recorded."""
import harness

BRICK = (620, 440)  # pixels: the wall when the window opens


class Hand(harness.WindowTest):
    def test_drag_shoot_add_delete_recorded(self):
        bodies = self.open("wall")["bodies"]
        self.key("ctrl+shift+r")
        self.until(lambda s: s["recording"], "Ctrl+Shift+R records")
        self.xdotool("mousemove", *BRICK, "mousedown", 1)
        s = self.until(lambda s: s["dragging"] and s["selected_at"], "the mouse takes a brick")
        grabbed = s["selected_at"]
        self.xdotool("mousemove", 660, 200)
        self.until(lambda s: s["selected_at"] and s["selected_at"][1] > grabbed[1] + 1, "the brick rises")
        self.xdotool("mouseup", 1)
        self.until(lambda s: not s["dragging"], "the mouse lets go")
        for key, what in (("b", "shoots a ball"), ("Insert", "adds a box"), ("shift+Insert", "adds a sphere")):
            self.key(key)
            bodies += 1
            self.until(lambda s: s["bodies"] == bodies, f"{key} {what}")
        self.key("Delete")
        self.until(lambda s: s["bodies"] == bodies - 1 and s["selected"] == -1, "Delete removes the brick")
        self.key("ctrl+shift+r")
        self.until(lambda s: not s["recording"], "the recording ends")
        self.replayed()

    def test_a_scenario_without_its_body_is_told_once(self):
        self.open("towers")
        self.pause()
        self.click_at(*self.pixel_of([0, 10, 0]))
        self.until(lambda s: s["selected"] >= 0, "a click selects a cube, which the scenario watches")
        self.key("Delete", "p")
        s = self.until(lambda s: s["abandoned"], "the scenario misses its cube")
        self.assertIn("without it", s["message"])
        later = self.until(lambda now: now["steps"] > s["steps"] + 20, "the world goes on")
        self.assertEqual(later["messages"], s["messages"], "it is told once")
        self.key("r")
        self.until(lambda now: now["run"] == s["run"] + 1 and now["steps"] > 20 and not now["abandoned"], "R starts anew")

    def test_added_bodies_are_seen(self):
        self.open("dominoes")
        self.pause()
        for x, key in ((560, "Insert"), (640, "shift+Insert"), (720, "b")):
            self.xdotool("mousemove", x, 200)
            before = self.picture()
            bodies = self.state()["bodies"]
            self.key(key)
            self.until(lambda s: s["bodies"] == bodies + 1, f"{key} adds a body")
            self.until_changed(before, f"what {key} added")

    def test_twist_recorded(self):
        self.open("wall")
        self.key("ctrl+shift+r")
        self.until(lambda s: s["recording"], "the recording begins")
        self.xdotool("keydown", "ctrl", "mousemove", *BRICK, "mousedown", 1)
        self.until(lambda s: s["dragging"] and s["selected_spin"], "Ctrl and the mouse take a brick")
        for x in range(BRICK[0], BRICK[0] + 120, 10):
            self.xdotool("mousemove", x, BRICK[1])
        def turning(s):
            return s["selected_spin"] and sum(w * w for w in s["selected_spin"]) > 0.01
        for x in list(range(740, 760)) * 20:
            if turning(self.state()):
                break
            self.xdotool("mousemove", x, BRICK[1])
            self.next_pictures()
        self.until(turning, "the brick turns")
        self.xdotool("mouseup", 1, "keyup", "ctrl")
        self.until(lambda s: not s["dragging"], "the mouse lets go")
        self.key("ctrl+shift+r")
        self.replayed()

    def test_select_and_cancel(self):
        self.open("wall")
        self.pause_at_start()
        before = self.picture()
        self.click_at(*BRICK)
        self.until(lambda s: s["selected"] >= 0, "a click selects")
        self.until_changed(before, "the selected brick")
        self.key("Escape")
        self.until(lambda s: s["selected"] == -1, "Esc deselects")
        self.click()
        self.until(lambda s: s["selected"] >= 0, "a click selects again")
        self.click_at(640, 40)
        self.until(lambda s: s["selected"] == -1, "a click on the sky deselects")
        self.assertTrue(self.state()["paused"])

    def test_camera(self):
        self.open("dominoes")
        self.pause()
        sky, ground = (640, 50), (640, 560)

        def moves(what, fields, act):
            """The fields of the camera change, the others stay, and the picture follows."""
            before, picture = self.next_pictures(), self.screen.pixels()
            act()
            self.until(lambda s: all(s[f] != before[f] for f in fields), f"{what} moves {fields}")
            after = self.next_pictures()
            self.assertEqual([f for f in ("eye", "target") if after[f] != before[f]], fields, what)
            self.until_changed(picture, what)

        moves("left beside bodies", ["eye"], lambda: self.drag(1, sky, (660, 60), (700, 70)))
        moves("the middle button", ["eye"], lambda: self.drag(2, ground, (620, 550), (600, 540)))
        moves("the right button", ["eye", "target"], lambda: self.drag(3, ground, (640, 550), (650, 540)))

        def shift_middle():
            self.xdotool("keydown", "shift")
            self.drag(2, ground, (650, 555), (660, 550))
            self.xdotool("keyup", "shift")
        moves("Shift and the middle button", ["eye", "target"], shift_middle)
        moves("the wheel", ["eye", "target"], lambda: (self.xdotool("mousemove", *ground), self.click(4, 2)))

        def fly(key):
            before = self.state()["eye"]
            self.xdotool("mousedown", 3, "keydown", key)
            self.until(lambda s: s["eye"] != before, f"{key} flies")
            self.xdotool("keyup", key, "mouseup", 3)
        for key in "wasdqe":
            moves(f"the right button and {key}", ["eye", "target"], lambda: fly(key))
        moves("Home", ["eye", "target"], lambda: self.key("Home"))

    def test_frame_and_follow(self):
        self.open("dominoes")
        self.pause_at_start()
        self.key("Home")
        all_of_it = self.next_pictures()["eye"]
        self.choose_a_body()
        self.key("f")
        near = self.until(lambda s: s["eye"] != all_of_it, "F shows the selected body")["eye"]
        self.assertNotEqual(near, all_of_it)
        self.key("Escape", "f")
        self.until(lambda s: s["eye"] == all_of_it, "F shows all where nothing is selected")
        self.choose_a_body()
        self.key("ctrl+f")
        target = self.until(lambda s: s["follow"], "Ctrl+F follows")["target"]
        self.key("p")
        self.until(lambda s: s["target"] != target, "the camera goes with the body")
        self.key("ctrl+f")
        self.until(lambda s: not s["follow"], "Ctrl+F ends it")

    def choose_a_body(self):
        """The first one that a click in the picture's middle rows meets."""
        for x in range(400, 900, 25):
            for y in (330, 300, 360, 270, 390):
                self.click_at(x, y)
                if self.next_pictures()["selected"] >= 0:
                    return
        self.fail("no body was met")


if __name__ == "__main__":
    harness.main()
