"""Pictures, and what notebooks show."""

import threading
import unittest

import numpy as np

import sudar
import sudar.environments


def scene():
    world = sudar.World()
    world.add(shape=sudar.half_space(), motion="fixed")
    world.add(shape=sudar.sphere(0.5), at=(0, 0.5, 0), name="ball")
    return world


class Pictures(unittest.TestCase):
    def test_shape_and_content(self):
        world = scene()
        pixels = sudar.picture(world, (160, 90), camera=((0, 1, 4), (0, 0.5, 0)))
        self.assertEqual((pixels.shape, pixels.dtype), ((90, 160, 4), np.dtype(np.uint8)))
        world["ball"].remove()
        empty = sudar.picture(world, (160, 90), camera=((0, 1, 4), (0, 0.5, 0)))
        changed = np.any(pixels != empty, axis=2)
        self.assertTrue(changed[45, 80])  # the ball, in the middle
        self.assertFalse(changed[2, 2])   # the sky beside it

    def test_from_any_thread(self):
        world, drawn = scene(), []
        first = sudar.picture(world, (64, 64))
        thread = threading.Thread(target=lambda: drawn.append(sudar.picture(world, (64, 64))))
        thread.start()
        thread.join()
        np.testing.assert_array_equal(drawn[0], first)

    def test_bad_arguments_are_named(self):
        for arguments, field in (({"size": (0, 5)}, "size"), ({"camera": ((0, 0, 0), (0, 0, 0))}, "camera"),
                                 ({"camera": (1,)}, "camera"), ({"colour": "red"}, "colour")):
            with self.subTest(field), self.assertRaises(sudar.Error) as caught:
                sudar.picture(scene(), **arguments)
            self.assertEqual(caught.exception.field, field)

    def test_notebooks_show_a_picture_and_numbers(self):
        shown = scene()._repr_html_()
        self.assertRegex(shown, r'<img [^>]*src="data:image/png;base64,iVBOR')
        self.assertIn("<td>bodies</td><td>2</td>", shown)
        self.assertIn("<b>train</b>", sudar.Session("train")._repr_html_())

    def test_a_player_has_a_picture_for_every_moment(self):
        session = sudar.Session("dominoes")
        player = sudar.Player(session, seconds=1, frames_per_second=10, size=(64, 36))
        self.assertAlmostEqual(session.world.time, 1, places=9)
        self.assertEqual(len(player.frames), 11)
        self.assertGreater(len(set(player.frames)), 5)
        shown = player._repr_html_()
        self.assertEqual(shown.count("data:image/png"), 12)  # all, and the first once more
        self.assertIn('max="10"', shown)

    def test_environments_render(self):
        env = sudar.environments.CartPole(render_mode="rgb_array")
        env.reset(seed=1)
        frame = env.render()
        self.assertEqual((frame.shape, frame.dtype), ((360, 480, 3), np.dtype(np.uint8)))
        self.assertGreater(frame.std(), 1)


if __name__ == "__main__":
    unittest.main()
