#!/usr/bin/env python3
"""Writes the types of the compiled module for editors and type checkers, sudar/_core.pyi, from the module itself:
signatures from its docstrings, fields from its definitions.

    PYTHONPATH=build/release/python bindings/python/tools/stubs.py [--write]     without it only compares
"""

import inspect
import pathlib
import re
import sys

import sudar._core as core
import sudar.results as results

TARGET = pathlib.Path(__file__).resolve().parents[1] / "sudar/_core.pyi"
HEAD = '''# Written by bindings/python/tools/stubs.py.
from os import PathLike
from typing import Any, Dict, Iterator, List, Literal, Optional, Sequence, Union, overload

import numpy as np

from .results import {results}

Array = np.ndarray
"""float64"""
Numbers = Union[Sequence[float], np.ndarray]
NumberRows = Union[Sequence[Sequence[float]], np.ndarray]

__version__: str
precision: Literal["float", "double"]

class Error(ValueError):
    """{error}"""
    field: str
'''
# Keyword arguments that are the fields of a definition.
FIELDS_OF = {"World.__init__": "Config", "World.configure": "Config", "World.add": "BodyDef", "Body.add_shape": "ShapeDef"}
GIVEN = {"Vector": "Numbers", "Quaternion": "Numbers", "Matrix": "NumberRows", "Array": "Union[float, Numbers, NumberRows]"}
GOT = {"Vector": "Array", "Quaternion": "Array", "Matrix": "Array"}
DEFINITIONS = [name for name, kind in vars(core).items() if hasattr(kind, "_fields") and inspect.isclass(kind)]


def type_of(text, names):
    text = text.replace("sudar._core.", "").replace("numpy.ndarray[numpy.float64]", "Array").strip()
    text = re.sub(r"\bobject\b", "Any", text)
    return re.sub(r"\b(Vector|Quaternion|Matrix|Array)\b", lambda m: names.get(m[0], m[0]), text)


def given(text):
    """The type of an argument: a definition may be given as a dict of its fields."""
    return re.sub(r"\w+", lambda m: f"Union[{m[0]}, Dict[str, Any]]" if m[0] in DEFINITIONS else m[0], type_of(text, GIVEN))


def parts(text):
    """The arguments: split at commas outside brackets."""
    result, depth, start = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "[({") - (c in "])}")
        if c == "," and depth == 0:
            result.append(text[start:i])
            start = i + 1
    return [p.strip() for p in [*result, text[start:]] if p.strip()]


def fields(definition, indent):
    """As keyword arguments."""
    return "".join(f"\n{indent}    {name}: {given(kind)} = ...," for name, kind, _, _ in getattr(core, definition)._fields)


def docstring(text, indent):
    text = re.sub(r'"$', r'\\"', text.strip())
    return f'\n{indent}    """{text}"""' if text else " ..."


def function(owner, signature, text, indent):
    name, arguments, got = re.fullmatch(r"(\w+)\((.*)\) -> (.*)", signature).groups()
    out, key = [], f"{owner}.{name}" if owner else name
    for i, argument in enumerate(parts(arguments)):
        what, _, kind = argument.partition(":")
        kind, default = (kind.rsplit(" = ", 1) + [""])[:2] if " = " in kind else (kind, "")
        if owner and i == 0 and what == "self":
            out.append("self")
        elif what == "**kwargs":
            definition = FIELDS_OF.get(key)
            out += ([] if "*" in out else ["*"]) + [fields(definition, indent)] if definition else ["**parameters: float"]
        elif what in ("*", "/", "*args"):
            out.append(what)
        elif what.startswith("arg"):
            out.append("__other: object" if name == "__eq__" else f"__{what}: {type_of(kind, GIVEN)}")
        else:
            out.append(f"{what}: {type_of(kind, GIVEN)}" + (" = ..." if default else ""))
    got = type_of(got, GOT)
    joined = ", ".join(out).replace(", \n", ",\n")
    return f"{indent}def {name}({joined}) -> {got}:{docstring(text, indent)}\n"


def functions(owner, f, indent):
    """One signature, or several."""
    text = f.__doc__
    numbered = re.findall(r"^\d+\. (\w+\(.*\) -> .*)\n*((?:(?!^\d+\. ).*\n?)*)", text, re.M) if "Overloaded function." in text else None
    if numbered:
        return "".join(f"{indent}@overload\n" + function(owner, s, t, indent) for s, t in numbered)
    signature, _, rest = text.partition("\n")
    return function(owner, signature, rest, indent)


def definition_class(name, kind):
    out = [f"class {name}:{docstring(kind.__doc__ or '', '') if kind.__doc__ else ''}"]
    for field, annotation, _, text in kind._fields:
        out.append(f"    {field}: {type_of(annotation, GOT)}" + (f'\n    """{text}"""' if text else ""))
    for method in ("__init__", "replace"):
        got = "None" if method == "__init__" else name
        text = docstring(getattr(kind, method).__doc__.partition("\n")[2], "    ") if method == "replace" else " ..."
        arguments = "self, *," + fields(name, "    ") if kind._fields else "self"
        out.append(f"    def {method}({arguments}) -> {got}:{text}")
    return "\n".join(out) + "\n"


def plain_class(name, kind):
    out = [f"class {name}:" + (f'\n    """{kind.__doc__}"""' if kind.__doc__ else "")]
    for member, value in vars(kind).items():
        if isinstance(value, property):
            got = re.search(r"-> (.*)", value.fget.__doc__)[1]
            text = value.__doc__ or ""
            text = "" if "->" in text.partition("\n")[0] else text
            out.append(f"    @property\n    def {member}(self) -> {type_of(got, GOT)}:{docstring(text, '    ')}")
            if value.fset:
                out.append(f"    @{member}.setter\n    def {member}(self, value: {given(got)}) -> None: ...")
        elif isinstance(value, staticmethod):
            out.append("    @staticmethod\n" + functions(name, getattr(kind, member), "    ").rstrip())
        elif callable(value) and getattr(value, "__doc__", None) and "->" in value.__doc__:
            out.append(functions(name, value, "    ").rstrip())
    return "\n".join(out) + "\n"


def text():
    names = [n for n, k in vars(results).items() if inspect.isclass(k) and k.__module__ == results.__name__]
    out = [HEAD.format(results=", ".join(names), error=core.Error.__doc__)]
    for name, value in vars(core).items():
        if name.startswith("_") or name in ("Error", "precision"):
            continue
        if inspect.isclass(value):
            out.append((definition_class if hasattr(value, "_fields") else plain_class)(name, value))
        else:
            out.append(functions("", value, ""))
    return "\n".join(out)


def main():
    if "--write" in sys.argv:
        TARGET.write_text(text())
    elif not TARGET.exists() or TARGET.read_text() != text():
        print(f"{TARGET.name} is not up to date: run this with --write")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
