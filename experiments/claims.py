"""What the dissertation claims, and whether it came true here: decided by rule from the rows."""

from measure import ratio
from tables import one, percent, pick, table, times, values

HELD, WEAKER, NOT = "held", "held only against a weaker baseline", "not held"
UNKNOWN = "not measured"
FAR = 1.5  # times faster that count as far ahead
NEAR = 0.9  # of the gain that is claimed, which counts as as much


def verdict(on_theirs, on_ours):
    """on_theirs: on trees of the dissertation's time; on_ours: on wide trees, a stronger baseline.
    None: not measured."""
    if on_theirs is None or on_ours is None:
        return UNKNOWN
    if not on_theirs:
        return NOT
    return HELD if on_ours else WEAKER


def against(rows, scene, test, tree, above, below):
    """Ratio of two modes' net costs with its spread; None if not measured."""
    pair = [one(rows, scene=scene, test=test, tree=tree, mode=mode) for mode in (above, below)]
    return ratio(*pair) if all(pair) else None


def by_tree(decide, show, wanted):
    """wanted(tree): a list of ratios, or None where one is missing.  The verdict and the numbers."""
    found = {tree: wanted(tree) for tree in ("balanced", "wide")}
    complete = {tree: found[tree] if found[tree] and None not in found[tree] else None
                for tree in found}
    held = [decide(complete[tree]) if complete[tree] else None for tree in complete]
    numbers = [show(complete[tree]) if complete[tree] else "-" for tree in complete]
    return *numbers, verdict(*held)


def listed(ratios):
    return "; ".join(times(ratio_) for ratio_ in ratios)


def last(rows, scene):
    return max(values(pick(rows, scene=scene), "test"))


def first(rows, scene):
    return min(values(pick(rows, scene=scene), "test"))


def far_ahead(rows, scenes, mode):
    return by_tree(
        lambda ratios: all(low >= FAR for _, low, _ in ratios), listed,
        lambda tree: [against(rows, s, last(rows, s), tree, "global", mode) for s in scenes])


def grows(rows, scenes, mode):
    def ends(tree):
        out = []
        for scene in scenes:
            out += [against(rows, scene, test(rows, scene), tree, "global", mode)
                    for test in (first, last)]
        return out

    def decide(ratios):
        return all(late[0] > early[0] for early, late in zip(ratios[::2], ratios[1::2]))

    def show(ratios):
        return "; ".join(f"{early[0]:.2f} to {late[0]:.2f}"
                         for early, late in zip(ratios[::2], ratios[1::2]))

    return by_tree(decide, show, ends)


def local_tier(rows, scene, tests, decide):
    """shared / thesis: above 1 where the local tier gains."""
    return by_tree(decide, listed, lambda tree: [
        against(rows, scene, test, tree, "shared", "thesis") for test in tests])


def leaks(creases):
    """creases: rows of crease_profile.  At the crease itself, light that does not belong there."""
    if not creases:
        return "-", "-", UNKNOWN
    at_edge = creases[0]
    one_map, split = float(at_edge["dark global"]), float(at_edge["dark shared"])
    shown = f"{percent(one_map)} of the wall's with one map, {percent(split)} with shared maps"
    return shown, "the same: leakage is no matter of trees", verdict(split < 0.01 * one_map,
                                                                      one_map > 0.01)


def rebuilt_alone(rows, scenes):
    shares = {}
    for scene in scenes:
        row = one(rows, scene=scene, test=last(rows, scene), tree="balanced", mode="shared")
        if row is None:
            return "-", "-", UNKNOWN
        shares[scene] = row["largest_map"] / row["stored"]
    shown = "largest map: " + "; ".join(percent(share) for share in shares.values())
    return shown, "the same", verdict(max(shares.values()) < 0.5, True)


def quick_insertion(rows, scenes):
    """Building one map by inserting against building it balanced."""
    def builds(mode, above, below):
        out = []
        for scene in scenes:
            pair = [one(rows, scene=scene, test=last(rows, scene), tree=tree, mode=mode)
                    for tree in (above, below)]
            if not all(pair):
                return None
            out.append(ratio(*pair, of=lambda row: row["build_runs"]))
        return out

    theirs = builds("global", "balanced", "unbalanced")
    ours = builds("global", "wide", "unbalanced")
    if theirs is None or ours is None:
        return "-", "-", UNKNOWN
    return (listed(theirs) + " (balanced / unbalanced)", listed(ours) + " (wide / unbalanced)",
            verdict(all(low > 1 for _, low, _ in theirs), all(low > 1 for _, low, _ in ours)))


def judge(rows, creases):
    """[(claim, theirs, on balanced trees, on wide trees, verdict)]"""
    scenes = values(rows, "scene")
    by_scene = f"scene {', '.join(map(str, scenes))}, the last test"
    claims = [
        (f"Shared maps are far ahead of one map ({by_scene})", f"far (taken as {FAR} times)",
         *far_ahead(rows, scenes, "shared")),
        (f"Both tiers are far ahead of one map ({by_scene})", f"far (taken as {FAR} times)",
         *far_ahead(rows, scenes, "thesis")),
        (f"Shared maps: the more so the more photons (scene {', '.join(map(str, scenes))}, "
         "first to last test)", "grows", *grows(rows, scenes, "shared")),
        (f"Both tiers: the more so the more photons (scene {', '.join(map(str, scenes))}, "
         "first to last test)", "grows", *grows(rows, scenes, "thesis")),
        ("The local tier loses on scene 1 in test 5 (shared / both)", "0.92 (loses 8 %)",
         *local_tier(rows, 1, [5], lambda r: r[0][2] < 1)),
        ("The local tier gains slightly on scene 2 in tests 4 and 5 (shared / both)",
         "a little above 1", *local_tier(rows, 2, [4, 5], lambda r: all(x[1] > 1 for x in r))),
        ("The local tier halves the cost of scene 3 in test 2 (shared / both)",
         "85 s / 40 s = 2.1", *local_tier(rows, 3, [2], lambda r: r[0][1] >= NEAR * 85 / 40)),
        ("Splitting stops leakage at corners (irradiance of a dark floor at a lit wall)",
         "stops", *leaks(creases)),
        (f"A single map can be rebuilt alone: share of all photons in it ({by_scene})", "-",
         *rebuilt_alone(rows, scenes)),
        (f"Unbalanced trees with insertion are faster to build, one map ({by_scene})",
         "faster", *quick_insertion(rows, scenes)),
    ]
    return claims


def claims_table(rows, creases):
    return table(["claim", "dissertation", "here, on balanced trees", "here, on wide trees",
                  "verdict"], [[*line[:-1], f"**{line[-1]}**"] for line in judge(rows, creases)])
