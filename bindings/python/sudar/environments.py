"""Environments for learning, with the interface of Gymnasium (https://gymnasium.farama.org/api/env): reset() and step().

    env = sudar.environments.CartPole()
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())

They need no other package. Where Gymnasium is installed they are its Env, with its spaces, and
`gymnasium.make("sudar/CartPole-v0")` makes them once this module was imported.
"""

import math
from typing import Any, Dict, Optional, Tuple

import numpy as np

import sudar

try:
    import gymnasium  # type: ignore
    from gymnasium import Env  # type: ignore
    from gymnasium.spaces import Box, Discrete  # type: ignore
except ImportError:
    gymnasium = None
    from .spaces import Box, Discrete, Env


class Environment(Env):
    """A world in which something acts. Derived classes build it and say what is seen, done and rewarded."""
    metadata: Dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 50}
    dt = 0.02
    """s, of a step"""
    length = 500
    """steps, after which an episode is truncated"""

    def __init__(self, render_mode: Optional[str] = None):
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ValueError(f"render_mode is {render_mode!r}, expected None or one of {self.metadata['render_modes']}")
        self.render_mode = render_mode
        self.world = sudar.World(dt=self.dt, sleep=False)
        self.world.add(sudar.Gravity())
        self.build(self.world)
        self._start = self.world.save()
        self._steps: Optional[int] = None

    def reset(self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None) -> Tuple[np.ndarray, Dict[str, Any]]:
        """Begins an episode. The same seed begins the same ones."""
        super().reset(seed=seed)
        self.world.load(self._start)
        self.begin(self.np_random)
        self._steps = 0
        return self.observe(), {}

    def step(self, action) -> Tuple[np.ndarray, float, bool, bool, Dict[str, Any]]:
        """(observation, reward, terminated, truncated, info)"""
        if self._steps is None:
            raise RuntimeError("reset() comes before step()")
        if not self.action_space.contains(action):
            raise ValueError(f"the action {action!r} is not in {self.action_space}")
        self.act(action)
        self.world.step()
        self._steps += 1
        observation = self.observe()
        terminated = self.over(observation)
        return observation, self.reward(terminated), terminated, not terminated and self._steps >= self.length, {}

    def render(self) -> Optional[np.ndarray]:
        """With render_mode "rgb_array": a picture, (height, width, 3) bytes."""
        if self.render_mode != "rgb_array":
            return None
        return sudar.picture(self.world, size=(480, 360), camera=self.camera)[..., :3]


def _turned(angle: float) -> Tuple[float, float, float, float]:
    """The rotation by `angle` about z."""
    return (0, 0, math.sin(angle / 2), math.cos(angle / 2))


class CartPole(Environment):
    """A pole on a cart, to be kept upright by pushing the cart left (0) or right (1): A. Barto, R. Sutton and C. Anderson,
    Neuronlike adaptive elements that can solve difficult learning control problems, 1983.

    Observed: position [m] and speed [m/s] of the cart, angle [rad, positive to the right] and angular velocity [rad/s] of the
    pole. Reward 1 a step. Over when the cart is 2.4 m off or the pole leans by 12°.
    """
    force = 10.0
    """N"""
    half_pole = 0.5
    """m"""
    camera = ((0, 0.6, 4.5), (0, 0.4, 0))

    def __init__(self, render_mode: Optional[str] = None):
        limit = np.array([4.8, np.inf, math.radians(24), np.inf], np.float32)  # an episode ends half way
        self.observation_space = Box(-limit, limit, dtype=np.float32)
        self.action_space = Discrete(2)
        super().__init__(render_mode)

    def build(self, world):
        thickness, half = 0.05, self.half_pole
        self.cart = world.add(shape=sudar.box((0.4, 0.2, 0.3)), mass=1, name="cart")
        # A slender rod: m (2 half)² / 12, whatever the shape that is drawn.
        self.pole = world.add(shape=sudar.box((thickness, 2 * half, thickness)), at=(0, half, 0), mass=0.1,
                              inertia=np.diag([0.1 * half**2 / 3, 1e-4, 0.1 * half**2 / 3]), name="pole")
        world.join(sudar.Slider(b=self.cart, axis=(1, 0, 0)))
        self.hinge = world.join(sudar.Hinge(a=self.cart, b=self.pole, axis=(0, 0, -1)))

    def begin(self, random):
        self.place(*random.uniform(-0.05, 0.05, 4))

    def place(self, x: float, speed: float, angle: float, spin: float):
        """Puts cart and pole into the state that is observed so."""
        half = self.half_pole
        self.cart.position, self.cart.velocity = (x, 0, 0), (speed, 0, 0)
        self.pole.position = (x + half * math.sin(angle), half * math.cos(angle), 0)
        self.pole.orientation = _turned(-angle)
        self.pole.velocity = (speed + spin * half * math.cos(angle), -spin * half * math.sin(angle), 0)
        self.pole.spin = (0, 0, -spin)

    def act(self, action):
        self.cart.push((self.force if action == 1 else -self.force, 0, 0))

    def observe(self):
        return np.array([self.cart.position[0], self.cart.velocity[0], self.hinge.coordinate, -self.pole.spin[2]], np.float32)

    def over(self, observation):
        return bool(abs(observation[0]) > 2.4 or abs(observation[2]) > math.radians(12))

    def reward(self, terminated):
        return 1.0


