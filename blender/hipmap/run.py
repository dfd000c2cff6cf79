# SPDX-License-Identifier: GPL-3.0-or-later
"""hipmap's programs as child processes, which end when Blender ends.  Uses nothing of Blender."""

import ctypes
import json
import math
import os
import queue
import shutil
import signal
import subprocess
import sys
import threading
import time

import numpy

# A render that is asked to stop writes its image and its state; it gets this long for it.
_SECONDS_TO_STOP = 0.6
_SECONDS_BETWEEN_LOOKS = 0.05
_PR_SET_PDEATHSIG = 1
_NAMES = {"preprocess": ("hipmap-preprocess", "preprocess"), "render": ("hipmap-render", "render"),
          "vdb_to_vol": ("vdb_to_vol",)}

# Loaded before any fork: a child between fork and exec must not take the loader's lock.
_LIBC = ctypes.CDLL(None) if sys.platform.startswith("linux") else None


class ToolError(RuntimeError):
    """A program is missing or failed.  Its text is one line for the user."""


class Cancelled(Exception):
    """The user cancelled the render."""


def find_tool(name, folder):
    """Returns the path of "preprocess", "render" or "vdb_to_vol": in `folder` if one is given, else in the
    add-on's folder `bin`, else hipmap-NAME on the PATH.  Throws ToolError."""
    if folder:
        found = _program_in(folder, name)
    else:
        found = _own_program(name) or shutil.which(_NAMES[name][0])
    if found is None:
        raise ToolError(f"no program '{name}' in {folder or 'the add-on or on the PATH'}: set the "
                        "folder in Edit > Preferences > Add-ons > hipmap")
    return found


def _program_in(folder, name):
    paths = (os.path.join(folder, file) for file in reversed(_NAMES[name]))
    return next((path for path in paths
                 if os.access(path, os.X_OK) and not os.path.isdir(path)), None)


def _own_program(name):
    """The program in the add-on's folder, which loses its mode when Blender unpacks the zip."""
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", name)
    if not os.path.isfile(path):
        return None
    if not os.access(path, os.X_OK):
        os.chmod(path, 0o755)
    return path


def _ask_for_end_with_parent():
    _LIBC.prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)


# For subprocess, as preexec_fn: the child gets SIGKILL when the thread that started it ends, for
# instance with Blender.  None where the system has no such thing.
end_with_parent = _ask_for_end_with_parent if _LIBC else None


class Child:
    """A program under way.  Its lines are read by threads, so that nothing here ever waits."""

    def __init__(self, command, stdin=subprocess.DEVNULL):
        try:
            self._process = subprocess.Popen(
                command, stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                text=True, errors="replace", preexec_fn=end_with_parent)
        except OSError as error:
            raise ToolError(f"{command[0]}: {error.strerror}") from error
        self.messages = []  # lines of standard error
        self._events = queue.SimpleQueue()
        self._readers = [threading.Thread(target=target, daemon=True)
                         for target in (self._read_events, self._read_messages)]
        for reader in self._readers:
            reader.start()

    def _read_events(self):
        for line in self._process.stdout:
            try:
                self._events.put(json.loads(line))
            except ValueError:
                self.messages.append(line.rstrip())

    def _read_messages(self):
        for line in self._process.stderr:
            self.messages.append(line.rstrip())

    def events(self):
        """Returns the events that came since the last call."""
        out = []
        while not self._events.empty():
            out.append(self._events.get())
        return out

    def running(self):
        """Whether the program is under way."""
        return self._process.poll() is None

    def finish(self):
        """Waits for what the ended program printed.  Returns its exit code."""
        code = self._process.wait()
        for reader in self._readers:
            reader.join()
        self._process.stdout.close()
        self._process.stderr.close()
        return code

    def stop(self, seconds=_SECONDS_TO_STOP):
        """Asks the program to end, and ends it if it does not within some seconds."""
        self._process.terminate()
        end = time.monotonic() + seconds
        while self.running() and time.monotonic() < end:
            time.sleep(0.01)
        self._process.kill()
        self.finish()

    def last_error(self):
        """The line that says why the program failed."""
        errors = [line for line in self.messages if line.startswith("error: ")]
        return (errors or self.messages or ["no message"])[-1]


def wait_for(child, is_cancelled, seconds=math.inf):
    """Waits for the end of a Child.  Returns its exit code.  is_cancelled: called meanwhile.  Throws
    Cancelled, or ToolError if it takes more than so many seconds."""
    end = time.monotonic() + seconds
    while child.running():
        if is_cancelled():
            child.stop()
            raise Cancelled
        if time.monotonic() > end:
            child.stop()
            raise ToolError(f"it took more than {seconds} s")
        time.sleep(_SECONDS_BETWEEN_LOOKS)
    return child.finish()


def warnings_of(messages):
    """Returns the warnings among lines of standard error, without the word."""
    return [line[len("warning: "):] for line in messages if line.startswith("warning: ")]


def read_pfm(path):
    """Returns the pixels [height * width, 4] of a .pfm with an opacity of 1, from the bottom left
    as in Blender, and the width and height."""
    with open(path, "rb") as file:
        if file.readline().strip() != b"PF":
            raise ToolError(f"{path}: not an image in colour")
        width, height = map(int, file.readline().split())
        order = "<" if float(file.readline()) < 0 else ">"
        values = numpy.frombuffer(file.read(), f"{order}f4", 3 * width * height)
    pixels = numpy.ones((width * height, 4), numpy.float32)
    pixels[:, :3] = values.reshape(-1, 3)
    return pixels, width, height
