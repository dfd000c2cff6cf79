"""Writes report.html, one page that needs no other file, from what the tools left in a folder.

    make_report.py FOLDER

Reads stats.json (render --stats), partition.json (preprocess --json) where it is there, and the
pictures they name; writes FOLDER/report.html.  Exit code 2 and one line if something is missing.
"""

import os
import sys

from page import make_page
from results import ReportError, Results


def write_whole(path, text):
    """Readers see the old file or the whole new one."""
    temporary = f"{path}.{os.getpid()}.tmp"
    try:
        with open(temporary, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(temporary, path)
    except OSError as problem:
        if os.path.exists(temporary):
            os.remove(temporary)
        raise ReportError(f"{path}: {problem.strerror}; name a folder that can be "
                          "written") from problem


def main(arguments):
    if arguments in (["--help"], ["-h"]):
        print(__doc__.strip())
        return 0
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print("error: give one folder; see make_report.py --help", file=sys.stderr)
        return 2
    try:
        write_whole(os.path.join(arguments[0], "report.html"), make_page(Results(arguments[0])))
    except ReportError as problem:
        print(f"error: {problem}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
