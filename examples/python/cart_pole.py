#!/usr/bin/env python3
"""Teaches a cart to balance a pole, by the cross-entropy method (R. Rubinstein 1999): of many random policies the best few
say where the next ones are drawn. A policy is four weights: push right where their product with the observation is positive."""

import numpy as np

from sudar.environments import CartPole

random = np.random.default_rng(1)
env = CartPole()


def balanced(weights, seed):
    """For how many steps the pole stays up."""
    observation, _ = env.reset(seed=seed)
    steps = 0
    while True:
        observation, _, terminated, truncated, _ = env.step(int(weights @ observation > 0))
        steps += 1
        if terminated or truncated:
            return steps


mean, spread = np.zeros(4), np.ones(4)
for generation in range(10):
    policies = mean + spread * random.standard_normal((24, 4))
    steps = np.array([balanced(policy, seed=generation) for policy in policies])
    best = policies[np.argsort(steps)[-6:]]
    mean, spread = best.mean(axis=0), best.std(axis=0) + 0.05
    print(f"generation {generation}: {steps.mean():.0f} steps on average, {steps.max()} at best")
    if steps.mean() > 0.8 * env.length:
        break

trials = [balanced(mean, seed=1000 + i) for i in range(5)]
print(f"learned: {np.round(mean, 2)}, keeps the pole up for {trials} of {env.length} steps")
