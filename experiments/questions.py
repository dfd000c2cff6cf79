"""What the dissertation left open: measures, and tables of what came out."""

import csv
import itertools

import ratios
from measure import (LEVELS, Setting, light_paths, maps, neighbours, ratio, rounds, run_tool,
                     scene_path)
from ratios import written
from tables import number, one, percent, pick, seconds, table, values

RATIOS = (2, 5, 10, 20, 50)  # M / k
ONE_MAP_TREES = ("balanced", "unbalanced", "midpoint", "wide")
REBUILD_TIMES = ("ms all", "ms largest", "ms median")
FILTER_TIMES = ("ns balanced", "ns wide")
ASKED = {2: 3, 3: 2}  # scene: test in which the ratio and the filter radius are asked for


def ratio_settings(scene, tree):
    test = ASKED[scene]
    return [Setting(scene, test, "shared", tree),
            *(Setting(scene, test, "thesis", tree, ratio=ratio_) for ratio_ in RATIOS)]


def tier_settings(scene, test):
    return [Setting(scene, test, "shared", "wide"), Setting(scene, test, "hierarchical", "wide"),
            Setting(scene, test, "hierarchical", "wide", tiers="all")]


def clipped_settings(scene, test):
    """The same maps with the dissertation's estimate and with ours."""
    return [Setting(scene, test, "shared", "wide", estimate=estimate)
            for estimate in ("thesis", "clipped")]


def some_of(tests):
    """The tests in which most questions are asked."""
    return [test for test in (2, 4) if test in tests]


def unbalanced_settings(scene, test):
    """One map in trees of each kind."""
    return [Setting(scene, test, "global", tree) for tree in ONE_MAP_TREES]


def batches(scenes, tests):
    """{question: lists of settings to be measured together}"""
    asked = [scene for scene in scenes if scene in ASKED and ASKED[scene] in tests]
    some = some_of(tests)
    return {"ratio": [ratio_settings(scene, tree) for scene in asked
                      for tree in ("balanced", "wide")],
            "tiers": [tier_settings(scene, test) for scene in scenes for test in some],
            "unbalanced": [unbalanced_settings(scene, test) for scene in scenes for test in some],
            "clipped": [clipped_settings(scene, test) for scene in scenes for test in some]}


def measure_batches(all_batches, measured):
    """measured(settings): their rows."""
    return {name: [row for settings in lists for row in measured(settings)]
            for name, lists in all_batches.items()}


def filter_rows(bench, scene, test):
    text = run_tool(bench, "filter_radius", scene_path(scene), "--photons",
                    light_paths(bench, scene, test), "--neighbours", neighbours(bench, test),
                    "--size", bench.size)
    return list(csv.DictReader(text.splitlines(), delimiter=";"))


def run_filter(bench, scenes, tests):
    """Rows of filter_radius; CSV by the scene and test.  Nanoseconds are of each round."""
    rows = []
    for scene, test in ASKED.items():
        if scene not in scenes or test not in tests:
            continue
        measured = [filter_rows(bench, scene, test) for _ in range(rounds(bench, scene, test))]
        rows += [{"scene": scene, "test": test, **same[0],
                  **{name: [float(row[name]) for row in same] for name in FILTER_TIMES}}
                 for same in zip(*measured)]
    return rows


def run_rebuilds(bench, scenes, tests):
    """A row by scene, test and tree; milliseconds are of each round."""
    rows = {}
    for scene, test in itertools.product(scenes, some_of(tests)):
        text = run_tool(bench, "rebuild_maps", scene_path(scene), "--photons",
                        max(1000, light_paths(bench, scene, test)), "--neighbours",
                        neighbours(bench, test), "--rounds", rounds(bench, scene, test))
        for line in csv.DictReader(text.splitlines(), delimiter=";"):
            row = rows.setdefault((scene, test, line["tree"]), {
                "scene": scene, "test": test, "tree": line["tree"],
                **{name: int(line[name]) for name in ("maps", "photons", "largest", "median")},
                **{name: [] for name in REBUILD_TIMES}})
            for name in REBUILD_TIMES:
                row[name].append(float(line[name]))
    return list(rows.values())


