"""Fails if clang-format would change a source file, or is not there to say."""

import shutil
import subprocess
import sys

from source_files import ROOT, source_files


def main():
    if shutil.which("clang-format") is None:
        print("clang-format is not installed; see .ci/packages.txt")
        return 1
    command = ["clang-format", "--dry-run", "-Werror", *source_files()]
    return 1 if subprocess.run(command, cwd=ROOT, check=False).returncode else 0


if __name__ == "__main__":
    sys.exit(main())