class DoublePendulum(Environment):
    """Two rods that hang on each other, to be swung up by a torque at the joint between them: R. Sutton, Generalization in
    reinforcement learning, 1996 (the acrobot), with a torque from −1 to 1 N·m.

    Observed: cosine and sine of the upper rod's angle from hanging down, of the lower one's from the upper one, and the rates of
    both angles [rad/s]. Reward −1 a step until the tip is a rod's length above the upper joint, which ends the episode.
    """
    dt = 0.05
    camera = ((0, 0, 6), (0, 0, 0))
    metadata = {"render_modes": ["rgb_array"], "render_fps": 20}

    def __init__(self, render_mode: Optional[str] = None):
        limit = np.array([1, 1, 1, 1, np.inf, np.inf], np.float32)
        self.observation_space = Box(-limit, limit, dtype=np.float32)
        self.action_space = Box(-1.0, 1.0, (1,), np.float32)
        super().__init__(render_mode)

    def build(self, world):
        rod = dict(shape=sudar.box((0.06, 1, 0.06)), mass=1, inertia=np.diag([1, 1, 1]))
        self.upper = world.add(at=(0, -0.5, 0), name="upper", **rod)
        self.lower = world.add(at=(0, -1.5, 0), name="lower", **rod)
        self.shoulder = world.join(sudar.Hinge(b=self.upper, at=(0, 0, 0)))
        self.elbow = world.join(sudar.Hinge(a=self.upper, b=self.lower, at=(0, -1, 0)))

    def begin(self, random):
        self.place(*random.uniform(-0.1, 0.1, 4))

    def place(self, upper: float, lower: float, upper_rate: float, lower_rate: float):
        """Puts the rods to these angles and rates: of the upper one, and of the lower one against it."""
        both, spin = upper + lower, upper_rate + lower_rate
        self.upper.position = (math.sin(upper) / 2, -math.cos(upper) / 2, 0)
        self.upper.orientation = _turned(upper)
        self.upper.velocity = (upper_rate * math.cos(upper) / 2, upper_rate * math.sin(upper) / 2, 0)
        self.upper.spin = (0, 0, upper_rate)
        self.lower.position = (math.sin(upper) + math.sin(both) / 2, -math.cos(upper) - math.cos(both) / 2, 0)
        self.lower.orientation = _turned(both)
        self.lower.velocity = (upper_rate * math.cos(upper) + spin * math.cos(both) / 2,
                               upper_rate * math.sin(upper) + spin * math.sin(both) / 2, 0)
        self.lower.spin = (0, 0, spin)

    def act(self, action):
        torque = (0, 0, float(action[0]))
        self.lower.twist(torque)
        self.upper.twist(np.negative(torque))

    def observe(self):
        upper, lower = self.shoulder.coordinate, self.elbow.coordinate
        rates = self.upper.spin[2], self.lower.spin[2] - self.upper.spin[2]
        return np.array([math.cos(upper), math.sin(upper), math.cos(lower), math.sin(lower), *rates], np.float32)

    def over(self, observation):
        cos1, sin1, cos2, sin2 = observation[:4]
        return bool(-cos1 - (cos1 * cos2 - sin1 * sin2) > 1)  # how high the tip is

    def reward(self, terminated):
        return 0.0 if terminated else -1.0


if gymnasium:
    for _name in ("CartPole", "DoublePendulum"):
        gymnasium.register(id=f"sudar/{_name}-v0", entry_point=f"sudar.environments:{_name}")
