"""Settings that make the same searches in the same trees: their costs differ by noise alone."""

import itertools

from measure import LEVELS, label, maps, ratio
from ratios import CHANCE, written
from tables import table


def searches(row):
    """What the searches of a rendering depend on; None where it searches more than shared maps."""
    if row["mode"] == "global" or any(maps(row, kind, level) for kind in row["kinds"]
                                      for level in LEVELS[1:]):
        return None
    return row["tree"], row["estimate"], row["together"]


def pairs_in(batch):
    """Pairs of rows that were measured in the same rounds."""
    return [pair for pair in itertools.combinations(batch, 2)
            if searches(pair[0]) is not None and searches(pair[0]) == searches(pair[1])]


def batches(results):
    """Rows of each scene and test: measured in the same rounds."""
    for _, batch in itertools.groupby(results["rows"], lambda row: (row["scene"], row["test"])):
        yield list(batch)


def named(row):
    detail = "".join(f", {row[key]}" for key, usual in (("tiers", "paying"), ("estimate", "thesis"), ("ratio", 10))
                     if row[key] != usual)
    return ("control of " if row["control"] else "") + row["mode"] + detail


def find_all(results):
    """[(row, row, their ratio)]; a ratio of None: lost in noise."""
    return [(*pair, ratio(*pair)) for batch in batches(results) for pair in pairs_in(batch)]


def is_measured(found):
    """Whether the ratio has an interval."""
    return found is None or found.freedom > 0


def differ(pairs):
    """Those whose intervals miss 1, with a probability of CHANCE that any does so by noise."""
    measured = [pair for pair in pairs if is_measured(pair[2])]
    chance = CHANCE / max(1, len(measured))
    return [pair for pair in measured
            if pair[2] is None or not pair[2].bounds(chance)[0] <= 1 <= pair[2].bounds(chance)[1]]


def complaints(results):
    """A line for each pair that differs by more than its interval; or that none was measured."""
    pairs = find_all(results)
    if not any(is_measured(pair[2]) for pair in pairs):
        return ["no identical computations were measured in two rounds or more"]
    return [f"scene {label(a['scene'])}, test {a['test']}, {a['tree']} trees: {named(a)} and {named(b)} make "
            f"the same searches, but their costs have a ratio of {written(found)}"
            for a, b, found in differ(pairs)]


def identical_table(results):
    return table(["scene", "test", "tree", "modes", "ratio"],
                 [[label(a["scene"]), a["test"], a["tree"], f"{named(a)} / {named(b)}", written(found)]
                  for a, b, found in find_all(results)])