def rebuild_table(rows):
    lines = [[row["scene"], row["test"], row["tree"], row["maps"], number(row["photons"]),
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


def level_maps(row, level):
    """Maps of a level, of both kinds of photons."""
    return sum(maps(row, kind, level) for kind in row["kinds"])


def ratio_table(rows):
    lines = []
    for scene in values(rows, "scene"):
        for tree in ("balanced", "wide"):
            shared = one(rows, scene=scene, tree=tree, mode="shared")
            for row in pick(rows, scene=scene, tree=tree, mode="thesis"):
                answered, lost = local_shares(row["kinds"].values())
                lines.append([scene, row["test"], tree, row["ratio"], level_maps(row, "local_maps"),
                              percent(answered), percent(lost), seconds(row["build_s"]),
                              seconds(row["net_s"]), written(ratio(shared, row))])
    return table(["scene", "test", "tree", "M / k", "local maps", "answered there", "abandoned",
                  "build, s", "net, s", "shared / thesis"], lines)


def tier_table(rows, main_rows):
    lines = []
    for scene in values(rows, "scene"):
        for test in values(pick(rows, scene=scene), "test"):
            found = pick(rows, scene=scene, test=test)
            shared = one(found, mode="shared")
            paying, every = (one(found, mode="hierarchical", tiers=t) for t in ("paying", "all"))
            old = [one(main_rows, scene=scene, test=test, tree="balanced", mode=mode)
                   for mode in ("shared", "thesis", "hierarchical")]
            lines.append([scene, test, sum(level_maps(paying, level) for level in LEVELS[1:]),
                          *(level_maps(every, level) for level in LEVELS[1:]),
                          written(ratio(shared, paying)),
                          written(ratio(shared, every)), seconds(shared["build_s"]),
                          seconds(every["build_s"]),
                          *((written(ratio(old[0], row)) for row in old[1:]) if all(old)
                            else ("-", "-"))])
    return table(["scene", "test", "maps of levels that pay", "local maps, all levels",
                  "group maps, all levels", "wide: shared / paying", "wide: shared / all",
                  "build shared, s", "build all, s", "balanced: shared / thesis",
                  "balanced: shared / hierarchical"], lines)


def caustic_table(rows):
    """rows: the experiment's, mode thesis on balanced trees."""
    lines = []
    for row in pick(rows, mode="thesis", tree="balanced"):
        if row["test"] not in (2, 5):
            continue
        for name, kind in row["kinds"].items():
            answered, lost = local_shares([kind])
            lines.append([row["scene"], row["test"], name, number(kind["stored"]),
                          kind["shared_maps"], kind["local_maps"], percent(answered),
                          percent(lost)])
    return table(["scene", "test", "photons", "stored", "shared maps", "local maps",
                  "searches answered in local maps", "abandoned"], lines)


def filter_table(rows):
    lines = [[row["scene"], row["test"], row["rule"],
              *(f"{100 * float(row[name]):.1f} %" for name in ("answered", "in vain", "missed")),
              *(f"{ratios.mean_cost(row[name]):.0f}" for name in FILTER_TIMES)] for row in rows]
    return table(["scene", "test", "radius predicted by", "answered", "begun in vain", "missed",
                  "balanced, ns", "wide, ns"], lines)


def clipped_table(rows):
    lines = []
    for scene in values(rows, "scene"):
        for test in values(pick(rows, scene=scene), "test"):
            plain, ours = (one(rows, scene=scene, test=test, estimate=estimate)
                           for estimate in ("thesis", "clipped"))
            lines.append([scene, test, seconds(plain["net_s"]), seconds(ours["net_s"]),
                          written(ratio(ours, plain))])
    return table(["scene", "test", "the dissertation's, s", "ours, s", "ours / theirs"], lines)


def built(row):
    return row["build_runs"]


def unbalanced_table(rows):
    lines = []
    for scene in values(rows, "scene"):
        for test in values(pick(rows, scene=scene), "test"):
            first, *others = (one(rows, scene=scene, test=test, tree=tree) for tree in ONE_MAP_TREES)
            lines += [[scene, test, row["tree"], seconds(row["build_s"]), seconds(row["net_s"]),
                       *(("1", "1") if row is first else
                         (written(ratio(first, row, built)), written(ratio(first, row))))]
                      for row in (first, *others)]
    return table(["scene", "test", "tree", "build, s", "net, s", "build: balanced / this",
                  "net: balanced / this"], lines)


def best_ratio(rows):
    """A sentence."""
    said = []
    for scene in values(rows, "scene"):
        for tree in ("balanced", "wide"):
            shared = one(rows, scene=scene, tree=tree, mode="shared")
            best = min(pick(rows, scene=scene, tree=tree, mode="thesis"),
                       key=lambda row: row["net_s"])
            gain = ratio(shared, best)
            clear = {True: "gains", False: "loses", None: "undecided"}[gain and gain.exceeds(1)]
            said.append(f"on scene {scene}, {tree} trees, M = {best['ratio']} k ({clear}: "
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
