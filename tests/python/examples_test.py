"""The examples of examples/python run, and tell what they should."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(name, folder="."):
    done = subprocess.run([sys.executable, ROOT / "examples/python" / f"{name}.py"], capture_output=True, text=True, cwd=folder)
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)
    return done.stdout


class Examples(unittest.TestCase):
    def test_friction_is_found(self):
        """The measurement was made of μ = 0.3."""
        self.assertAlmostEqual(float(re.match(r"μ = ([\d.]+)", run("fit_friction"))[1]), 0.3, delta=0.01)

    def test_bounces_follow_the_theory(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("there is no matplotlib")
        with tempfile.TemporaryDirectory() as folder:
            self.assertLess(float(re.search(r"([\d.]+)%", run("sweep", folder))[1]), 2)
            self.assertTrue((pathlib.Path(folder) / "bounces.png").read_bytes().startswith(b"\x89PNG"))

    def test_the_cart_learns(self):
        trials = eval(re.search(r"for (\[.*\]) of 500", run("cart_pole"))[1])
        self.assertGreater(sum(trials), 0.9 * 5 * 500)


if __name__ == "__main__":
    unittest.main()
