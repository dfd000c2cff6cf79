"""The files that the checks look at."""

import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDERS = ("common", "convert", "preprocess", "render", "tests", "bench", "experiments")
SUFFIXES = (".h", ".cpp")


def listed_by_git():
    """Tracked and new files, or None where this is not a checkout."""
    command = ["git", "-c", f"safe.directory={ROOT}", "-C", ROOT, "ls-files", "-z", "--cached",
               "--others", "--exclude-standard"]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    if run.returncode != 0:
        return None
    return [name for name in run.stdout.decode().split("\0") if name]


def found_in_folders():
    found = []
    for top in FOLDERS:
        for folder, _, names in os.walk(os.path.join(ROOT, top)):
            found += [os.path.relpath(os.path.join(folder, name), ROOT) for name in names]
    return found


def source_files():
    """C++ files of the project, as paths from the root, sorted.  Never empty."""
    files = listed_by_git() or found_in_folders()
    chosen = sorted(name for name in files if name.endswith(SUFFIXES)
                    and os.path.isfile(os.path.join(ROOT, name)))
    assert chosen, f"no source file under {ROOT}"
    return chosen


def lines_of(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read().splitlines()
