#!/usr/bin/env python3
"""Makes the zip of hipmap's Blender add-on.

    blender/make_addon.py OUT.zip [--programs FOLDER]

--programs puts the programs preprocess and render of that folder inside, such as build/release/bin,
and vdb_to_vol if it is there.
The same files give the same zip, byte for byte.
"""

import argparse
import os
import zipfile

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "hipmap")
PROGRAMS = ("preprocess", "render")
OPTIONAL_PROGRAMS = ("vdb_to_vol",)
SUFFIXES = (".py", ".toml")
# The first date that a zip can hold: the time of a checkout must not be in the file.
DATE = (1980, 1, 1, 0, 0, 0)
READABLE, EXECUTABLE = 0o100644, 0o100755


def source_files():
    """The add-on's files as (path, name in the zip), sorted."""
    names = sorted(name for name in os.listdir(FOLDER)
                   if name.endswith(SUFFIXES) or name == "LICENSE")
    return [(os.path.join(FOLDER, name), f"hipmap/{name}") for name in names]


def programs_of(folder):
    """The names of the programs of a folder that go into the zip."""
    return (*PROGRAMS, *(name for name in OPTIONAL_PROGRAMS
                         if os.path.isfile(os.path.join(folder, name))))


def add(archive, path, name, mode):
    """Adds a file to the archive."""
    entry = zipfile.ZipInfo(name, DATE)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = mode << 16
    with open(path, "rb") as file:
        archive.writestr(entry, file.read())


def main():
    """Writes the zip that the command line names."""
    parser = argparse.ArgumentParser(description="Makes the zip of hipmap's Blender add-on.")
    parser.add_argument("out", metavar="OUT.zip")
    parser.add_argument("--programs", metavar="FOLDER",
                        help="put the programs of this folder inside")
    arguments = parser.parse_args()
    with zipfile.ZipFile(arguments.out, "w") as archive:
        for path, name in source_files():
            add(archive, path, name, READABLE)
        for program in programs_of(arguments.programs) if arguments.programs else ():
            add(archive, os.path.join(arguments.programs, program), f"hipmap/bin/{program}",
                EXECUTABLE)
    print(f"wrote {arguments.out}")


if __name__ == "__main__":
    main()
