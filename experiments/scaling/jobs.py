"""What is measured, each kept as it comes."""

import measure  # finds notebook
from notebook import Job


def stage_key(scene, point):
    return f"stages/{scene}/{point[0]}/{point[1]}"


def sums_key(scene, size):
    return f"sums/{scene}/{size}"


def run_key(scene, ranks):
    return f"runs/{scene}/{ranks}"


def jobs(lab, scenes):
    """One after the other, for each uses two cores.  Weights: seconds, about."""
    study = lab.study
    passes = ("--passes", study.checked_passes)
    out = []
    for name in scenes:
        for point in study.points:
            out.append(Job(stage_key(name, point), 5 + point[0] ** 2 / 1000 + point[1] / 100_000,
                           lambda name=name, point=point: measure.measure_stages(lab, name, point)))
        for size in {size for size, _ in study.points}:
            out.append(Job(sums_key(name, size), 5 + size * size / 2000,
                           lambda name=name, size=size: measure.measure_sums(lab, name, size)))
        for ranks in (1, 2):
            out.append(Job(run_key(name, ranks), 60 / ranks,
                           lambda name=name, ranks=ranks: measure.measure_runs(lab, name, ranks, *passes)))
            out.append(Job(f"launch/{name}/{ranks}", 5,
                           lambda name=name, ranks=ranks: measure.launch(lab, name, ranks)))
        out.append(Job(f"tasks/{name}", 60, lambda name=name: measure.measure_tasks(lab, name)))
    out += [Job(f"error/{name}", 30, lambda name=name: measure.passes_to_error(lab, name))
            for name in scenes]
    return out
