"""Measures renders by as many processes as a machine has cores, and by fewer, always with all cores busy."""

import concurrent.futures
import dataclasses
import pathlib
import statistics
import tempfile
import time

import measure  # finds turns
from turns import in_turns

PASS_STAGES = ("photons", "maps", "image", "film")
# The law of the error is not asked for.
STUDY = dataclasses.replace(measure.FULL, passes=2, error_passes=4, repeats=1)


@dataclasses.dataclass(frozen=True)
class Load:
    """counts: of processes, of which the most is that of the cores and a multiple of the others.  each: passes of a
    process."""

    counts: tuple
    each: int

    def most(self):
        return max(self.counts)


def beside(jobs):
    """Results of jobs done at once, each in a folder of its own."""
    def do(job):
        with tempfile.TemporaryDirectory() as folder:
            return job(pathlib.Path(folder))
    with concurrent.futures.ThreadPoolExecutor(len(jobs)) as pool:
        return list(pool.map(do, jobs))


def measure_part(lab, name, count, passes, folder):
    """Some of the passes (first, number) by one process of one thread without MPI, or by several with it: when it began
    and ended, and the seconds that passes took if it is one."""
    begun, options = time.monotonic(), ("--first-pass", passes[0], "--passes", passes[1])
    if count > 1:
        lab.run_ranks(count, name, lab.study.checked, folder, *options)
        return {"begun": begun, "ended": time.monotonic()}
    seconds = lab.render(name, lab.study.checked, folder, *options)["processor_seconds"]
    return {"begun": begun, "ended": time.monotonic(), "passes": sum(seconds[stage] for stage in PASS_STAGES)}


def measure_parts(lab, name, count, load):
    """All passes in equal parts, each by so many processes, all at once."""
    of_part = count * load.each
    return beside([lambda folder, i=i: measure_part(lab, name, count, (i * of_part, of_part), folder)
                   for i in range(load.most() // count)])


def measure_points(lab, name, load):
    """The stages at all points at once, by several renders each.  Later passes cost less, and less so with each: a
    quarter of the way through them, a pass costs about what it does on average."""
    copies = max(1, load.most() // len(lab.study.points))
    def one(point):
        return lambda folder: measure.measure_passes(lab, name, point, folder, load.most() * load.each // 4)
    found = beside([one(point) for point in lab.study.points for _ in range(copies)])
    return {measure.point_key(*point): measure.mean(found[i * copies:(i + 1) * copies])
            for i, point in enumerate(lab.study.points)}


def mean_wall(turn):
    """Returns the mean seconds of the parts of an image that a turn rendered."""
    return statistics.mean(turn.seconds(part["begun"], part["ended"]) for part in turn.result)


def measure_checked(lab, name, load):
    """In turns, so that the machine is as fast for each: the stages, and the checks of renders by numbers of processes,
    of which each renders all passes.  What one process alone would take for a part is known from the parts of one
    process: the setup once, and all their passes."""
    counts = (1, *sorted(load.counts))
    stages, one, *more = in_turns([lambda: measure_points(lab, name, load),
                                   *(lambda count=count: measure_parts(lab, name, count, load) for count in counts)])
    passes = statistics.mean(part["passes"] for part in one.result)
    setup = mean_wall(one) - passes
    return {"stages": stages.result,
            "checks": [{"processes": count, "passes": count * load.each, "wall": mean_wall(turn),
                        "alone": setup + count * passes} for count, turn in zip(counts, (one, *more))]}
