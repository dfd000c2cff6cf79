"""What is measured, each kept as it comes."""

import all_cores
import measure  # finds notebook
from notebook import Job


def checked_key(scene):
    return f"checked/{scene}"


def sums_key(scene, size):
    return f"sums/{scene}/{size}"


def sums_jobs(lab, name, counts):
    """Of two cores each; counts: of processes."""
    out = [Job(sums_key(name, size), 5 + size * size / 2000,
               lambda size=size: measure.measure_sums(lab, name, size))
           for size in sorted({size for size, _ in lab.study.points})]
    return out + [Job(f"launch/{name}/{ranks}", 5, lambda ranks=ranks: measure.launch(lab, name, ranks))
                  for ranks in counts]


def error_job(lab, name):
    return Job(f"error/{name}", 30, lambda: measure.passes_to_error(lab, name))


def jobs(lab, scenes):
    """Stages of jobs for two cores, one after the other.  Weights: seconds, about."""
    out = []
    for name in scenes:
        out.append(Job(checked_key(name), 240, lambda name=name: measure.measure_checked(lab, name)))
        out += sums_jobs(lab, name, (1, 2))
    return [[job] for job in out + [error_job(lab, name) for name in scenes]]


def jobs_of_all_cores(lab, loads):
    """Stages of jobs for renders by several numbers of processes; jobs that use few cores run at once.  loads: by
    scene."""
    small = [job for name, load in loads.items()
             for job in (error_job(lab, name), *sums_jobs(lab, name, load.counts))]
    return [small, *([Job(checked_key(name), 240,
                          lambda name=name, load=load: all_cores.measure_checked(lab, name, load))]
                     for name, load in loads.items())]
