"""What the dissertation claims, and what became of it here: decided by rule from the rows."""

import collections
import dataclasses
import typing

from measure import CELLS, TESTS, label, ratio
from ratios import of_rounds, written
from tables import one, percent, pick, table, usual, values

HELD, THEN, REFUTED, UNDECIDED = ("held", "held on trees of its time", "refuted", "undecided")
UNKNOWN = "not measured"
RULES = f"""A claim is judged on the scene that it was made for. Its number has a 95 % confidence interval (in
brackets), and its rule a threshold:

| verdict | what the interval is |
|---|---|
| {HELD} | beyond the threshold on balanced trees, which are of the dissertation's time, and on wide trees, which are hipmap's |
| {THEN} | beyond the threshold on balanced trees; on wide trees below it, or around it |
| {REFUTED} | below the threshold on balanced trees |
| {UNDECIDED} | around the threshold on balanced trees |
"""
FAR = 1.5  # times faster that count as far ahead
FIRST, LAST = min(TESTS), max(TESTS)
LEAK = 0.01  # of what leaks with one map, below which a leak has stopped
NORMAL_LIMIT = 1.96  # standard errors of a 95 % confidence interval
NEAR = 0.9  # of the gain that is claimed, which counts as as much
# What of the scenes was fitted to numbers of the dissertation.
FITTED = {1: "lights, to the photons stored",
          2: "lights, colours and the number of objects, to the photons stored and the share of shared "
             "maps",
          3: "lights, colours and fineness of the furniture, to the photons stored and the numbers of "
             "shared and local maps",
          CELLS: "lights, to the photons stored; cells of walls, to the number of local maps"}

Shown = collections.namedtuple("Shown", "text holds")  # of one kind of trees; holds: None: unknown


@dataclasses.dataclass(frozen=True)
class Claim:
    """scene: the one it was made for; 0: none.  theirs: what the dissertation says.  find(tree): the
    ratio, or None if it was not measured.  threshold: what the ratio exceeds if the claim holds, or,
    if `below`, what exceeds it."""

    text: str
    scene: int
    theirs: str
    find: typing.Callable
    threshold: float
    below: bool = False

    @property
    def rule(self):
        return f"{'below' if self.below else 'above'} {self.threshold:.2f}"

    def shown(self, tree):
        """None: not measured."""
        found = self.find(tree)
        if found is None:
            return None
        exceeds = found.exceeds(self.threshold)
        return Shown(written(found, 3), not exceeds if self.below and exceeds is not None else exceeds)


def verdict(on_theirs, on_ours):
    """Of Shown on trees of the dissertation's time and on wide trees, a stronger baseline."""
    if on_theirs is None or on_ours is None:
        return UNKNOWN
    if on_theirs.holds is None:
        return UNDECIDED
    if not on_theirs.holds:
        return REFUTED
    return HELD if on_ours.holds else THEN


def against(rows, setting, tree, above, below):
    """Ratio of two modes' net costs.  setting: (scene, test)."""
    pair = [one(rows, scene=setting[0], test=setting[1], tree=tree, mode=mode)
            for mode in (above, below)]
    return ratio(*pair) if all(pair) else None


def last_test(rows, scene):
    """The last that was measured; 0: none."""
    return max(values(pick(rows, scene=scene), "test"), default=0)


def far_ahead(rows, scene, mode, name):
    return Claim(f"{name} far ahead of one map, in test {LAST} (one map / {mode})", scene, "far",
                 lambda tree: against(rows, (scene, LAST), tree, "global", mode), FAR)


def grows(rows, scene, mode, name):
    def find(tree):
        early, late = (against(rows, (scene, test), tree, "global", mode) for test in (FIRST, LAST))
        return late.over(early) if early and late else None

    return Claim(f"{name} the more ahead the more photons are stored (that ratio in test {LAST} / in "
                 f"test {FIRST})", scene, "grows", find, 1)


