# SPDX-License-Identifier: GPL-3.0-or-later
"""A `render serve` that stays while an animation is rendered: it reuses photon maps as long as only the
camera moves.  Uses nothing of Blender."""

import json
import subprocess
import time

from .run import Child

_END_OF_MESSAGES = "done"  # printed after the messages of a request
_SECONDS_TO_END = 0.6


class Server(Child):
    """A `render serve` under way."""

    def __init__(self, program):
        super().__init__([program, "serve"], stdin=subprocess.PIPE)
        self.program = program

    def ask(self, words):
        """Sends a command line.  Returns False if the program has ended."""
        try:
            self._process.stdin.write(json.dumps(words) + "\n")
            self._process.stdin.flush()
        except OSError:
            return False
        return True

    def end(self):
        """Ends the program, which has no request under way."""
        try:
            self._process.stdin.close()
        except OSError:
            pass
        end = time.monotonic() + _SECONDS_TO_END
        while self.running() and time.monotonic() < end:
            time.sleep(0.01)
        self._process.kill()
        self.finish()


class Request:
    """A command line that a server renders, with the functions of a Child."""

    def __init__(self, server):
        self._server = server
        self._first = len(server.messages)
        self._code = None

    @property
    def messages(self):
        """Lines of standard error since the request began, up to its end."""
        found = self._server.messages[self._first:]
        if _END_OF_MESSAGES in found:
            found = found[:found.index(_END_OF_MESSAGES)]
        return found

    def events(self):
        """Returns the events that came since the last call."""
        out = []
        for event in self._server.events():
            if event["event"] == "done":
                self._code = event["code"]
            else:
                out.append(event)
        return out

    def running(self):
        """Whether the request is under way."""
        return self._code is None and self._server.running()

    def finish(self):
        """Waits for what was printed.  Returns the exit code."""
        while self._server.running() and \
                _END_OF_MESSAGES not in self._server.messages[self._first:]:
            time.sleep(0.001)
        return self._server.finish() if self._code is None else self._code

    def stop(self):
        """Asks the program to end, and ends it if it does not soon."""
        self._server.stop()

    def last_error(self):
        """The line that says why the request failed."""
        errors = [line for line in self.messages if line.startswith("error: ")]
        return (errors or self.messages or ["no message"])[-1]


_server = None


def request(command):
    """Has a server render a command line: the one that is there, or a new one.  Returns a Request.
    Throws ToolError if the program cannot be started."""
    global _server  # pylint: disable=global-statement
    program, *words = command
    if _server is not None and (_server.program != program or not _server.running()):
        end_server()
    if _server is None:
        _server = Server(program)
    asked = Request(_server)
    if not _server.ask(words):
        end_server()
        _server = Server(program)
        asked = Request(_server)
        _server.ask(words)
    return asked


def end_server():
    """Ends the server if there is one."""
    global _server  # pylint: disable=global-statement
    if _server is not None:
        _server.end()
        _server = None
