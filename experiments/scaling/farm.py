"""Renders by tasks and a merge, simulated event by event, as farm/hipmap.sbatch does it."""

import collections
import dataclasses
import heapq
import math

from stages import Failures, Outcome

# Of render/integrator/run_passes.cpp.
SAVING_SHARE, BETWEEN_SAVES = 0.02, 0.2


@dataclasses.dataclass(frozen=True)
class Plan:
    """passes: of the image.  chunk: of a task.  tiles: of the image.  fan_in: states of a merge; 0: all
    at once."""

    passes: int
    chunk: int
    tiles: int = 1
    fan_in: int = 0

    def tasks(self):
        """The passes of each."""
        sizes = [min(self.chunk, self.passes - first) for first in range(0, self.passes, self.chunk)]
        return [size for size in sizes for _ in range(self.tiles)]


@dataclasses.dataclass(frozen=True)
class Work:
    """Seconds of a task on a machine: what comes before its passes, each pass, and a saved state after
    each group of them."""

    setup: float
    one_pass: float
    save: float
    group: int

    def until(self, passes):
        """Seconds until so many passes are saved; those of the last group too."""
        return self.setup + passes * self.one_pass + math.ceil(passes / self.group) * self.save

    def saved_by(self, seconds):
        """Passes in the state then."""
        of_group = self.group * self.one_pass + self.save
        return self.group * max(0, math.floor((seconds - self.setup) / of_group))


def work_of(stages, cluster, speed, resumes):
    setup = stages.setup() + (stages.read if resumes else 0)
    moved = cluster.transfer(stages.state_bytes)
    save = stages.save / speed + moved
    one_pass = stages.one_pass() / speed
    between = max(BETWEEN_SAVES, save / SAVING_SHARE)
    group = max(1, math.ceil(between / one_pass)) if one_pass > 0 else 1
    return Work(cluster.queue_s + setup / speed + (moved if resumes else 0), one_pass, save, group)


class Tasks:
    """All of them on all machines.  Events: a machine is free, or a task of one that failed is
    queued again."""

    def __init__(self, stages, plan, cluster):
        self.whole = stages.by_cores(cluster.cores)
        self.stages = self.whole.of_part(1 / plan.tiles)
        self.cluster, self.share = cluster, 1 / plan.tiles
        self.speeds = cluster.speeds()
        self.queue = collections.deque((passes, False) for passes in plan.tasks())
        self.events = [(0, 0, machine, None) for machine in range(cluster.machines)]
        self.idle, self.count = [], 0
        self.failures = Failures(cluster, "farm")
        self.out = Outcome()

    def post(self, time, machine, task):
        self.count += 1
        heapq.heappush(self.events, (time, self.count, machine, task))

    def run(self):
        """The end of the last task."""
        end = 0
        while self.events:
            now, _, machine, task = heapq.heappop(self.events)
            if task is not None:
                self.queue.append(task)
                if not self.idle:
                    continue
                machine = self.idle.pop()
            if self.queue:
                end = max(end, self.attempt(now, machine, *self.queue.popleft()))
            else:
                self.idle.append(machine)
        return end

    def attempt(self, now, machine, passes, resumes):
        """The end of the task, or of the attempt."""
        work = work_of(self.stages, self.cluster, self.speeds[machine], resumes)
        takes, fails = work.until(passes), self.failures.within()
        if fails >= takes:
            self.account(machine, passes, work, takes, resumes)
            self.post(now + takes, machine, None)
            return now + takes
        kept = min(passes - 1, work.saved_by(fails))
        self.account(machine, kept, work, fails, resumes)
        self.out.failures += 1
        back = now + fails + self.cluster.replace_s
        self.out.spend("lost", self.cluster.replace_s)
        self.post(back, machine, None)
        self.post(back, None, (passes - kept, resumes or kept > 0))
        return back

    def account(self, machine, kept, work, takes, resumes):
        """The seconds of an attempt that kept so many passes."""
        out, stages, speed = self.out, self.stages, self.speeds[machine]
        out.kept += kept * self.share
        whole = work.until(kept)
        if whole > takes:  # failed before its first pass
            out.spend("lost", takes)
            return
        out.spend("queue", self.cluster.queue_s)
        out.spend("pilots", stages.pilots / speed)
        out.spend("load", work.setup - self.cluster.queue_s - stages.pilots / speed)
        out.spend("passes", kept * work.one_pass)
        out.spend("save", whole - work.setup - kept * work.one_pass)
        out.spend("lost", takes - whole)


def merge_once(stages, cluster, states, share, mergers):
    """Seconds in which each of so many machines merges states of a share of the pixels."""
    read = cluster.transfer(share * stages.state_bytes, mergers)
    each = max(share * stages.merge, read)
    kept = cluster.transfer(stages.state_bytes, mergers)
    return cluster.queue_s + stages.merge_begin + states * each + kept


def merge_seconds(stages, cluster, states, share, fan_in):
    """A merged state has all pixels of the image, and is read again at the next level of the tree."""
    seconds = 0
    while fan_in > 1 and states > fan_in:
        mergers = math.ceil(states / fan_in)
        rounds = math.ceil(mergers / cluster.machines)
        at_once = min(mergers, cluster.machines)
        seconds += rounds * merge_once(stages, cluster, fan_in, share, at_once)
        states, share = mergers, 1
    return seconds + merge_once(stages, cluster, states, share, 1)


def simulate_farm(stages, plan, cluster):
    tasks = Tasks(stages, plan, cluster)
    end = tasks.run()
    out = tasks.out
    merging = merge_seconds(tasks.whole, cluster, len(plan.tasks()), 1 / plan.tiles, plan.fan_in)
    out.spend("wait", cluster.machines * end - sum(out.spent.values()))
    out.spend("merge", cluster.machines * merging)
    out.seconds = end + merging
    return out
