"""Tables of what the experiment measured, in Markdown."""

import dataclasses

from measure import LEVELS, MODES, SCENES, TREES, Setting, label, maps, ratio
from ratios import written

# Photons stored in tests 1 to 5 by the dissertation; it says no more of scene 3.
DISSERTATION_STORED = {1: (26019, 50513, 152881, 384119, 778138),
                       2: (7814, 16178, 48869, 97588, 180389),
                       3: (None, 1152000, None, None, None)}
DISSERTATION_STORED[4] = DISSERTATION_STORED[3]
DISSERTATION_SHARED_PERCENT = {1: 80, 2: 52, 3: 2, 4: 2}
USUAL = {field.name: field.default for field in dataclasses.fields(Setting)
         if field.default is not dataclasses.MISSING}


def table(headers, rows):
    lines = [headers, ["---"] * len(headers), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def number(value):
    return "-" if value is None else f"{value:,}"


def seconds(value):
    return f"{value:.3f}" if value < 10 else f"{value:.1f}"


def percent(share, digits=0):
    return f"{100 * share:.{digits}f} %"


def pick(rows, **wanted):
    """The rows that have these values."""
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def usual(rows, **others):
    """The rows of settings that differ from the experiment's in the others at most."""
    return pick(rows, **{**USUAL, **others})


def one(rows, **wanted):
    """The only row that has these values; none if it was not measured."""
    found = pick(rows, **wanted)
    return found[0] if len(found) == 1 else None


def values(rows, key):
    return sorted({row[key] for row in rows})


def net_table(rows, tree):
    """rows: of one scene.  Tables 3 and 4 of the dissertation."""
    lines = []
    for test in values(rows, "test"):
        row = {mode: one(rows, test=test, tree=tree, mode=mode) for mode in MODES}
        lines.append([test, number(row["global"]["stored"]),
                      *(seconds(row[mode]["net_s"]) for mode in MODES),
                      *(written(ratio(row["global"], row[mode])) for mode in MODES[1:])])
    against = [f"global / {mode}" for mode in MODES[1:]]
    return table(["test", "photons", *(f"{mode}, s" for mode in MODES), *against], lines)


def counted(row):
    """The maps that a rendering searched, by kind of photon; levels without maps are left out."""
    said = []
    for kind in ("global", "caustic"):
        counts = [(maps(row, kind, level), level.removesuffix("_maps")) for level in LEVELS]
        said.append(f"{kind} " + " + ".join(f"{count} {name}" for count, name in counts if count))
    return "; ".join(said)


def raw_table(rows, mode):
    """rows: of one scene.  Tables 5 to 9 of the dissertation."""
    lines = []
    for test in values(rows, "test"):
        row = {tree: one(rows, test=test, tree=tree, mode=mode) for tree in TREES}
        first = row["balanced"]
        lines.append([test, first["k"], number(first["emitted"]), number(first["stored"]),
                      counted(first), counted(row["wide"]), len(first["image_runs"]),
                      *(seconds(row[tree]["build_s"]) for tree in TREES),
                      *(seconds(row[tree]["image_s"]) for tree in TREES),
                      seconds(first["empty_s"])])
    return table(["test", "k", "emitted", "stored", "maps of kd-trees", "maps of wide trees", "rounds",
                  *(f"build {tree}, s" for tree in TREES),
                  *(f"render {tree}, s" for tree in TREES), "empty, s"], lines)


def stored_table(rows):
    """Whether the scenes store what the dissertation's did, in mode thesis."""
    lines = []
    for scene in values(rows, "scene"):
        for row in pick(rows, scene=scene, tree="balanced", mode="thesis"):
            theirs = DISSERTATION_STORED[scene][row["test"] - 1]
            shared, local = (maps(row, "global", level) for level in LEVELS[:2])
            lines.append([label(scene), row["test"], number(row["emitted"]), number(row["aimed"]),
                          number(row["stored"]), number(theirs),
                          f"{row['stored'] / theirs:.2f}" if theirs else "-", shared, local,
                          percent(shared / (shared + local)),
                          f"{DISSERTATION_SHARED_PERCENT[scene]} %",
                          *(maps(row, "caustic", level) for level in LEVELS[:2])])
    return table(["scene", "test", "emitted", "aimed besides", "stored", "theirs", "ours / theirs",
                  "global: shared maps", "global: local maps", "global: shared of all", "theirs",
                  "caustic: shared maps", "caustic: local maps"], lines)


def scene_part(rows, scene, drawn):
    """All of one scene.  drawn: {name: address of a picture}."""
    rows = pick(rows, scene=scene)
    parts = [f"## Scene {label(scene)}: `{SCENES[scene]}`\n"]
    if f"render_{scene}" in drawn:
        parts.append(table(["rendered", "its shared maps"], [[
            f"![scene {label(scene)}]({drawn[f'render_{scene}']})",
            f"![its partition]({drawn[f'maps_{scene}']})"]]))
    if f"net_{scene}" in drawn:
        parts.append(f"![Net query cost of scene {label(scene)}]({drawn[f'net_{scene}']})\n")
    for tree in TREES:
        parts.append(f"Net query cost, {tree} trees:\n")
        parts.append(net_table(rows, tree))
    for mode in MODES:
        parts.append(f"Mode `{mode}`:\n")
        parts.append(raw_table(rows, mode))
    return "\n".join(parts)
