#!/usr/bin/env python3
"""Makes the manual page and the completions of the shell from what the program says of itself with --help.

    tools/manual.py PROGRAM FOLDER      writes FOLDER/sudar.1 and FOLDER/sudar.bash
"""

import pathlib
import re
import subprocess
import sys


def help_of(program, *command):
    """{section: [(entry, text)]}; "" has what stands before the first section."""
    text = subprocess.run([program, *command, "--help"], capture_output=True, text=True, check=True).stdout
    sections, entries = {"": [("", text.partition("\n")[0])]}, []
    for line in text.splitlines()[1:]:
        if head := re.fullmatch(r"(\w+):", line):
            entries = sections.setdefault(head[1], [])
        elif entry := re.fullmatch(r"  (\S.*?)(?:\s{2,}(.*))?", line):
            entries.append((entry[1], entry[2] or ""))
        elif line.strip() and entries:  # goes on
            entries[-1] = (entries[-1][0], f"{entries[-1][1]} {line.strip()}".strip())
    return sections


def words(entry):
    """The names of an option: "-h,--help" or "--set TEXT ..."."""
    return re.findall(r"(?:^|,)(--?[\w-]+)", entry.split(" ")[0])


def choices(entry, text):
    """What an option's value may be: "{auto,plain,fine}" or "{fine->1,…}" beside it, or a text that only lists them."""
    if found := re.search(r"\{([^}]*)\}", entry):
        return [choice.partition("->")[0] for choice in found[1].split(",")]
    return text.split(", ") if re.fullmatch(r"\w+(, \w+)+", text) else []


def troff(text):
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"), flags=re.M)


def entries(sections):
    out = []
    for name in ("Positionals", "Options"):
        for entry, text in sections.get(name, []):
            out += [".TP", f".B {troff(entry)}", troff(text) or "\\&"]
    return out


def page(program, whole, commands):
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    out = [f'.TH SUDAR 1 "" "{version}" "User commands"', ".SH NAME", troff("sudar - " + whole[""][0][1].partition(": ")[2]),
           ".SH SYNOPSIS", ".B sudar", "[OPTIONS] [SCENARIO]", ".br", ".B sudar", "COMMAND [OPTIONS]", ".SH OPTIONS", *entries(whole)]
    for name, sections in commands.items():
        out += [f".SH SUDAR {name.upper()}", troff(sections[""][0][1]) + ".", *entries(sections)]
    out += [".SH EXIT STATUS", "0: all is well. 1: a check failed, or two recordings differ. 2: bad usage or input.",
            ".SH ENVIRONMENT", ".TP", ".B SUDAR_SCENARIOS", "A folder of scenarios, instead of those that came with the program."]
    return "\n".join(out) + "\n"


def completions(whole, commands):
    values = {}  # of the options that take one: what it may be, or nothing that could be guessed

    def names(sections):
        for entry, text in sections.get("Options", []):
            option = "|".join(words(entry))
            if " " in entry and not values.get(option):
                values[option] = " ".join(choices(entry, text))
        return " ".join(word for entry, _ in sections.get("Options", []) for word in words(entry))

    own = names(whole)
    lines = ["# Completions of sudar for bash.", "_sudar() {",
             "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options names=",
             "  COMPREPLY=()", "  case ${COMP_WORDS[1]} in"]
    for name, sections in commands.items():
        options = names(sections)
        scenario = any("list" in text for _, text in sections.get("Positionals", []))
        lines.append(f"    {name}) options='{options}'{' names=yes' if scenario else ''} ;;")
    lines += [f"    *) options='{' '.join(commands)} {own}' names=yes ;;", "  esac", "  case $before in"]
    lines += [f"    {option}) COMPREPLY=($(compgen -W '{those}' -- \"$word\")); return ;;" for option, those in values.items()]
    lines += ["  esac",
              "  [[ $names && $word != -* ]] && options+=\" $(\"${COMP_WORDS[0]}\" list 2>/dev/null | cut -d' ' -f1)\"",
              "  COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))", "}", "complete -o default -F _sudar sudar"]
    return "\n".join(lines) + "\n"


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    whole = help_of(program)
    commands = {name: help_of(program, name) for name, _ in whole["Subcommands"]}
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "sudar.1").write_text(page(program, whole, commands))
    (folder / "sudar.bash").write_text(completions(whole, commands))


if __name__ == "__main__":
    main()
