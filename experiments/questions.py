"""What the dissertation left open: measures, and tables of what came out."""

import csv

from measure import (Setting, light_paths, measure_together, neighbours, ratio, run_tool,
                     scene_path)
from tables import number, one, percent, pick, seconds, table, times, values

RATIOS = (2, 5, 10, 20, 50)  # M / k
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


def batches(scenes, tests):
    """{question: lists of settings to be measured together}"""
    asked = [scene for scene in scenes if scene in ASKED and ASKED[scene] in tests]
    some = [test for test in (2, 4) if test in tests]
    return {"ratio": [ratio_settings(scene, tree) for scene in asked
                      for tree in ("balanced", "wide")],
            "tiers": [tier_settings(scene, test) for scene in scenes for test in some],
            "clipped": [clipped_settings(scene, test) for scene in scenes for test in some]}


def measure_batches(bench, all_batches, ran):
    return {name: [row for settings in lists for row in measure_together(bench, settings, ran)]
            for name, lists in all_batches.items()}


def run_filter(bench, scenes, tests):
    """Rows of filter_radius; CSV by the scene and test."""
    rows = []
    for scene, test in ASKED.items():
        if scene not in scenes or test not in tests:
            continue
        text = run_tool(bench, "filter_radius", scene_path(scene), "--photons",
                        light_paths(bench, scene, test), "--neighbours", neighbours(bench, test),
                        "--size", bench.size)
        rows += [{"scene": scene, "test": test, **row}
                 for row in csv.DictReader(text.splitlines(), delimiter=";")]
    return rows


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


def ratio_table(rows):
    lines = []
    for scene in values(rows, "scene"):
        for tree in ("balanced", "wide"):
            shared = one(rows, scene=scene, tree=tree, mode="shared")
            for row in pick(rows, scene=scene, tree=tree, mode="thesis"):
                answered, lost = local_shares(row["kinds"].values())
                lines.append([scene, row["test"], tree, row["ratio"], row["local_maps"],
                              percent(answered), percent(lost), seconds(row["build_s"]),
                              seconds(row["net_s"]), times(ratio(shared, row))])
    return table(["scene", "test", "tree", "M / k", "local maps", "answered there", "abandoned",
                  "build, s", "net, s", "shared / both"], lines)


def tier_table(rows, main_rows):
    lines = []
    for scene in values(rows, "scene"):
        for test in values(pick(rows, scene=scene), "test"):
            found = pick(rows, scene=scene, test=test)
            shared = one(found, mode="shared")
            paying, every = (one(found, mode="hierarchical", tiers=t) for t in ("paying", "all"))
            old = [one(main_rows, scene=scene, test=test, tree="balanced", mode=mode)
                   for mode in ("shared", "thesis", "hierarchical")]
            lines.append([scene, test, paying["local_maps"] + paying["group_maps"],
                          every["local_maps"], every["group_maps"], times(ratio(shared, paying)),
                          times(ratio(shared, every)), seconds(shared["build_s"]),
                          seconds(every["build_s"]),
                          *((times(ratio(old[0], row)) for row in old[1:]) if all(old)
                            else ("-", "-"))])
    return table(["scene", "test", "maps of tiers that pay", "local maps, all tiers",
                  "group maps, all tiers", "wide: shared / paying", "wide: shared / all",
                  "build shared, s", "build all, s", "balanced: shared / both of the thesis",
                  "balanced: shared / three tiers"], lines)


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
              row["ns balanced"], row["ns wide"]] for row in rows]
    return table(["scene", "test", "radius predicted by", "answered", "begun in vain", "missed",
                  "balanced, ns", "wide, ns"], lines)


def clipped_table(rows):
    lines = []
    for scene in values(rows, "scene"):
        for test in values(pick(rows, scene=scene), "test"):
            plain, ours = (one(rows, scene=scene, test=test, estimate=estimate)
                           for estimate in ("thesis", "clipped"))
            lines.append([scene, test, seconds(plain["net_s"]), seconds(ours["net_s"]),
                          times(ratio(ours, plain))])
    return table(["scene", "test", "the dissertation's, s", "ours, s", "ours / theirs"], lines)


def best_ratio(rows):
    """A sentence."""
    said = []
    for scene in values(rows, "scene"):
        for tree in ("balanced", "wide"):
            shared = one(rows, scene=scene, tree=tree, mode="shared")
            best = min(pick(rows, scene=scene, tree=tree, mode="thesis"),
                       key=lambda row: row["net_s"])
            gain = ratio(shared, best)
            clear = "gains" if gain[1] > 1 else "loses" if gain[2] < 1 else "makes no clear odds"
            said.append(f"on scene {scene}, {tree} trees, M = {best['ratio']} k ({clear}: "
                        f"{times(gain)} of shared maps alone)")
    return "Least net cost: " + "; ".join(said) + ".\n"


def most_by_foresight(rows):
    """What a perfect filter radius would gain over shared maps alone."""
    said = []
    for scene in values(rows, "scene"):
        alone, right, theirs = (one(rows, scene=scene, rule=rule) for rule in
                                ("shared map alone", "the right one", "r' of the dissertation"))
        for tree in ("balanced", "wide"):
            name = f"ns {tree}"
            said.append(f"scene {scene}, {tree} trees: {float(alone[name]) / float(right[name]):.3f}"
                        f" times as fast with a rule that is always right, "
                        f"{float(alone[name]) / float(theirs[name]):.3f} with r'")
    return "Against the shared map alone, " + "; ".join(said) + ".\n"
