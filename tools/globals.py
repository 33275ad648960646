#!/usr/bin/env python3
"""Checks that the engine has no writable global: neither at namespace scope, nor static in a class or a function.

    tools/globals.py OBJECT…    looks at their symbols (nm) and exits 1 on an object that lies in a writable section

Not counted: .data.rel.ro, which holds constants with addresses (vtables, tables of names) and is read-only once the
library is loaded; and what ALLOWED names.
"""

import re
import subprocess
import sys

# Symbol → why it may be written to.
ALLOWED = {
    r"^DW\.ref\.": "the compiler's reference to its exception routine",
    r"new_world_number\(\)::last": "tells worlds apart in their handles; no result depends on it: src/world/world.cc",
    r"abi_of_this_file<\d+>\(\)::text": "a constant string, built when first asked for: include/sudar/scenario.h",
}


def writable(objects):
    """(object file, symbol, section) of everything that may change at run time."""
    listing = subprocess.run(["nm", "-C", "-A", "-f", "sysv", *objects], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        fields = [field.strip() for field in line.split("|")]
        if len(fields) != 7 or fields[3] not in ("OBJECT", "TLS"):
            continue
        path, _, symbol = fields[0].partition(":")
        section = fields[6]
        if re.match(r"\.(data|bss|tdata|tbss)|\*COM\*", section) and not section.startswith(".data.rel.ro"):
            name = symbol.removeprefix("guard variable for ")
            if not any(re.search(pattern, name) for pattern in ALLOWED):
                yield path, symbol, section


def main():
    breaches = [f"{path}: {symbol} ({section})" for path, symbol, section in writable(sys.argv[1:])]
    print("\n".join(breaches) if breaches else f"no writable globals in {len(sys.argv) - 1} object files")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
