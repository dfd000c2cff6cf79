"""What is measured, each kept as it comes."""

import measure  # finds notebook
from notebook import Job


def checked_key(scene):
    return f"checked/{scene}"


def sums_key(scene, size):
    return f"sums/{scene}/{size}"


def jobs(lab, scenes):
    """One after the other, for each uses two cores.  Weights: seconds, about."""
    out = []
    for name in scenes:
        out.append(Job(checked_key(name), 240, lambda name=name: measure.measure_checked(lab, name)))
        for size in {size for size, _ in lab.study.points}:
            out.append(Job(sums_key(name, size), 5 + size * size / 2000,
                           lambda name=name, size=size: measure.measure_sums(lab, name, size)))
        for ranks in (1, 2):
            out.append(Job(f"launch/{name}/{ranks}", 5,
                           lambda name=name, ranks=ranks: measure.launch(lab, name, ranks)))
    out += [Job(f"error/{name}", 30, lambda name=name: measure.passes_to_error(lab, name))
            for name in scenes]
    return out
