#!/usr/bin/env python3
"""Which coefficient of friction had a block that slid across a table? Its positions were measured every 0.1 s with an error of
2 mm. Forty simulations side by side, each with another μ; then a parabola through the three best."""

import numpy as np

import sudar

times = np.arange(0.1, 0.75, 0.1)  # s
measured = np.array([0.185, 0.342, 0.467, 0.565, 0.634, 0.671, 0.682])  # m
start_speed = 2.0  # m/s

world = sudar.World(dt=0.01)
world.add(sudar.Gravity())
table = world.add(shape=sudar.half_space(), motion="fixed")
block = world.add(shape=sudar.box((0.2, 0.1, 0.2)), at=(0, 0.05, 0), velocity=(start_speed, 0, 0))

candidates = np.linspace(0.05, 0.6, 40)
batch = sudar.WorldBatch(world, len(candidates))
for mu, copy in zip(candidates, batch):
    copy.set_pair_material(copy[table], copy[block], sudar.Material(friction_static=mu, friction_dynamic=mu))

index = world.bodies.index(block)
simulated = []
for _ in times:
    batch.step(10)
    simulated.append(batch.positions[:, index, 0])
errors = np.sum((np.array(simulated) - measured[:, None]) ** 2, axis=0)

best = np.argmin(errors)
near = slice(best - 1, best + 2)
parabola = np.polyfit(candidates[near], errors[near], 2)
mu = -parabola[1] / (2 * parabola[0])
print(f"μ = {mu:.3f}, positions off by {1000 * np.sqrt(np.polyval(parabola, mu) / len(times)):.1f} mm (root mean square)")
