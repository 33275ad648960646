"""Sudar: impulse-based simulation of rigid bodies, with the bits of the C++ engine.

    import sudar

    world = sudar.World()
    world.add(sudar.Gravity())
    world.add(shape=sudar.half_space(), motion="fixed")
    ball = world.add(shape=sudar.sphere(0.5), at=(0, 4, 0), material={"restitution": 0.8})
    world.step(600)
    ball.position

SI units, radians, y up. Vectors are any three numbers when given and numpy arrays when got; orientations are quaternions
x, y, z, w; enumerations are strings. Bad data raises `sudar.Error`, which names the field and leaves all as it was.
"""

from ._core import *  # noqa: F401, F403
from ._core import __version__, precision
from .pictures import Player, picture, png
from .results import *  # noqa: F401, F403
