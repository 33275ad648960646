#!/usr/bin/env python3
"""How long does a ball bounce? A sweep over the coefficient of restitution, beside the closed form: the sum of a geometric
series, t = √(2 h / g) (1 + e) / (1 − e).

    sweep.py [PICTURE.PNG]
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import sudar

height = 1.0  # of the fall, m
restitution = np.linspace(0.1, 0.8, 15)
times = []
for e in restitution:
    world = sudar.World(dt=1 / 1000, substeps=1)
    world.add(sudar.Gravity())
    world.add(shape=sudar.half_space(), motion="fixed", material={"restitution": e})
    ball = world.add(shape=sudar.sphere(0.1), at=(0, height + 0.1, 0), material={"restitution": e})
    last = 0.0
    while world.time < 10 and not ball.asleep:
        world.step()
        if world.events.hits:
            last = world.time
    times.append(last)

theory = np.sqrt(2 * height / 9.81) * (1 + restitution) / (1 - restitution)
plt.plot(restitution, theory, label="theory")
plt.plot(restitution, times, "o", label="Sudar")
plt.xlabel("coefficient of restitution")
plt.ylabel("time until the last bounce [s]")
plt.legend()
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "bounces.png", dpi=150)
print(f"largest deviation {np.max(np.abs(times / theory - 1)):.1%}")
