"""Runs a program and writes the most memory that it had, in bytes, to a file.

    rival_peak.py FILE PROGRAM [ARGUMENT...]

The system counts what the process that starts a program has as the program's own, so that one must be small.
"""

import os
import sys


def main():
    file, *command = sys.argv[1:]
    child = os.posix_spawn(command[0], command, os.environ)
    _, status, used = os.wait4(child, 0)
    with open(file, "w", encoding="utf-8") as out:
        out.write(str(1024 * used.ru_maxrss))
    sys.exit(os.waitstatus_to_exitcode(status))


main()
