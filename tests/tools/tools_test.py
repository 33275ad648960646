"""The source checks must find what they are for: each test breaks one rule in a small repository of its own."""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import functions
import golden
import layers
import pictures
import scene_pages
import state_index
import verification_page

GOOD = {
    "CMakeLists.txt": "add_subdirectory(src/base)\nadd_subdirectory(src/math)\n",
    "include/sudar/base.h": "#include <string>\n",
    "include/sudar/math.h": "#include <sudar/base.h>\n",
    "src/base/CMakeLists.txt": "sudar_folder(\n  pool.h pool.cc  # a comment\n  hash.h)\n",
    "src/base/pool.h": "#include <sudar/base.h>\n",
    "src/base/pool.cc": '#include "base/pool.h"\n',
    "src/base/hash.h": '#include "base/pool.h"\n',
    "src/math/CMakeLists.txt": "sudar_folder(lanes.h)\n",
    "src/math/lanes.h": '#include <sudar/math.h>\n#include "base/hash.h"\n#include <cmath>\n',
}


class Layers(unittest.TestCase):
    def breaches(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            for name, text in {**GOOD, **changes.get("files", {})}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return layers.check(root)

    def assert_breach(self, name, text, expected):
        found = self.breaches(files={name: text})
        self.assertTrue(any(expected in breach for breach in found), f"{expected!r} is not in {found}")

    def test_accepts_the_line(self):
        self.assertEqual(self.breaches(), [])

    def test_folder_to_the_right(self):
        self.assert_breach("src/base/pool.h", '#include "math/lanes.h"\n', "src/base/pool.h:1: includes upward: math/lanes.h")

    def test_file_below_in_the_list(self):
        self.assert_breach("src/base/pool.h", '\n#include "base/hash.h"\n', "src/base/pool.h:2: includes upward: base/hash.h")

    def test_public_header_of_a_higher_layer(self):
        self.assert_breach("src/base/pool.h", "#include <sudar/math.h>\n", "sudar/math.h ranks with math")

    def test_public_header_that_includes_upward(self):
        self.assert_breach("include/sudar/base.h", "#include <sudar/math.h>\n", "include/sudar/base.h:1: includes upward")

    def test_public_header_that_includes_the_inside(self):
        self.assert_breach("include/sudar/math.h", '#include "base/pool.h"\n', "includes only public ones")

    def test_public_header_without_rank(self):
        self.assert_breach("include/sudar/extra.h", "\n", "include/sudar/extra.h: public header without a rank")

    def test_file_that_no_list_names(self):
        self.assert_breach("src/base/extra.h", "\n", "src/base/extra.h: no sudar_folder() lists it")

    def test_listed_file_that_is_missing(self):
        self.assert_breach("src/math/CMakeLists.txt", "sudar_folder(lanes.h gone.h)\n", "src/math/gone.h: listed, but")

    def test_foreign_library(self):
        self.assert_breach("src/math/lanes.h", "#include <fmt/core.h>\n", "not of the C++ library: fmt/core.h")

    def test_circle(self):
        self.assert_breach("src/base/pool.h", '#include "base/hash.h"\n',
                           "include circle: src/base/hash.h → src/base/pool.h → src/base/hash.h")

    def test_long_file(self):
        self.assert_breach("src/base/pool.cc", "\n" * 1001, "src/base/pool.cc: 1001 lines")


class Functions(unittest.TestCase):
    TEXT = """#define LOOP(x) { x
namespace a {
struct alignas(16) S {  // a brace in a comment {
  int f() const noexcept { return '{'; }
  S() : x{1} {
    const char* s = "}";
  }
};
template <class T>
  requires(sizeof(T) == 4)
int long_one(T t) {
  if (t) {
    return 1;
  }
  return 2;
}
enum class E { x, y };
}
"""

    def test_finds_every_body(self):
        found = [(last - first + 1, name.split("(")[0].split()[-1]) for first, last, name in functions.functions(self.TEXT)]
        self.assertEqual([lines for lines, _ in found], [1, 3, 8])

    def test_counts_lines(self):
        text = "int f() {\n" + "  g();\n" * 200 + "}\n"
        self.assertEqual([last - first + 1 for first, last, _ in functions.functions(text)], [202])


class Golden(unittest.TestCase):
    WRITTEN = {"wall": {"1": "aa", "100": "bb", "800": "cc"}, "net": {"1": "dd"}}

    def found(self, **changes):
        return golden.differences(self.WRITTEN, {**self.WRITTEN, **changes})

    def test_accepts_the_same(self):
        self.assertEqual(self.found(), [])

    def test_names_motion_and_first_step(self):
        self.assertEqual(self.found(wall={"1": "aa", "100": "ee", "800": "ff"}), ["wall: differs at step 100: ee, expected bb"])

    def test_names_an_end_that_moved(self):
        self.assertEqual(self.found(wall={"1": "aa", "100": "bb", "900": "cc"}),
                         ["wall: differs at step 800: no such step, expected cc"])

    def test_a_motion_too_many_or_too_few(self):
        self.assertEqual(self.found(arch={"1": "aa"}), ["arch: is not written down"])
        self.assertEqual(golden.differences(self.WRITTEN, {"net": {"1": "dd"}}), ["wall: did not run"])

    def test_a_variation_of_nothing(self):
        self.assertEqual(golden.differences({}, {"net": {"1": "a"}, "net fast": {"1": "a"}})[2:],
                         ["net fast: moves as without that setting"])

    def test_keeps_the_reasons_newest_first(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(golden, "FOLDER", pathlib.Path(folder)):
            program = pathlib.Path(folder) / "motions"
            for reason in ("first", "same", "second"):
                hash_ = "bb" if reason == "second" else "aa"
                program.write_text(f"#!/bin/sh\necho '{{\"precision\": \"float\", \"motions\": {{\"wall\": {{\"1\": \"{hash_}\"}}}}}}'\n")
                program.chmod(0o755)
                golden.renew(reason, [program], "1.0 on abc")
            log = (pathlib.Path(folder) / "reasons.md").read_text()
            self.assertEqual([line.rsplit(": ", 1)[1] for line in log.splitlines() if line.startswith("- ")],
                             ["second", "first"])


class StateIndex(unittest.TestCase):
    def fields(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "src" / "dynamics" / "fields.def"
            path.parent.mkdir(parents=True)
            path.write_text(text)
            return state_index.fields(pathlib.Path(folder))

    def test_reads_a_field(self):
        found, complaints = self.fields('FIELD(std::uint8_t, asleep, "1", "sleep")  // not computed\n#undef FIELD\n')
        self.assertEqual(found, {"FIELD": [("asleep", "uint8", "1", "sleep", "not computed")]})
        self.assertEqual(complaints, [])

    def test_a_field_without_meaning(self):
        _, complaints = self.fields('\nFIELD(Pos, position, "m", "solve")\n')
        self.assertEqual(complaints, ["src/dynamics/fields.def:2: not FIELD(type, name, unit, stage) // meaning"])


class Pages(unittest.TestCase):
    PAGE = "| sag | < 1 m | {} | {} s |\n| hits | {} ± 0.1 s | 2 | 3 s |\n| `planks` | {} | 3 … 60 | s |\n"

    def test_findings_may_change(self):
        self.assertEqual(scene_pages.stable(self.PAGE.format(0.7, 3, 2, 15)),
                         scene_pages.stable(self.PAGE.format(0.8, 4, 2.1, 15)))

    def test_limits_and_parameters_may_not(self):
        page = self.PAGE.format(0.7, 3, 2, 15)
        for other in (page.replace("< 1 m", "< 2 m"), self.PAGE.format(0.7, 3, 2, 16), page.replace("sag", "sink")):
            self.assertNotEqual(scene_pages.stable(other), scene_pages.stable(page))

    def test_runs_that_the_text_names(self):
        self.assertEqual(scene_pages.runs_of("with `--set a=1\n--set b=2` it falls, `--json` prints"), ["", "--set a=1 --set b=2"])

    def test_numbers(self):
        self.assertEqual([scene_pages.number(x) for x in (None, 0.1, 1.25e-7, 7.6e9)], ["–", "0.1", "1.25e-7", "7.6e9"])

    def test_pictures_with_their_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text("![A wall](a/wall.png)\n*`sudar render wall --keys \"0:up 1:none\"`*\n\n![other](b.png)\n")
            self.assertEqual(pictures.pictures(page),
                             [(page.parent / "a/wall.png", ["render", "wall", "--keys", "0:up 1:none"])])


class Globals(unittest.TestCase):
    def complaint(self, code):
        tool = pathlib.Path(functions.__file__).parent / "globals.py"
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "a.cc").write_text(code)
            subprocess.run(["c++", "-std=c++20", "-fPIC", "-O2", "-c", "a.cc"], cwd=folder, check=True)
            return subprocess.run([sys.executable, tool, "a.o"], cwd=folder, capture_output=True, text=True)

    def test_constants_are_fine(self):
        result = self.complaint('struct V { virtual ~V(); }; V::~V() {}  const char* const names[] = {"a", "b"};\n'
                                "const char* name(int i) { static const int order[] = {1, 0}; return names[order[i]]; }\n")
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_every_kind_of_variable(self):
        for code in ("int n;", "int n = 3;", "static int n; int f() { return ++n; }", "thread_local int n;",
                     "int f() { static int n; return ++n; }", "struct S { static inline int n = 2; }; int* f() { return &S::n; }",
                     "template <class T> int f() { static int n; return ++n; } int g() { return f<int>(); }",
                     'const char* n[] = {"a"};'):
            with self.subTest(code):
                result = self.complaint(code)
                self.assertEqual(result.returncode, 1)
                self.assertIn("n", result.stdout)



class VerificationPage(unittest.TestCase):
    INDEX = """<tr class="ours"><td>Sudar</td><td>2.400</td><td>−0.1 %</td></tr>
<tr><td><a href="V01.html">V01 Fall</a></td><td class="n">0.1</td><td class="good">✓ passes</td></tr>
<tr><td><a href="V37.html">V37 Hulls</a></td><td class="n">0.1</td><td class="good">✓ passes</td></tr>
<tr><td><a href="V42.html">V42 Fast</a></td><td class="n">–</td><td class="bad">✗ fails</td></tr>
<tr><td><a href="B2.html">B2 666</a></td><td class="n">2</td><td class="bad">✗ fails</td></tr>
"""
    PAGE = """2 of 3 cases pass, 1 of the 2 that have a solver; 1 fail. Measured
| V42 fast bodies | exact | got | why |
| B2 666 | exact | got | why |
| **Sudar, impulse_2007, 60/4** | 2.400 | −0.1 % |
"""

    def test_accepts_what_agrees(self):
        self.assertEqual(verification_page.compare(self.PAGE, self.INDEX), (self.PAGE, []))

    def test_row_and_numbers_are_put_right(self):
        stale = self.PAGE.replace("2.400", "2.600").replace("2 of 3", "3 of 3")
        self.assertEqual(verification_page.compare(stale, self.INDEX)[0], self.PAGE)

    def test_failure_without_explanation(self):
        page = self.PAGE.replace("| B2 666 |", "| V01 fall |")
        self.assertEqual(verification_page.compare(page, self.INDEX)[1],
                         ["B2 fails and is not explained", "V01 is explained and passes"])


if __name__ == "__main__":
    unittest.main()
