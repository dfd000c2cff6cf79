"""Writes the manual pages and the bash completion from the options that the programs print.

    make_pages.py FOLDER_OF_TOOLS OUT VERSION

Writes OUT/NAME.1.gz and OUT/completions/NAME for hipmap, hipmap-render and hipmap-preprocess.
"""

import gzip
import importlib.machinery
import importlib.util
import json
import os
import subprocess
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))
EXIT_CODES = ((0, "done"), (1, "a defect of hipmap"),
              (2, "bad input or usage; one line on standard error says what to do"),
              (3, "stopped by a signal; the image so far and the state are written"),
              (4, "out of memory; one line on standard error says what to lower"))
SEE_ALSO = ("hipmap", "hipmap-render", "hipmap-preprocess")


def load_command():
    """The module of the program hipmap, which has no suffix."""
    loader = importlib.machinery.SourceFileLoader("hipmap", os.path.join(FOLDER, "hipmap"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("hipmap", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


def printed(folder, tool, *command):
    """Description and options of a tool, by the names under which tools are installed."""
    said = subprocess.run([os.path.join(folder, tool), *command, "--options-json"],
                          stdout=subprocess.PIPE, check=True, text=True).stdout
    return json.loads(said.replace("render merge", "hipmap-render merge"))


def roff(text):
    """Text that roff prints as it is."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in ".'" else text


def option_lines(row):
    flags = ", ".join(f"\\fB{roff(flag)}\\fR" for flag in row["flags"].split(","))
    value = f" \\fI{roff(row['placeholder'])}\\fR" if row["placeholder"] else ""
    notes = []
    if row.get("values"):
        notes.append(f"Values: {row['values']}.")
    if row.get("default"):
        notes.append(f"Default: {row['default']}.")
    text = row["help"].rstrip(".") + "."
    return [".TP", flags + value, roff(" ".join([text, *notes]))]


def option_sections(rows, prefix):
    """A heading for each section, in the order in which sections first appear."""
    lines = []
    for section in dict.fromkeys(row.get("section", "") for row in rows):
        heading = " ".join(part for part in (prefix, section) if part) or "Options"
        lines += [f".SH {roff(heading.upper())}"]
        for row in rows:
            if row.get("section", "") == section:
                lines += option_lines(row)
    return lines


def manual_page(name, version, usage, description, sections):
    """usage: lines of the synopsis.  sections: lines of roff."""
    others = [f"\\fB{roff(other)}\\fR(1)" for other in SEE_ALSO if other != name]
    summary = description.split(". ")[0].rstrip(".")
    lines = [f'.TH {name.upper()} 1 "" "hipmap {version}" "User Commands"', ".SH NAME",
             f"{roff(name)} \\- {roff(summary[0].lower() + summary[1:])}", ".SH SYNOPSIS"]
    for line in usage:
        lines += [roff(line), ".br"]
    lines += [".SH DESCRIPTION", roff(description), *sections, ".SH EXIT STATUS"]
    for code, meaning in EXIT_CODES:
        lines += [".TP", str(code), roff(meaning)]
    return "\n".join([*lines, ".SH SEE ALSO", ", ".join(others), ""])


def completion_cases(rows):
    """Cases of the word before the one to complete; other options take files."""
    lines = []
    for row in rows:
        flags = "|".join(flag.strip() for flag in row["flags"].split(","))
        if row["choices"]:
            lines.append(f"    {flags}) words='{' '.join(row['choices'])}' ;;")
    return lines


def completion(name, rows):
    flags = sorted({flag for row in rows for flag in row["flags"].split(",")} | {"--help"})
    function = "_" + name.replace("-", "_")
    return "\n".join([
        f"# Completes the options of {name} in bash; written by make_pages.py.",
        f"{function}() {{",
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=",
        '    case $before in', *completion_cases(rows), "    esac",
        f"    if [[ -z $words && $word == -* ]]; then words='{' '.join(flags)}'; fi",
        "    if [[ -n $words ]]; then",
        '        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")',
        "    else",
        '        mapfile -t COMPREPLY < <(compgen -f -- "$word")',
        "        compopt -o filenames 2> /dev/null",
        "    fi",
        "}",
        f"complete -F {function} {name}", ""])


def write_pages(out, version, pages):
    """pages: name -> usage, description, sections, rows to complete."""
    os.makedirs(os.path.join(out, "completions"), exist_ok=True)
    for name, (usage, description, sections, rows) in pages.items():
        page = manual_page(name, version, usage, description, sections)
        with open(os.path.join(out, f"{name}.1.gz"), "wb") as file:
            file.write(gzip.compress(page.encode(), mtime=0))  # the same bytes at each build
        with open(os.path.join(out, "completions", name), "w", encoding="utf-8") as file:
            file.write(completion(name, rows))


def main(folder, out, version):
    command = load_command()
    render, merge = printed(folder, "render"), printed(folder, "render", "merge")
    preprocess = printed(folder, "preprocess")
    merging = [".SH MERGING", roff(merge["description"]),
               *option_sections(merge["options"], "merge:")]
    write_pages(out, version, {
        "hipmap": ([command.USAGE], f"{command.__doc__} {command.EPILOG}",
                   option_sections(command.OPTIONS, ""),
                   [*command.OPTIONS, *render["options"], *preprocess["options"]]),
        "hipmap-render": (
            ["hipmap-render SCENE FILE.hpm -o IMAGE [-o IMAGE ...] [OPTION...]",
             "hipmap-render merge STATE... -o IMAGE [OPTION...]",
             "hipmap-render describe STATE..."],
            render["description"], option_sections(render["options"], "") + merging,
            render["options"]),
        "hipmap-preprocess": (["hipmap-preprocess SCENE -o FILE.hpm [OPTION...]"],
                              preprocess["description"],
                              option_sections(preprocess["options"], ""), preprocess["options"])})


if __name__ == "__main__":
    main(*sys.argv[1:])
