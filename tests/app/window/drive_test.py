"""The vehicle, driven over the ramp and the bridge with the arrow keys, as a person does: short strokes to the side."""
import harness


class Drive(harness.WindowTest):
    def test_the_vehicle_drives_over_the_bridge_by_hand(self):
        self.open("vehicle")
        self.pause()
        self.xdotool("mousemove", *self.pixel_of([0, 11, 0]), "click", 1)
        self.until(lambda s: s["selected_at"] and abs(s["selected_at"][0]) < 1, "the chassis is selected")
        self.xdotool("key", "p", "keydown", "Up")
        held, steps = None, 0
        while True:
            s = self.until(lambda s: s["steps"] > steps, "the run goes on")
            steps = s["steps"]
            x, y, z = s["selected_at"]
            if x < -351:
                break
            self.assertLess(s["time"], 40, f"the vehicle is at {x:.0f} {y:.0f} {z:.0f} and not over the bridge")
            wanted = self.stroke(s)
            print(f"{s['time']:.2f} {x:.1f} {y:.1f} {z:.2f} {wanted}", flush=True)
            if wanted != held:
                self.xdotool(*(["keyup", held] if held else []), *(["keydown", wanted] if wanted else []))
                held = wanted
        self.xdotool("keyup", "Up")

    @staticmethod
    def stroke(s):
        """The key that turns the vehicle towards −x and to the line z = 0; to its driver, +z is left."""
        i, j, k, w = s["selected_turn"]
        heading = 2 * (i * k + w * j)  # the x of its axles: how far it looks to the left, as a sine
        left = -heading - 0.004 * s["selected_at"][2] - s["selected_spin"][1]
        return "Left" if left > 0.05 else "Right" if left < -0.05 else None


if __name__ == "__main__":
    harness.main()
