"""Runs hipmap's programs from outside, as a user would."""

import contextlib
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


def fail(program, code, errors):
    """Ends this program with the last line of the other's errors.  errors: a file."""
    errors.seek(0)
    lines = errors.read().splitlines() or ["no message"]
    sys.exit(f"error: {program} ended with code {code}: {lines[-1]}")


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
        if process.returncode != 0:
            fail(program, process.returncode, errors)
        return Done(output.read(), used.ru_utime + used.ru_stime)


@contextlib.contextmanager
def lines_of(folder, program, *arguments):
    """The lines that a program prints, while it runs; it is ended where they are not read to the end.
    Ends this program with one line if the other fails."""
    command = [str(folder / program), *map(str, arguments)]
    with tempfile.TemporaryFile("w+") as errors:
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                       stderr=errors, text=True)
        except OSError:
            refuse_without(folder, program)

        def lines():
            yield from process.stdout
            if process.wait() != 0:
                fail(program, process.returncode, errors)
        try:
            yield lines()
        finally:
            process.terminate()
            process.wait()
            process.stdout.close()


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
