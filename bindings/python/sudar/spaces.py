"""What Gymnasium's classes of the same names do, as far as `sudar.environments` needs it where Gymnasium is not installed."""

from typing import Any, Dict, Optional

import numpy as np


class Space:
    """Of actions or observations."""

    def __init__(self, shape, dtype, seed: Optional[int]):
        self.shape, self.dtype = tuple(shape), np.dtype(dtype)
        self.seed(seed)

    def seed(self, seed: Optional[int] = None):
        self.np_random = np.random.default_rng(seed)

    def contains(self, x) -> bool:
        raise NotImplementedError

    def __contains__(self, x) -> bool:
        return self.contains(x)


class Box(Space):
    """Arrays between `low` and `high`, which are numbers or arrays."""

    def __init__(self, low, high, shape=None, dtype=np.float32, seed: Optional[int] = None):
        super().__init__(np.shape(low) if shape is None else shape, dtype, seed)
        self.low = np.full(self.shape, low, self.dtype)
        self.high = np.full(self.shape, high, self.dtype)

    def sample(self) -> np.ndarray:
        """Even between the bounds; normal where there are none."""
        bounded = np.isfinite(self.low) & np.isfinite(self.high)
        even = self.np_random.uniform(np.where(bounded, self.low, 0), np.where(bounded, self.high, 0))
        return np.where(bounded, even, self.np_random.normal(size=self.shape)).astype(self.dtype)

    def contains(self, x) -> bool:
        return (isinstance(x, np.ndarray) and x.shape == self.shape and np.can_cast(x.dtype, self.dtype)
                and bool(np.all((self.low <= x) & (x <= self.high))))

    def __repr__(self):
        return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"


class Discrete(Space):
    """The whole numbers from 0 to n − 1."""

    def __init__(self, n: int, seed: Optional[int] = None):
        super().__init__((), np.int64, seed)
        self.n = n

    def sample(self) -> np.int64:
        return np.int64(self.np_random.integers(self.n))

    def contains(self, x) -> bool:
        return isinstance(x, (int, np.integer)) and bool(0 <= x < self.n)

    def __repr__(self):
        return f"Discrete({self.n})"


class Env:
    """What an environment inherits."""
    metadata: Dict[str, Any] = {"render_modes": []}
    render_mode: Optional[str] = None
    spec: Any = None
    np_random: np.random.Generator

    def reset(self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None):
        if seed is not None or not hasattr(self, "np_random"):
            self.np_random = np.random.default_rng(seed)

    @property
    def unwrapped(self):
        return self

    def close(self):
        pass

    def __enter__(self):
        return self

    def __exit__(self, *args):
        self.close()
