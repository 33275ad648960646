"""The vehicle, driven over the ramp and the bridge with the arrow keys. Not in CTest: it mostly misses the bridge."""
import harness


class Drive(harness.WindowTest):
    def test_the_vehicle_drives_over_the_bridge_by_hand(self):
        self.open("vehicle")
        self.pause()
        self.xdotool("mousemove", *self.pixel_of([0, 11, 0]), "click", 1)
        self.until(lambda s: s["selected_at"] and abs(s["selected_at"][0]) < 1, "the chassis is selected")
        self.key("minus", "p")  # half the speed: a slow machine is slow to steer
        self.until(lambda s: not s["paused"], "the run goes on")
        self.xdotool("keydown", "Up")
        held, last = None, self.state()
        while True:
            s = self.until(lambda s: s["steps"] > last["steps"] + 5, "the run goes on")
            (x, y, z), (x0, _, z0) = s["selected_at"], last["selected_at"]
            last = s
            if x < -351:
                break
            self.assertLess(s["time"], 60, f"the vehicle is at {x:.0f} {y:.0f} {z:.0f} and not over the bridge")
            # To the driver, who goes towards −x, +z is left.
            off = (z - z0) / max(0.05, abs(x - x0)) + 0.02 * z
            wanted = "Right" if off > 0.04 else "Left" if off < -0.04 else None
            if wanted != held:
                if held:
                    self.xdotool("keyup", held)
                if wanted:
                    self.xdotool("keydown", wanted)
                held = wanted
        self.xdotool("keyup", "Up")


if __name__ == "__main__":
    harness.main()
