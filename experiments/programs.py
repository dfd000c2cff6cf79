"""Runs hipmap's programs from outside, as a user would."""

import dataclasses
import hashlib
import os
import pathlib
import platform
import subprocess
import sys
import tempfile


@dataclasses.dataclass(frozen=True)
class Done:
    """What a program printed on standard output, and the processor's seconds that it took, of all
    its threads together, user and system."""

    output: str
    seconds: float


def refuse_without(folder, program):
    """Ends this program with one line."""
    sys.exit(f"error: {folder / program} is missing; build it: cmake --build build/release --target "
             f"{program}")


def run(folder, program, *arguments):
    """Runs a program of the folder; ends this one with one line if that fails.  Any thread."""
    command = [str(folder / program), *map(str, arguments)]
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as errors:
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output,
                                       stderr=errors)
        except OSError:
            refuse_without(folder, program)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        errors.seek(0)
        if process.returncode != 0:
            lines = errors.read().splitlines() or ["no message"]
            sys.exit(f"error: {program} ended with code {process.returncode}: {lines[-1]}")
        return Done(output.read(), used.ru_utime + used.ru_stime)


def digest(folder, programs):
    """Of programs' bytes: results by the same ones can be put together.  Ends this one with one line
    if one is missing."""
    read = hashlib.sha256()
    for program in programs:
        try:
            read.update((folder / program).read_bytes())
        except OSError:
            refuse_without(folder, program)
    return read.hexdigest()[:16]


def machine():
    """The processor as it calls itself, and the cores."""
    name = platform.machine()
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                name = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    return f"{name}, {os.cpu_count()} cores"
