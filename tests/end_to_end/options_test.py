"""docs/options.md holds the tables that the tools print.

    options_test.py FOLDER_OF_TOOLS ROOT [--write]

With --write it puts the tables into docs/options.md instead.
"""

import os
import re
import subprocess
import sys
import unittest

FOLDER, ROOT = sys.argv[1:3]
DOCUMENT = os.path.join(ROOT, "docs/options.md")
COMMANDS = ("render", "render merge", "preprocess")


def tables(command):
    tool, *arguments = command.split()
    return subprocess.run([os.path.join(FOLDER, tool), *arguments, "--options-table"],
                          stdout=subprocess.PIPE, text=True, check=True).stdout.strip()


def with_tables(text):
    """The document with the tables below each command's heading, and its text, replaced."""
    for command in COMMANDS:
        before, heading, rest = text.partition(f"## `{command}`\n")
        assert heading, f"{DOCUMENT}: give it a heading ## `{command}`"
        section, *others = rest.split("\n## ")
        section = section.split("\n### ")[0].rstrip("\n") + "\n\n" + tables(command) + "\n"
        text = before + heading + "\n## ".join([section, *others])
    return text


class Options(unittest.TestCase):
    maxDiff = None

    def test_the_document_holds_what_the_tools_print(self):
        with open(DOCUMENT, encoding="utf-8") as file:
            text = file.read()
        self.assertEqual(text, with_tables(text), "run options_test.py with --write")

    def test_every_option_of_help_is_in_the_tables(self):
        for command in COMMANDS:
            tool, *arguments = command.split()
            printed = subprocess.run([os.path.join(FOLDER, tool), *arguments, "--help"],
                                     stdout=subprocess.PIPE, text=True, check=True).stdout
            options = re.findall(r"^  (?:-\w,)?(--[\w-]+)", printed, re.MULTILINE)
            self.assertGreater(len(options), 4)
            for option in set(options) - {"--help", "--version"}:
                with self.subTest(command=command, option=option):
                    self.assertRegex(tables(command), rf"\| `(-\w, )?{option}[ `]")


if __name__ == "__main__":
    if sys.argv[3:] == ["--write"]:
        with open(DOCUMENT, encoding="utf-8") as document:
            written = with_tables(document.read())
        with open(DOCUMENT, "w", encoding="utf-8") as document:
            document.write(written)
    else:
        unittest.main(argv=sys.argv[:1], verbosity=2)
