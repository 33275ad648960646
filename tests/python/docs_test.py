"""Every block of Python in the documentation runs as it stands, those of a page one after the other."""

import os
import pathlib
import re
import tempfile
import textwrap
import unittest

import sudar
import sudar.environments

ROOT = pathlib.Path(os.environ["SUDAR_SOURCE"])


class Pages(unittest.TestCase):
    def run_blocks(self, name, blocks):
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                scope = {}
                for block in blocks:
                    exec(compile(block, name, "exec"), scope)
            finally:
                os.chdir(here)

    def test_the_page(self):
        blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs/python.md").read_text(), re.S)
        self.assertGreater(len(blocks), 2)
        self.run_blocks("docs/python.md", blocks)

    def test_docstrings(self):
        for module in (sudar, sudar.environments):
            with self.subTest(module.__name__):
                blocks = re.findall(r"(?:^    .*\n|^\n)+", module.__doc__, re.M)
                code = textwrap.dedent("".join(blocks))
                self.assertIn("sudar", code)
                self.run_blocks(module.__name__, ["import sudar, sudar.environments\n" + code])


if __name__ == "__main__":
    unittest.main()
