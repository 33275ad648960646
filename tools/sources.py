"""What the source checks share: which files there are, and the engine's order as the CMake lists state it."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("include", "src", "io", "scenarios", "verify", "bench", "app", "tests", "tools", "examples", "bindings")


def sources(root, folders=FOLDERS):
    """All C++ and Python files below the folders, sorted."""
    return sorted(p for folder in folders for p in (root / folder).rglob("*")
                  if p.suffix in (".h", ".cc", ".py") and p.is_file())


def sudar_version():
    return re.search(r'SUDAR_VERSION "(.*)"', (ROOT / "include/sudar/version.h").read_text()).group(1)


def without_comments(text):
    """C++ text with comments, strings and characters emptied; lines stay where they are."""
    pattern = r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''
    return re.sub(pattern, lambda m: ("" if m.group()[0] == "/" else '""') + "\n" * m.group().count("\n"), text,
                  flags=re.S)


def layers(root):
    """The engine's folders in order: [(folder, [files in order, relative to src/])]."""
    top = re.sub(r"#.*", "", (root / "CMakeLists.txt").read_text())
    result = []
    for folder in re.findall(r"add_subdirectory\(src/(\w+)\)", top):
        text = re.sub(r"#.*", "", (root / "src" / folder / "CMakeLists.txt").read_text())
        lists = re.findall(r"sudar_folder\(([^)]*)\)", text)
        result.append((folder, [f"{folder}/{name}" for names in lists for name in names.split()]))
    return result


def generate(target, text, write):
    """Writes a generated page; without `write` only compares, and returns the complaints."""
    if write:
        target.write_text(text)
    elif not target.exists() or target.read_text() != text:
        return [f"{target.relative_to(ROOT).as_posix()} is not up to date: run its tool with --write"]
    return []
