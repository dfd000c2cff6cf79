"""What the dissertation left open: measures, and tables of what came out."""

import csv

import ratios
from measure import (CELLS, LEVELS, TREES, Setting, label, light_paths, maps, neighbours, ratio,
                     rounds, run_tool, scene_path)
from ratios import written
from tables import number, one, percent, pick, seconds, table, usual, values

RATIOS = (2, 5, 10, 20, 50)  # M / k
ONE_MAP_TREES = ("balanced", "unbalanced", "midpoint", "wide")
REBUILD_TIMES = ("ms all", "ms largest", "ms median")
FILTER_TIMES = ("ns balanced", "ns wide")
ASKED = {2: 3, 3: 2}  # scene: test in which the ratio and the filter radius are asked for
SOME_TESTS = (2, 4)  # in which most questions are asked
TOGETHER_TEST = 2
USUAL_RATIO = 10


def settings(scene, test):
    """Settings beside the experiment's own that a scene and test is measured by."""
    found = [Setting("global", "midpoint"),
             *(Setting("shared", tree, control=True) for tree in TREES)]
    if ASKED.get(scene) == test:
        found += [Setting("thesis", tree, ratio=ratio_) for tree in ("balanced", "wide")
                  for ratio_ in RATIOS if ratio_ != USUAL_RATIO]
    if test in SOME_TESTS:
        found += [Setting("hierarchical", "wide", tiers="all"),
                  Setting("shared", "wide", estimate="clipped")]
    if test == TOGETHER_TEST and scene != CELLS:
        found += [Setting(mode, tree, together=True) for mode in ("shared", "thesis")
                  for tree in ("balanced", "wide")]
    return found


def filter_rows(bench, scene, test):
    text = run_tool(bench, "filter_radius", scene_path(scene), "--photons",
                    light_paths(bench, scene, test), "--neighbours", neighbours(bench, test),
                    "--size", bench.size)
    return list(csv.DictReader(text.splitlines(), delimiter=";"))


def run_filter(bench, scene, test):
    """Rows of filter_radius.  Nanoseconds are of each round."""
    measured = [filter_rows(bench, scene, test) for _ in range(rounds(bench, scene, test))]
    return [{"scene": scene, "test": test, **same[0],
             **{name: [float(row[name]) for row in same] for name in FILTER_TIMES}}
            for same in zip(*measured)]


def run_rebuilds(bench, scene, test):
    """A row by tree; milliseconds are of each round."""
    rows = {}
    text = run_tool(bench, "rebuild_maps", scene_path(scene), "--photons",
                    max(1000, light_paths(bench, scene, test)), "--neighbours",
                    neighbours(bench, test), "--rounds", rounds(bench, scene, test))
    for line in csv.DictReader(text.splitlines(), delimiter=";"):
        row = rows.setdefault(line["tree"], {
            "scene": scene, "test": test, "tree": line["tree"],
            **{name: int(line[name]) for name in ("maps", "photons", "largest", "median")},
            **{name: [] for name in REBUILD_TIMES}})
        for name in REBUILD_TIMES:
            row[name].append(float(line[name]))
    return list(rows.values())


def rebuild_table(rows):
    lines = [[label(row["scene"]), row["test"], row["tree"], row["maps"], number(row["photons"]),
              number(row["largest"]), number(row["median"]),
              *(f"{ratios.mean_cost(row[name]):.3f}" for name in REBUILD_TIMES),
              *(written(ratios.of_rounds(row["ms all"], row[name])) for name in REBUILD_TIMES[1:])]
             for row in rows]
    return table(["scene", "test", "tree", "maps", "photons", "of the largest", "of the median map",
                  "all, ms", "largest, ms", "median, ms", "all / largest", "all / median"], lines)


