"""Running a scenario: pause, step, restart, speed, the scenarios in turn, search, a scenario's own keys, quit."""
import json
import subprocess

import harness


class Run(harness.WindowTest):
    def test_pause_step_restart_quit(self):
        first = self.open("dominoes")
        self.until(lambda s: s["steps"] > first["steps"] + 100, "the run moves by itself, dominoes fall")
        moving = self.screen.pixels()
        self.until_changed(moving, "the dominoes fall")
        self.key("space")
        self.until(lambda s: s["paused"], "Space pauses")
        steps = self.next_pictures()["steps"]
        still = self.picture()
        self.assertEqual(harness.changed(still, self.picture()), 0)
        for key, more in (("period", 1), ("Right", 1), ("shift+period", 10), ("shift+Right", 10)):
            self.key(key)
            steps += more
            self.until(lambda s: s["steps"] == steps, f"{key} makes {more} steps")
        run = self.state()["run"]
        for key in ("r", "BackSpace"):
            run += 1
            self.key(key)
            s = self.until(lambda s: s["run"] == run, f"{key} restarts")
            self.assertEqual(s["steps"], 0)
            self.assertTrue(s["paused"])
        self.until_changed(still, "the dominoes stand again")
        self.key("p")
        self.until(lambda s: not s["paused"] and s["steps"] > 0, "P runs")
        self.key("ctrl+q")
        self.assertEqual(self.program.wait(harness.PATIENCE), 0)

    def test_speed(self):
        self.open("cradle")
        for key, speed in (("minus", 0.5), ("KP_Subtract", 0.2), ("equal", 0.5), ("plus", 1), ("KP_Add", 2), ("1", 1)):
            self.key(key)
            self.until(lambda s: s["speed"] == speed, f"{key} leads to ×{speed}")
        self.key("minus", "minus", "minus")
        self.until(lambda s: s["speed"] == 0.1 and 0.03 < s["rate"] < 0.2, "slow motion is slow")

    def test_every_scenario_in_turn(self):
        names = [e["name"] for e in json.loads(subprocess.check_output([harness.PROGRAM, "list", "--json"]))]
        self.open(names[0])
        for name in names[1:] + names[:1]:
            before = self.screen.pixels()
            self.key("bracketright")
            self.until(lambda s: s["scene"] == name and s["steps"] > 0, f"] leads to {name}")
            self.assertGreater(harness.changed(before, self.picture()), 100, f"{name} looks like the one before")
        self.key("bracketleft")
        self.until(lambda s: s["scene"] == names[-1], "[ leads back")

    def test_search_takes_the_keys(self):
        self.open("cradle")
        self.key("ctrl+k", "w", "a", "l", "l", "Return")
        s = self.until(lambda s: s["scene"] == "wall", "Ctrl+K finds the wall")
        self.assertFalse(s["paused"] or s["help"] or s["contacts_shown"])

    def test_a_scenarios_keys_win_while_it_runs(self):
        self.open("vehicle")
        self.until(lambda s: s["steps"] > 30, "the vehicle stands")
        keys = {f"key: {key}" for key in ("up", "down", "left", "right")}
        self.until(lambda s: {place for place in s["places"] if place.startswith("key: ")} == keys,
                   "its keys stand on the screen")  # a note is laid out before it is seen
        self.key("ctrl+shift+r")
        before = self.until(lambda s: s["recording"], "the recording begins")["fastest"]
        self.xdotool("keydown", "Up")
        self.until(lambda s: s["fastest"] > before + 1, "Up drives")
        self.xdotool("keydown", "Right")
        s = self.next_pictures()
        self.assertFalse(s["paused"], "Right steers and does not step")
        self.xdotool("keyup", "Up", "keyup", "Right")
        self.key("ctrl+shift+r")
        self.replayed()
        steps = self.pause()["steps"]
        self.key("Right")
        self.until(lambda s: s["steps"] == steps + 1, "Right steps when paused")


if __name__ == "__main__":
    harness.main()
