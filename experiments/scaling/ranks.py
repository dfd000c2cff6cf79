"""Renders by `render --mpi`, simulated event by event, as render/many does it."""

import dataclasses
import heapq
import math

from stages import Failures, Outcome

# Of render/many/pass_queue.cpp.
PASSES_OF_ROUND, SHARE_OF_ROUND, SHORTEST, LONGEST = 30, 0.5, 0.5, 60
# Of render/live_images.cpp: the share of the time that rewriting the image may take.
WRITING_SHARE = 0.05
FIRST_CHECK = 4
# A render that fails more often is given up.
MOST_FAILURES = 300


def next_check(passes):
    """As render/film/error_cost.cpp has it."""
    look = 2.0
    while math.floor(look + 0.5) <= max(passes, FIRST_CHECK - 1):
        look *= math.sqrt(2)
    return math.floor(look + 0.5)


def steps(machines):
    """Of a sum over machines that is taken pair by pair."""
    return math.ceil(math.log2(machines)) if machines > 1 else 0


class Ranks:
    """A run of all machines together, from its start or from a state."""

    def __init__(self, stages, cluster):
        self.stages, self.cluster = stages.by_cores(cluster.cores), cluster
        self.speeds = cluster.speeds()
        self.pass_s = [self.stages.one_pass() / speed + cluster.ask_s for speed in self.speeds]
        self.slowest, self.writing, self.written = 0, 0, 0

    def setup(self, resumes):
        """Seconds until each rank asks for passes: all wait for the slowest to load."""
        own = self.stages.start + self.stages.load + (self.stages.read if resumes else 0)
        loaded = max(own / speed for speed in self.speeds)
        loaded += self.cluster.transfer(self.stages.state_bytes) if resumes else 0
        pilots = self.stages.pilots_by(self.cluster.machines)
        return [loaded + pilots / speed for speed in self.speeds]

    def begin(self, resumes):
        """The clock stands where the lead hands out the first pass."""
        ready = self.setup(resumes)
        self.slowest, self.writing, self.written = 0, 0, 0
        return ready

    def longest_round(self, begun):
        return max(min(max(SHARE_OF_ROUND * begun, SHORTEST), LONGEST),
                   PASSES_OF_ROUND * self.slowest)

    def render_round(self, free, begun, left):
        """When each rank is told that no pass is left for it, and how many were rendered.  free: when
        each asks first; begun: the round, both since the first of the run."""
        waiting = [(max(time, begun), rank, False) for rank, time in enumerate(free)]
        heapq.heapify(waiting)
        ends, rendered = list(free), 0
        while waiting:
            now, rank, has_rendered = heapq.heappop(waiting)
            if has_rendered:
                self.slowest = max(self.slowest, self.pass_s[rank])
            if left == 0 or now - begun > self.longest_round(begun):
                ends[rank] = now
                continue
            left -= 1
            rendered += 1
            heapq.heappush(waiting, (now + self.pass_s[rank], rank, True))
        return ends, rendered

    def add_s(self):
        """Adding up the films: at each step the sums of one go to another machine, as they are."""
        count = steps(self.cluster.machines)
        return count * (self.stages.add + self.cluster.transfer(self.stages.film_bytes))

    def save_s(self):
        """Writing the state after a round, by the lead."""
        return self.stages.save / self.speeds[0] + self.cluster.transfer(self.stages.state_bytes)

    def write_s(self, now):
        """Rewriting the image after a round, if it is due."""
        if self.writing > WRITING_SHARE * (now - self.written):
            return 0
        self.writing = self.stages.write / self.speeds[0]
        self.written = now + self.writing
        return self.writing


def spend_setup(out, ranks, ready):
    stages, machines = ranks.stages, len(ready)
    pilots = sum(stages.pilots_by(machines) / speed for speed in ranks.speeds)
    out.spend("pilots", pilots)
    out.spend("load", sum(ready) - pilots)
    out.spend("wait", machines * ready[0] - sum(ready))


@dataclasses.dataclass(frozen=True)
class Order:
    """passes: of the image.  checks: rounds end where --error looks at the error.  keeps_states: with
    --state."""

    passes: int
    checks: bool = False
    keeps_states: bool = True

    def next_end(self, done):
        return min(self.passes, next_check(done) if self.checks else self.passes)


def run_rounds(ranks, order, done, until_failure, out):
    """A run from `done` passes on, until all are rendered or a machine fails.  Returns its seconds, None if
    it failed; and the passes that are kept."""
    machines, ready = ranks.cluster.machines, ranks.begin(done > 0)
    origin, clock = ready[0], 0
    if until_failure <= origin:
        out.spend("lost", machines * until_failure)
        return None, done
    spend_setup(out, ranks, ready)
    free = [time - origin for time in ready]
    while done < order.passes:
        ends, rendered = ranks.render_round(free, clock, order.next_end(done) - done)
        added = max(ends) + ranks.add_s()
        saved = added + ranks.write_s(added) + (ranks.save_s() if order.keeps_states else 0)
        if origin + saved > until_failure:
            out.spend("lost", machines * (until_failure - origin - clock))
            return None, done
        work = sum(end - max(time, clock) for time, end in zip(free, ends))
        out.spend("passes", work)
        out.spend("wait", machines * (max(ends) - clock) - work)
        out.spend("add", machines * (added - max(ends)))
        out.spend("save", machines * (saved - added))
        done, clock, free = done + rendered, saved, [saved] * machines
        out.rounds += 1
    last = ranks.stages.write / ranks.speeds[0]
    out.spend("save", machines * last)
    return origin + clock + last, done


def simulate_ranks(stages, passes, cluster, checks=False, keeps_states=True):
    """passes: of the image.  checks, keeps_states: as Order has them; no states without failures only."""
    order, ranks, out = Order(passes, checks, keeps_states), Ranks(stages, cluster), Outcome()
    failures, done = Failures(cluster, "ranks"), 0
    while out.failures <= MOST_FAILURES:
        until_failure = failures.within(cluster.machines)
        seconds, done = run_rounds(ranks, order, done, until_failure, out)
        if seconds is not None:
            out.seconds += seconds
            out.kept = done
            return out
        out.failures += 1
        out.seconds += until_failure + cluster.replace_s
        out.spend("lost", cluster.machines * cluster.replace_s)
    out.seconds = math.inf
    return out