def run_creases(bench, sets):
    """Rows of crease_profile."""
    path = bench.folder / "creases.csv"
    run_tool(bench, "crease_profile", "--sets", sets, "--csv", path)
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def local_shares(kinds):
    """Of all searches of some kinds of photons: answered in a local map, abandoned."""
    asked = sum(kind["queries"] for kind in kinds)
    begun = sum(kind.get("local", {}).get("searches", 0) for kind in kinds)
    lost = sum(kind.get("local", {}).get("searches_abandoned", 0) for kind in kinds)
    return ((begun - lost) / asked, lost / asked) if asked else (0, 0)


def thesis_by_ratio(rows, scene, tree):
    """The rows that the ratio of M to k is asked of."""
    asked = pick(rows, scene=scene, test=ASKED[scene], tree=tree)
    return [row for ratio_ in RATIOS for row in usual(asked, mode="thesis", ratio=ratio_)]


def shared_row(rows, scene, test, tree):
    return one(usual(rows), scene=scene, test=test, tree=tree, mode="shared")


def asked_scenes(rows):
    """Of the ratio and the filter radius, those that were measured."""
    return [scene for scene in ASKED if pick(rows, scene=scene, test=ASKED[scene])]


def ratio_table(rows):
    lines = []
    for scene in asked_scenes(rows):
        for tree in ("balanced", "wide"):
            shared = shared_row(rows, scene, ASKED[scene], tree)
            for row in thesis_by_ratio(rows, scene, tree):
                answered, lost = local_shares(row["kinds"].values())
                lines.append([label(scene), row["test"], tree, row["ratio"],
                              *(maps(row, kind, "local_maps") for kind in ("global", "caustic")),
                              percent(answered), percent(lost), seconds(row["build_s"]),
                              seconds(row["net_s"]), written(ratio(shared, row))])
    return table(["scene", "test", "tree", "M / k", "global: local maps", "caustic: local maps",
                  "answered there", "abandoned", "build, s", "net, s", "shared / thesis"], lines)


def tier_line(rows):
    """rows: of one scene and test."""
    every = one(usual(rows, tiers="all"), tree="wide", mode="hierarchical")
    shared, paying = (one(usual(rows), tree="wide", mode=mode) for mode in ("shared", "hierarchical"))
    old = [one(usual(rows), tree="balanced", mode=mode)
           for mode in ("shared", "thesis", "hierarchical")]
    return [label(every["scene"]), every["test"],
            *(sum(maps(paying, kind, level) for level in LEVELS[1:]) for kind in ("global", "caustic")),
            *(maps(every, kind, level) for level in LEVELS[1:] for kind in ("global", "caustic")),
            written(ratio(shared, paying)), written(ratio(shared, every)),
            seconds(shared["build_s"]), seconds(every["build_s"]),
            *(written(ratio(old[0], row)) for row in old[1:])]


def tier_table(rows):
    found = usual(rows, tiers="all")
    return table(["scene", "test", "global: maps of levels that pay", "caustic: the same",
                  "global: local maps, all levels", "caustic: the same",
                  "global: group maps, all levels", "caustic: the same",
                  "wide: shared / paying", "wide: shared / all",
                  "build shared, s", "build all, s", "balanced: shared / thesis",
                  "balanced: shared / hierarchical"],
                 [tier_line(pick(rows, scene=row["scene"], test=row["test"])) for row in found])


def together_table(rows):
    """Caustic photons in the maps of the others against apart."""
    lines = []
    for joined in usual(rows, together=True):
        same = {key: joined[key] for key in ("scene", "test", "tree", "mode")}
        apart = one(usual(rows), **same)
        lines.append([label(joined["scene"]), joined["test"], joined["tree"], joined["mode"],
                      number(apart["kinds"]["global"]["stored"]),
                      number(apart["kinds"]["caustic"]["stored"]),
                      seconds(apart["net_s"]), seconds(joined["net_s"]),
                      written(ratio(apart, joined)), written(ratio(apart, joined, built)),
                      *(f"{100 * error:.1f} %" for pair in zip(apart["errors"], joined["errors"])
                        for error in pair)])
    return table(["scene", "test", "tree", "mode", "global photons", "caustic photons",
                  "net apart, s", "net together, s", "net: apart / together",
                  "build: apart / together", "error apart", "error together",
                  "error apart, lit by caustics", "error together, lit by caustics"], lines)


