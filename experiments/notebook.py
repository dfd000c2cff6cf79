"""Jobs whose results are kept in a file while they come in, so that a stopped run goes on where it was."""

import concurrent.futures
import dataclasses
import json
import sys
import threading
import time
import typing

from progress import Progress


class Notebook:
    """Results by key, written after each.  about: of what they are; those of anything else do not count.
    seconds: that all took, one after the other."""

    def __init__(self, file, about):
        self.file, self.lock = file, threading.Lock()
        self.results = {"about": json.loads(json.dumps(about)), "seconds": 0, "runs": {}}
        if not file.exists():
            return
        found = json.loads(file.read_text())
        if found["about"] == self.results["about"]:
            self.results = found
        else:
            print(f"{file} is of other programs or settings: begun anew", file=sys.stderr)

    def __getitem__(self, key):
        return self.results["runs"][key]

    def __contains__(self, key):
        return key in self.results["runs"]

    def forget(self, key):
        self.results["runs"].pop(key, None)

    def write_down(self, key, value, seconds):
        """The file is whole at any moment.  Any thread."""
        with self.lock:
            self.results["runs"][key] = value
            self.results["seconds"] += seconds
            whole = self.file.with_suffix(".new")
            whole.write_text(json.dumps(self.results) + "\n")
            whole.replace(self.file)


@dataclasses.dataclass(frozen=True)
class Job:
    """key: of its result.  weight: the processor's seconds that it takes, about, or any other unit."""

    key: str
    weight: float
    do: typing.Callable


def do_all(jobs, notebook, progress, workers):
    """So many at a time.  The first that fails ends all."""
    def do(job):
        begun = time.monotonic()
        notebook.write_down(job.key, job.do(), time.monotonic() - begun)
        return job

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        running = [pool.submit(do, job) for job in jobs]
        try:
            for done in concurrent.futures.as_completed(running):
                progress.ran(done.result().key, done.result().weight)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def do_stages(stages, notebook, workers):
    """What of the stages is not in the notebook.  stages: [[Job]]; those of a stage in any order, at
    the same time, after all stages before it."""
    stages = [[job for job in stage if job.key not in notebook] for stage in stages]
    left = [job for stage in stages for job in stage]
    progress = Progress(len(left), sum(job.weight for job in left))
    for stage in stages:
        do_all(stage, notebook, progress, workers)
