"""Jobs that take turns, a moment each: what slows the machine for a while slows all of them alike."""

import contextlib
import dataclasses
import math
import multiprocessing
import os
import pathlib
import signal
import time
import typing

SLICE_S = 0.5


def members(session):
    """Processes of a session that have not ended."""
    found = []
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):  # it ends meanwhile
            words = (folder / "stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
            if int(words[3]) == session and words[0] not in "ZX":
                found.append(int(folder.name))
    return found


def send(session, number):
    """To all of a session, and to those that are begun meanwhile."""
    sent = set()
    while new := set(members(session)) - sent:
        for process in new:
            with contextlib.suppress(ProcessLookupError):
                os.kill(process, number)
        sent |= new


def work(pipe, job):
    os.setsid()
    pipe.send(None)  # its session is there
    pipe.recv()
    pipe.send(job())


@dataclasses.dataclass
class Turn:
    """A job that waits for its turn.  result: once done.  ran: when it did, [(begin, end)] by time.monotonic."""

    process: typing.Any
    pipe: typing.Any
    result: typing.Any = None
    ran: list = dataclasses.field(default_factory=list)
    done: bool = False

    def seconds(self, begin=-math.inf, end=math.inf):
        """Returns the seconds between two times in which the job ran."""
        return sum(max(0, min(stopped, end) - max(begun, begin)) for begun, stopped in self.ran)

    def let_run(self, most):
        """Until it is done or its time is over."""
        begun = time.monotonic()
        send(self.process.pid, signal.SIGCONT)
        ended = self.pipe.poll(most)
        self.ran.append((begun, time.monotonic()))
        if not ended:
            send(self.process.pid, signal.SIGSTOP)
            return
        try:
            self.result = self.pipe.recv()
        except EOFError:
            raise SystemExit("error: a job in turns ended without a result") from None
        self.done = True
        self.process.join()


def begin(job):
    """A process of its own for the job, stopped."""
    mine, its = multiprocessing.Pipe()
    process = multiprocessing.get_context("fork").Process(target=work, args=(its, job))
    process.start()
    its.close()
    mine.recv()
    send(process.pid, signal.SIGSTOP)
    mine.send(None)  # read in its first turn
    return Turn(process, mine)


def in_turns(jobs, slice_s=SLICE_S):
    """Does jobs side by side, each with all programs that it starts: one runs, the others are stopped.  A
    job is a function whose result can be pickled.  Returns the Turns in the order of the jobs.  Ends this
    program if a job ends without a result; no program of a job is left then."""
    turns = []
    try:
        turns += [begin(job) for job in jobs]
        while any(not turn.done for turn in turns):
            for turn in turns:
                if not turn.done:
                    turn.let_run(slice_s)
        return turns
    finally:
        for turn in turns:
            if not turn.done:
                send(turn.process.pid, signal.SIGKILL)