def caustic_table(rows):
    """rows: the experiment's, mode thesis on balanced trees."""
    lines = []
    for row in usual(rows, mode="thesis", tree="balanced"):
        if row["test"] not in (2, 5):
            continue
        for name, kind in row["kinds"].items():
            answered, lost = local_shares([kind])
            lines.append([label(row["scene"]), row["test"], name, number(kind["stored"]),
                          kind["shared_maps"], kind["local_maps"], percent(answered),
                          percent(lost)])
    return table(["scene", "test", "photons", "stored", "shared maps", "local maps",
                  "searches answered in local maps", "abandoned"], lines)


def filter_table(rows):
    lines = [[label(row["scene"]), row["test"], row["rule"],
              *(f"{100 * float(row[name]):.1f} %" for name in ("answered", "in vain", "missed")),
              *(f"{ratios.mean_cost(row[name]):.0f}" for name in FILTER_TIMES)] for row in rows]
    return table(["scene", "test", "radius predicted by", "answered", "begun in vain", "missed",
                  "balanced, ns", "wide, ns"], lines)


def clipped_table(rows):
    lines = []
    for ours in usual(rows, estimate="clipped"):
        plain = shared_row(rows, ours["scene"], ours["test"], "wide")
        lines.append([label(ours["scene"]), ours["test"], seconds(plain["net_s"]),
                      seconds(ours["net_s"]), written(ratio(ours, plain))])
    return table(["scene", "test", "the dissertation's, s", "ours, s", "ours / theirs"], lines)


def built(row):
    return row["build_runs"]


def unbalanced_lines(rows):
    """rows: mode global of one scene and test."""
    first, *others = (one(rows, tree=tree) for tree in ONE_MAP_TREES)
    return [[label(row["scene"]), row["test"], row["tree"], seconds(row["build_s"]),
             seconds(row["net_s"]),
             *(("1", "1") if row is first else
               (written(ratio(first, row, built)), written(ratio(first, row))))]
            for row in (first, *others)]


def unbalanced_table(rows):
    lines = []
    for row in usual(rows, mode="global", tree="midpoint"):
        lines += unbalanced_lines(usual(rows, scene=row["scene"], test=row["test"], mode="global"))
    return table(["scene", "test", "tree", "build, s", "net, s", "build: balanced / this",
                  "net: balanced / this"], lines)


def best_ratio(rows):
    """A sentence."""
    said = []
    for scene in asked_scenes(rows):
        for tree in ("balanced", "wide"):
            best = min(thesis_by_ratio(rows, scene, tree), key=lambda row: row["net_s"])
            gain = ratio(shared_row(rows, scene, ASKED[scene], tree), best)
            clear = {True: "gains", False: "loses", None: "undecided"}[gain and gain.exceeds(1)]
            said.append(f"on scene {label(scene)}, {tree} trees, M = {best['ratio']} k ({clear}: "
                        f"shared / thesis {written(gain)})")
    return "Least net cost: " + "; ".join(said) + ".\n"


def most_by_prediction(rows):
    """What a perfect filter radius would gain over shared maps alone."""
    said = []
    for scene in values(rows, "scene"):
        alone, right, theirs = (one(rows, scene=scene, rule=rule) for rule in
                                ("shared map alone", "the right one", "r' of the dissertation"))
        for name in FILTER_TIMES:
            best, now = (written(ratios.of_rounds(alone[name], row[name])) for row in (right, theirs))
            said.append(f"scene {scene}, {name.removeprefix('ns ')} trees: {best} times as fast with a "
                        f"rule that is always right, {now} with r'")
    return "Against the shared map alone, " + "; ".join(said) + ".\n"
