"""The installation, as others meet it: moved to another folder, used by CMake, by pkg-config and by a plugin built outside
the repository; and the repository as a part of another project. What examples/ shows is what is built here.

    install_test.py CMAKE BUILD COMPILER [DEFINITIONS OF THE BUILD…]
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from sources import sudar_version

cmake, build, compiler, *definitions = sys.argv[1:]
VERSION = sudar_version()
# Nothing of the build tree may be found by chance. (But ccache has already seen the engine's files, compiled in the same way:
# with relative paths it would not know them again.)
ENVIRONMENT = {k: v for k, v in os.environ.items()
               if k not in ("LD_LIBRARY_PATH", "SUDAR_SCENARIOS", "PKG_CONFIG_PATH", "CCACHE_BASEDIR")}


def run(*command, code=0, **options):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, env=ENVIRONMENT, **options)
    if done.returncode != code:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name).resolve()
        for component in ("library", "development", "program"):
            run(cmake, "--install", build, "--prefix", cls.folder / "before", "--component", component)
        cls.prefix = cls.folder / "a place"  # with a space; nothing may remember the first one
        (cls.folder / "before").rename(cls.prefix)
        cls.program = cls.prefix / "bin/sudar"
        cls.lib = next(cls.prefix.rglob("libsudar.so")).parent

    def example(self, name, *options):
        where = self.folder / name
        run(cmake, "-S", ROOT / "examples" / name, "-B", where, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
            "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={self.prefix}",
            f"-DCMAKE_CXX_COMPILER_LAUNCHER={shutil.which('ccache') or ''}", *options)
        run(cmake, "--build", where)
        return where

    def test_the_library_has_a_version_of_its_interface(self):
        minor = VERSION.rsplit(".", 1)[0]
        self.assertEqual(os.readlink(self.lib / "libsudar.so"), f"libsudar.so.{minor}")
        self.assertEqual(os.readlink(self.lib / f"libsudar.so.{minor}"), f"libsudar.so.{VERSION}")

    def test_the_headers_are_the_public_ones(self):
        def headers(where):
            return sorted(p.relative_to(where) for p in where.rglob("*") if p.is_file())
        self.assertEqual(headers(self.prefix / "include"), sorted([*headers(ROOT / "include"), pathlib.Path("sudar.h")]))

    def test_the_program_finds_its_library_and_its_scenarios(self):
        names = {s["name"] for s in json.loads(run(self.program, "list", "--json"))}
        self.assertEqual(names, {p.stem for p in (ROOT / "scenarios").glob("*/*.cc")})
        self.assertTrue(json.loads(run(self.program, "run", "train", "--json"))["passed"])

    def test_what_an_installed_program_has_around_it(self):
        share = self.prefix / "share"
        self.assertIn("sudar", (share / "man/man1/sudar.1").read_text())
        self.assertIn("complete", (share / "bash-completion/completions/sudar").read_text())

    def test_a_program_built_with_cmake(self):
        self.assertEqual(len(run(self.example("library") / "bouncing_ball").splitlines()), 7)

    @unittest.skipUnless(shutil.which("cc"), "there is no C compiler")
    def test_a_program_in_c(self):
        self.assertEqual(run(self.example("c") / "bouncing_ball"), run(self.example("library") / "bouncing_ball"))

    def test_a_plugin_built_outside(self):
        where = self.example("plugin")
        for left in (30, 90):
            report = json.loads(run(self.program, "--scenarios", where, "run", "see_saw", "--set", f"left={left}", "--json"))
            self.assertTrue(report["passed"], report["checks"])

    def with_pkg_config(self, compiler, source, package):
        """What the program says that is built so."""
        flags = subprocess.run(["pkg-config", "--cflags", "--libs", package], capture_output=True, text=True, check=True,
                               env={**ENVIRONMENT, "PKG_CONFIG_PATH": str(self.lib / "pkgconfig")}).stdout.strip()
        program = self.folder / f"{package}-program"
        # By a shell, which takes away the backslash before the space.
        run("sh", "-c", f"'{compiler}' '{source}' {flags} -o '{program}'")
        return run("env", f"LD_LIBRARY_PATH={self.lib}", program)

    @unittest.skipUnless(shutil.which("pkg-config"), "there is no pkg-config")
    def test_a_program_built_with_pkg_config(self):
        """Every public header can be included, too."""
        source = self.folder / "all.cc"
        includes = sorted(p.name for p in (self.prefix / "include/sudar").glob("*.h"))
        source.write_text("".join(f"#include <sudar/{name}>\n" for name in includes) + "#include <cstdio>\nint main() { "
                          "std::puts(sudar::abi_of_this_engine() == sudar::abi_of_this_file() ? SUDAR_VERSION : \"\"); }\n")
        self.assertEqual(self.with_pkg_config(compiler, source, "sudar").strip(), VERSION)
        self.assertEqual(self.with_pkg_config("cc", ROOT / "examples/c/bouncing_ball.c", "sudar-c").count(" m\n"), 6)

    def test_a_part_of_another_project(self):
        where = self.example("subproject", f"-DSUDAR={ROOT}", *definitions)
        cache = (where / "CMakeCache.txt").read_text()
        self.assertNotIn("BUILD_SHARED_LIBS", cache)
        made = {p.name for p in where.rglob("*") if p.suffix in (".so", ".a") or os.access(p, os.X_OK) and p.is_file()}
        self.assertEqual({m for m in made if "CMake" not in m and not m.endswith((".bin", ".out"))}, {"libsudar.a", "bouncing_ball"})
        # The same bits as the shared library.
        self.assertEqual(run(where / "bouncing_ball"), run(self.example("library") / "bouncing_ball"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
