"""What pip asks for a wheel of the Python package (PEP 517): CMake builds and installs it into a folder, which is zipped.

    pip install . --no-build-isolation
    pip install . --no-build-isolation --config-settings build=build/release     (what is already built there)
"""

import base64
import hashlib
import pathlib
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools"))
from sources import sudar_version

NAME = f"sudar-{sudar_version()}"
METADATA = f"""Metadata-Version: 2.1
Name: sudar
Version: {sudar_version()}
Summary: Impulse-based simulation of rigid bodies, with the same bits everywhere
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
"""


def tag():
    """Of this interpreter on this machine: the module fits no other."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def run(*command):
    subprocess.run([str(c) for c in command], check=True, cwd=ROOT)


def built_tree(settings):
    """A build tree with the package in it: the one asked for, or one of its own."""
    if settings and "build" in settings:
        return pathlib.Path(settings["build"])
    tree = ROOT / "build" / "python"
    run("cmake", "-S", ROOT, "-B", tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DSUDAR_APP=OFF", "-DSUDAR_TESTS=OFF",
        f"-DPython3_EXECUTABLE={sys.executable}")
    run("cmake", "--build", tree)
    return tree


def write_metadata(folder):
    folder.mkdir()
    (folder / "METADATA").write_text(METADATA)
    (folder / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: sudar\nRoot-Is-Purelib: false\nTag: {tag()}\n")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    write_metadata(pathlib.Path(metadata_directory) / f"{NAME}.dist-info")
    return f"{NAME}.dist-info"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    wheel = f"{NAME}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        run("cmake", "--install", built_tree(config_settings), "--prefix", folder, "--component", "python")
        write_metadata(folder / f"{NAME}.dist-info")
        record = f"{NAME}.dist-info/RECORD"
        with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
            rows = []
            for path in sorted(p for p in folder.rglob("*") if p.is_file()):
                name, data = path.relative_to(folder).as_posix(), path.read_bytes()
                archive.writestr(name, data)
                digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                rows.append(f"{name},sha256={digest},{len(data)}\n")
            archive.writestr(record, "".join(rows) + f"{record},,\n")
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    files = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines()
    with tempfile.TemporaryDirectory() as folder, tarfile.open(pathlib.Path(sdist_directory) / f"{NAME}.tar.gz", "w:gz") as archive:
        information = pathlib.Path(folder) / "PKG-INFO"
        information.write_text(METADATA)
        archive.add(information, f"{NAME}/PKG-INFO")
        for name in files:
            archive.add(ROOT / name, f"{NAME}/{name}")
    return f"{NAME}.tar.gz"
