"""The vehicle, driven over the ramp and the bridge with the arrow keys, as a person does: in short strokes."""
import harness

SPEED = 8  # m/s; at full speed it jumps over the bridge instead, and at 12 with the strokes that a busy machine leaves
BRIDGE, OVER = (-240, -330), -351  # x, m
RIDE = 37  # m: planks of 2 m at y = 30, the wheels' radius 6 m


class Drive(harness.WindowTest):
    def test_the_vehicle_drives_over_the_bridge_by_hand(self):
        self.open("vehicle")
        self.pause()
        self.xdotool("mousemove", *self.pixel_of([0, 11, 0]), "click", 1)
        self.until(lambda s: s["selected_at"] and abs(s["selected_at"][0]) < 1, "the chassis is selected")
        self.key("p")
        held, heights, before = set(), [], self.state()
        while before["selected_at"][0] > OVER:
            s = self.until(lambda s: s["steps"] > before["steps"], "the run goes on")
            x, y, z = s["selected_at"]
            self.assertLess(s["time"], 80, f"the vehicle is at {x:.0f} {y:.0f} {z:.0f} and not over the bridge")
            self.assertLess(abs(z), 40, f"the vehicle left the way at {x:.0f} {y:.0f} {z:.0f}")
            if BRIDGE[1] < x < BRIDGE[0]:
                heights.append(y)
            wanted = self.strokes(s, before)
            for key in held ^ wanted:
                self.xdotool("keydown" if key in wanted else "keyup", key)
            held, before = wanted, s
        self.assertGreater(len(heights), 10)
        self.assertLess(abs(sum(heights) / len(heights) - RIDE), 5, "it rides on the planks")
        self.assertGreater(min(heights), RIDE / 2, "it never fell to the ground, where it rides 11 m high")

    @staticmethod
    def strokes(s, before):
        """The keys that keep the speed, and turn the vehicle towards −x and to the line z = 0: +z is to its left."""
        i, j, k, w = s["selected_turn"]
        heading = 2 * (i * k + w * j)  # the x of its axles: the sine of the angle that it looks to the left
        left = -heading - 0.004 * s["selected_at"][2] - s["selected_spin"][1]
        slow = before["selected_at"][0] - s["selected_at"][0] < SPEED * (s["time"] - before["time"])
        return ({"Up"} if slow else set()) | ({"Left"} if left > 0.05 else {"Right"} if left < -0.05 else set())


if __name__ == "__main__":
    harness.main()