def local_maps(rows, setting, claimed):
    """claimed: (text, theirs, threshold, below)."""
    text, theirs, threshold, below = claimed
    scene, test = setting
    return Claim(f"Local maps {text} in test {test} (shared / thesis)", scene, theirs,
                 lambda tree: against(rows, setting, tree, "shared", "thesis"), threshold, below)


def unbalanced(rows, scene, how, kind):
    """Building one map in an unbalanced tree of a kind against building it balanced."""
    last = last_test(rows, scene)

    def find(tree):
        pair = [one(rows, scene=scene, test=last, tree=of, mode="global") for of in (tree, kind)]
        return ratio(*pair, of=lambda row: row["build_runs"]) if all(pair) else None

    return Claim(f"Unbalanced trees are built faster, {how}: one map in test {last} (this "
                 f"tree / {kind})", scene, "faster", find, 1)


def rebuilt_alone(rows, scene):
    """rows: of rebuild_maps."""
    last = last_test(rows, scene)

    def find(tree):
        row = one(rows, scene=scene, test=last, tree=tree)
        return of_rounds(row["ms all"], row["ms largest"]) if row else None

    return Claim("A single map can be rebuilt alone, at less than half the cost of all: the largest in "
                 f"test {last} (all / largest)", scene, "can be", find, 2)


def ratio_claims(results):
    """The claims that are decided by a ratio of costs."""
    rows = usual(results["rows"])
    ahead = [("shared", "Shared maps are"), ("thesis", "Shared and local maps are")]
    return [*(far_ahead(rows, scene, *mode) for mode in ahead for scene in (1, 2)),
            *(grows(rows, scene, *mode) for mode in ahead for scene in (1, 2)),
            local_maps(rows, (1, 5), ("lose", "0.92 (loses 8 %)", 1, True)),
            *(local_maps(rows, (2, test), ("gain slightly", "a little above 1", 1, False))
              for test in (4, 5)),
            *(local_maps(rows, (scene, 2), ("halve the cost", "85 s / 40 s = 2.12", NEAR * 85 / 40,
                                            False)) for scene in (3, CELLS)),
            *(unbalanced(rows, scene, how, kind) for scene in (1, 2, 3)
              for how, kind in (("photon by photon", "unbalanced"),
                                ("all photons at once", "midpoint"))),
            *(rebuilt_alone(results.get("rebuilds", []), scene) for scene in (1, 2, 3))]


def leak(row, name):
    """(text, lowest, highest) of the irradiance that a floor without light shows: the lit wall's is 1."""
    value, error = float(row[name]), float(row[f"{name} error"])
    low, high = value - NORMAL_LIMIT * error, value + NORMAL_LIMIT * error
    return f"{percent(value, 1)} ({percent(low, 1)} to {percent(high, 1)})", low, high


def leaks(creases):
    """creases: rows of crease_profile.  At the crease itself, light that does not belong there."""
    if not creases:
        return "-", "-", UNKNOWN
    (one_map, least, most), (split, low, high) = (leak(creases[0], f"dark {mode}")
                                                  for mode in ("global", "shared"))
    known = HELD if high < LEAK * least else REFUTED if low > LEAK * most else UNDECIDED
    return f"{one_map} of the wall's with one map, {split} with shared maps", "the same on all trees", known


def judge(results):
    """[(claim, label of the scene, fitted, theirs, rule, on balanced trees, on wide trees, verdict)]"""
    lines = []
    for claim in ratio_claims(results):
        shown = [claim.shown(tree) for tree in ("balanced", "wide")]
        lines.append((claim.text, label(claim.scene), FITTED[claim.scene], claim.theirs, claim.rule,
                      *(one_.text if one_ else "-" for one_ in shown), verdict(*shown)))
    lines.append(("Splitting stops leakage at corners (irradiance of a dark floor at a lit wall)",
                  "-", "-", "stops", "below 1 % of one map's", *leaks(results["creases"])))
    return lines


def claims_table(results):
    return table(["claim", "scene", "fitted in it", "dissertation", "rule",
                  "here, on balanced trees", "here, on wide trees", "verdict"],
                 [[*line[:-1], f"**{line[-1]}**"] for line in judge(results)])
