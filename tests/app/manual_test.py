"""The manual page and the completions of the shell, made of the program's --help.

    manual_test.py PROGRAM
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
program = pathlib.Path(sys.argv[1]).resolve()


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run([sys.executable, ROOT / "tools/manual.py", program, folder.name], check=True)

    def completed(self, *words):
        """What bash offers for the last of them."""
        script = (f"source {self.folder}/sudar.bash; shift; COMP_WORDS=({program} \"$@\"); COMP_CWORD=$#; _sudar; "
                  "printf '%s\\n' \"${COMPREPLY[@]}\"")
        out = subprocess.run(["bash", "-c", script, "bash", "sudar", *words], capture_output=True, text=True, check=True)
        self.assertEqual(out.stderr, "")
        return out.stdout.split()

    def test_the_page_has_every_command_and_option(self):
        page = (self.folder / "sudar.1").read_text().replace("\\-", "-")
        commands = re.findall(r"^  (\w+) ", subprocess.run([program, "--help"], capture_output=True, text=True).stdout.partition("Subcommands:")[2], re.M)
        self.assertIn("run", commands)
        for command in commands:
            section = re.search(rf"^\.SH SUDAR {command.upper()}\n(.*?)^\.SH", page, re.M | re.S)[1]
            text = subprocess.run([program, command, "--help"], capture_output=True, text=True).stdout
            for option in re.findall(r"^  (-\S+)", text, re.M):
                self.assertIn(f".B {option}", section)

    def test_completions(self):
        self.assertEqual(self.completed("ru"), ["run"])
        self.assertEqual(self.completed("run", "domin"), ["dominoes"])
        self.assertEqual(self.completed("run", "dominoes", "--no-s"), ["--no-sleep"])
        self.assertEqual(self.completed("run", "--no-sleep", "domin"), ["dominoes"])
        self.assertEqual(self.completed("run", "--solver", "soft"), ["soft_step"])
        self.assertEqual(self.completed("render", "x", "--colour", "sp"), ["speed"])
        self.assertEqual(self.completed("run", "dominoes", "--csv", ""), [])  # a file: bash's own business
        self.assertEqual(self.completed("replay", "--ch"), ["--check"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
