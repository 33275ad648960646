"""pip installs the package, with an engine and scenarios of its own, and nothing of the build tree is needed afterwards.

    wheel_test.py BUILD
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
USE = """
import json, sudar
session = sudar.Session("train", seconds=0.5)
session.run()
print(json.dumps([sudar.__file__, sudar.__version__, f"{session.world.hash():016x}", len(sudar.scenarios())]))
"""


def python(*arguments, **environment):
    kept = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "LD_LIBRARY_PATH", "SUDAR_SCENARIOS")}
    done = subprocess.run([sys.executable, *map(str, arguments)], capture_output=True, text=True, cwd="/", env={**kept, **environment})
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def main():
    with tempfile.TemporaryDirectory() as folder:
        python("-m", "pip", "install", ROOT, "--no-build-isolation", "--no-index", "--no-deps", "--target", folder,
               "--config-settings", f"build={sys.argv[1]}")
        place, version, here, scenarios = json.loads(python("-c", USE, PYTHONPATH=folder))
        assert place == str(pathlib.Path(folder, "sudar/__init__.py")), place
        assert scenarios == len(list(ROOT.glob("scenarios/*/*.cc"))), scenarios
        mapped = python("-c", "import sudar; print(open('/proc/self/maps').read())", PYTHONPATH=folder)
        libraries = {line.split()[-1] for line in mapped.splitlines() if "libsudar" in line}
        assert len(libraries) == 1 and libraries.pop().startswith(folder), mapped
        there = json.loads(python("-c", USE, PYTHONPATH=os.environ["PYTHONPATH"]))[2]
        assert here == there, (here, there)
        assert {"py.typed", "_core.pyi"} <= set(os.listdir(pathlib.Path(folder, "sudar")))
        assert f"Version: {version}" in python("-m", "pip", "show", "sudar", PYTHONPATH=folder)


if __name__ == "__main__":
    main()
