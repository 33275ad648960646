"""The environments: the interface that Gymnasium documents, and the equations of motion of the literature."""

import importlib
import math
import sys
import types
import unittest
import unittest.mock

import numpy as np

import sudar
from sudar import environments

ALL = (environments.CartPole, environments.DoublePendulum)


class Interface(unittest.TestCase):
    def test_reset_and_step_return_what_they_must(self):
        for kind in ALL:
            with self.subTest(kind.__name__), kind() as env:
                with self.assertRaises(RuntimeError):
                    env.step(env.action_space.sample())
                observation, info = env.reset(seed=3)
                self.assertIn(observation, env.observation_space)
                self.assertEqual((observation.dtype, info), (np.dtype(np.float32), {}))
                for _ in range(20):
                    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
                    self.assertIn(observation, env.observation_space)
                    self.assertEqual([type(x) for x in (reward, terminated, truncated, info)], [float, bool, bool, dict])
                    if terminated:
                        break
                self.assertIs(env.unwrapped, env)
                self.assertIn("rgb_array", env.metadata["render_modes"])
                self.assertIsNone(env.render())
                for wrong in (7, None, np.array([5.0], np.float32)):
                    with self.assertRaises(ValueError):
                        env.step(wrong)
                with self.assertRaises(ValueError):
                    kind(render_mode="hologram")

    def test_the_same_seed_gives_the_same_bits(self):
        for kind in ALL:
            def run(env, seed):
                env.action_space.seed(1)
                return [env.reset(seed=seed)[0], *(env.step(env.action_space.sample())[0] for _ in range(8))]
            env = kind()
            first, other, again = run(env, 5), run(env, 6), run(kind(), 5)
            np.testing.assert_array_equal(first, again)
            np.testing.assert_array_equal(first, run(env, 5))
            self.assertFalse(np.array_equal(first, other))

    def test_without_a_seed_the_next_episode_is_another(self):
        env = environments.CartPole()
        self.assertFalse(np.array_equal(env.reset(seed=1)[0], env.reset()[0]))

    def test_ends(self):
        env = environments.CartPole()
        env.reset(seed=1)
        steps = 0
        while True:
            _, reward, terminated, truncated, _ = env.step(1)
            steps += 1
            self.assertEqual(reward, 1)
            if terminated or truncated:
                break
        self.assertTrue(terminated and not truncated and steps < 20, steps)
        env = environments.DoublePendulum()
        env.reset(seed=1)
        ends = [env.step(np.zeros(1, np.float32))[2:4] for _ in range(env.length)]
        self.assertEqual(ends, [(False, False)] * (env.length - 1) + [(False, True)])
        env.place(math.pi * 0.9, 0, 0, 0)
        self.assertEqual(env.step(np.zeros(1, np.float32))[1:3], (0, True))

    def test_with_gymnasium_they_are_its_own(self):
        """It is not in Debian: a stand-in with its names shows what is inherited and registered."""
        registered = {}
        stand_in = types.ModuleType("gymnasium")
        stand_in.Env = type("Env", (environments.Env,), {})
        stand_in.spaces = types.ModuleType("gymnasium.spaces")
        stand_in.spaces.Box, stand_in.spaces.Discrete = environments.Box, environments.Discrete
        stand_in.register = lambda id, entry_point: registered.update({id: entry_point})
        with unittest.mock.patch.dict(sys.modules, {"gymnasium": stand_in, "gymnasium.spaces": stand_in.spaces}):
            module = importlib.reload(environments)
            self.assertTrue(issubclass(module.CartPole, stand_in.Env))
            self.assertEqual(registered, {f"sudar/{n}-v0": f"sudar.environments:{n}" for n in ("CartPole", "DoublePendulum")})
            module.CartPole().reset(seed=1)
        importlib.reload(environments)


class Mechanics(unittest.TestCase):
    def test_the_cart_pole_moves_as_its_equations_say(self):
        """R. Florian, Correct equations for the dynamics of the cart-pole system, 2007, without friction."""
        env = environments.CartPole()
        env.reset(seed=1)
        state = np.array([0.1, -0.3, 0.15, 0.4])
        env.place(*state)
        cart, pole, half, g = 1.0, 0.1, 0.5, 9.81

        def rate(s, force):
            _, v, angle, spin = s
            sin, cos = math.sin(angle), math.cos(angle)
            push = (force + pole * half * spin**2 * sin) / (cart + pole)
            turn = (g * sin - cos * push) / (half * (4 / 3 - pole * cos**2 / (cart + pole)))
            return np.array([v, push - pole * half * turn * cos / (cart + pole), spin, turn])

        for action in (1, 0, 0, 1, 1, 1, 0, 1, 0, 0):
            observation = env.step(action)[0]
            for _ in range(200):  # Runge and Kutta's midpoint
                h, force = env.dt / 200, 10 if action else -10
                state = state + h * rate(state + h / 2 * rate(state, force), force)
        np.testing.assert_allclose(observation, state, atol=4e-3)

    def test_the_double_pendulum_keeps_its_energy(self):
        env = environments.DoublePendulum()
        env.reset(seed=1)
        env.place(2, 1, 0, 0)
        before = env.world.energy.total
        spread = []
        for _ in range(200):
            env.step(np.zeros(1, np.float32))
            spread.append(env.world.energy.total - before)
        self.assertLess(np.ptp(spread), 0.01 * 2 * 9.81 * 2)
        self.assertGreater(np.abs(env.observe()[4:]).max(), 0.5)

    def test_the_torque_is_internal(self):
        env = environments.DoublePendulum()
        env.reset(seed=1)
        env.world.forces[0].remove()
        env.place(0, 0, 0, 0)
        env.step(np.ones(1, np.float32))
        upper, lower = env.upper.spin[2], env.lower.spin[2]
        self.assertLess(upper, 0)
        self.assertGreater(lower, 0)
        # About the shoulder, which holds the rest, there is no torque.
        momentum = sum(b.angular_momentum[2] + b.mass * np.cross(b.center, b.velocity)[2] for b in (env.upper, env.lower))
        self.assertAlmostEqual(momentum, 0, places=4)


if __name__ == "__main__":
    unittest.main()
