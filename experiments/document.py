"""Writes docs/experiments.md from the results."""

import claims
import identical
import questions
import tables
from measure import (ANGLE_DEG, CELLS, EVERY, LEAST_ROUNDS, MANY_PATHS, MOST_REFERENCE,
                     PRECISE, REFERENCE, ROUNDS_OF_MANY, label, maps, ratio)
from ratios import written
from tables import percent, pick, seconds, table, usual, values


def introduction(results, root):
    about = results["about"]
    every = " and ".join(f"one of {number} in test {test}" for test, number in EVERY.items())
    return f"""# The experiment of the dissertation, done again

Written by `experiments/run_experiment.py`; do not edit. Every figure below is from that run and in
[results.json](experiments/results.json). Scenes and settings: [experiments/README.md]({root}/experiments/README.md).
Run on {about["date"]}; {about["machine"]}; measured in {about["minutes"]:.0f} minutes; images {about["size"]} pixels
wide, one sample a pixel; angle threshold {ANGLE_DEG} degrees; M = 10 k; the dissertation's estimate
(`--estimate thesis`). Photons emitted and k are the dissertation's divided by {about["divide"]}.
{missing(about)}
Seconds are of the processor. The program `map_costs` traces the photons of a scene and test once. In every round it builds new maps
for every mode and tree, and renders the same image by each of them. They take turns, eight rows each, in an order that
changes, so that what else the machine does falls on all alike. Rounds end when every ratio on trees of one kind has an interval
within {percent(PRECISE)}: {min(LEAST_ROUNDS, about["most_rounds"])} rounds at least, {about["most_rounds"]} at most; {min(ROUNDS_OF_MANY, about["most_rounds"])} with {MANY_PATHS:,} light paths or more. Where k is large not all
bands of eight rows are rendered: {every}; seconds are those of a whole image.
Seconds are geometric means of the rounds. A ratio is the geometric mean of the rounds' ratios, with its 95 % confidence interval in
brackets (Student's, of the logarithms). Photons are the same in all rounds, so that no interval holds what other photons would change.

Building is splitting and ordering the photons. The **net query cost** is the time to render an image whose
light comes from the photons alone less the time to render it with empty maps. Caustic photons have maps of
their own in every mode. `balanced` is Jensen's kd-tree, `unbalanced` one made by inserting, `midpoint` one whose cells are halved, `wide`
hipmap's ([photon_maps.md]({root}/docs/photon_maps.md)). Other methods beside photon maps: [rivals.md]({root}/docs/rivals.md).
"""


def missing(about):
    """A sentence, or nothing."""
    if not about["missing"]:
        return ""
    return f"""
**Not all of it was measured**: {", ".join(about["missing"])} are missing. Claims about them are marked as not measured.
"""


def identical_part(results):
    differing = identical.complaints(results)
    said = "; ".join(differing) if differing else "all ratios are 1 within their intervals"
    return f"""## Identical computations

Mode `shared` is measured twice in each round and on each kind of tree, the second time as a control. Where another mode has no local
and no group map, it makes the same searches too. Their costs differ by noise alone. Checked at a probability of 5 % that any of the intervals misses 1 by chance: {said}.

{identical.identical_table(results)}"""


def scene_3(rows):
    """Local maps against shared maps alone where the dissertation has 40 s against 85 s."""
    lines = [["dissertation", "-", "1,152,000", 12, 529, "85", "40", f"{85 / 40:.2f}"]]
    for scene in (3, CELLS):
        found = pick(rows, scene=scene, test=2)
        for tree in ("balanced", "unbalanced", "wide") if found else ():
            shared, both = (tables.one(found, tree=tree, mode=mode) for mode in ("shared", "thesis"))
            lines.append([f"scene {label(scene)}", tree, tables.number(both["stored"]),
                          *(maps(both, "global", level) for level in ("shared_maps", "local_maps")),
                          seconds(shared["net_s"]), seconds(both["net_s"]),
                          written(ratio(shared, both))])
    return ("## Scene 3, test 2: Table 1 of the dissertation\n\n" + """The text is not at hand. What is known of its numbers for scene 3 is the one row below, taken to be that of its Table 1. The
local maps of scene 3 lie on the chair and the other furniture, but for those of the twelve triangles of its walls; those of *3, walls in cells*
lie on walls that were cut up to have as many.

""" + table(
        ["", "tree", "photons", "shared maps of global photons", "local maps of global photons",
         "shared maps alone, s", "shared and local maps, s", "shared / thesis"], lines))


def creases_part(creases, drawn):
    if not creases:
        return ""
    corner = next(row for row in creases if row["crease"] == "corner")
    ours = [float(row["shared clipped"]) for row in creases]
    parts = ["## Creases and leaks\n", f"""Irradiance in a room where it is 1 everywhere, and on a floor where it is 0 between walls
where it is 1 (k = 50). At an edge the dissertation's estimate falls to
{percent(float(creases[0]["shared thesis"]))}, in a corner to {percent(float(corner["shared thesis"]))}; over the visible
area it stays between {100 * min(ours):.2f} % and {100 * max(ours):.2f} % at every distance. One map shows {percent(float(creases[0]["dark global"]))} of the
wall's light on the dark floor, shared maps {percent(float(creases[0]["dark shared"]))}.
"""]
    if "creases" in drawn:
        parts.append(f"![Irradiance near creases]({drawn['creases']})\n")
    return "\n".join(parts)


MAP_LEVELS = """Mode `hierarchical` adds maps of groups of faces. On wide trees a
map level is used only where it is expected to pay ([photon_maps.md]({root}/docs/photon_maps.md) (8)); `--tiers all`
forces it. On kd-trees it is always used.
"""
UNBALANCED = """Mode `global`. `unbalanced` is built by inserting photon after photon, `midpoint` all
at once: cells are split in their middle. Both are searched alike.
"""
REBUILT = """Measured: the processor time to build all shared maps of one set of photons, and to build one of them alone from its own
photons, for the largest map and the median map by photons. Photons of caustics are left out. Not measured: finding out which maps a change of the
scene concerns, and tracing their photons again, without which a map has nothing new to be built of.
"""
APART = """In every other measurement caustic photons have maps of their own, so that a point makes two
searches. Here they are also put into the maps of the others, and one search finds k photons of both. Errors are the root of the mean square
difference to an image of {reference} times the light paths ({most:,} at most) and 8 times the neighbours, by the default estimate, over that image's mean: of all
pixels, and of those that get a tenth of their light or more from caustic photons. They are of one set of photons, without an interval.
"""
FILTER = """A search is begun in a local map if the radius predicted for it is
within the limiting radius. Of all searches on faces with a local map: those answered there, those begun in vain
and then repeated in the shared map, and those that would have been answered but were not begun; and
what one search takes in all. No rule can do better than the one that is always right.
"""


def caustics_part(rows):
    return ["### Caustic photons apart from the others, and together\n",
            APART.format(reference=REFERENCE, most=MOST_REFERENCE), questions.together_table(rows),
            "Apart, mode `thesis` on balanced trees, by kind of photon:\n",
            questions.caustic_table(rows)]


def open_questions(results, root):
    rows = results["rows"]
    parts = ["## What the dissertation left open\n"]
    if questions.asked_scenes(rows):
        parts += ["### The ratio of M to k\n", questions.best_ratio(rows),
                  questions.ratio_table(rows)]
    parts += ["### Group maps\n", MAP_LEVELS.format(root=root), questions.tier_table(rows),
              "### Unbalanced trees\n", UNBALANCED, questions.unbalanced_table(rows),
              *caustics_part(rows)]
    if results["rebuilds"]:
        parts += ["### One map rebuilt alone\n", REBUILT, questions.rebuild_table(results["rebuilds"])]
    if results["filter"]:
        parts += ["### A better filter radius\n", FILTER,
                  questions.most_by_prediction(results["filter"]),
                  questions.filter_table(results["filter"])]
    return "\n".join([*parts, "### What an estimate without dark creases costs\n",
                      "Net query cost of mode `shared` on wide trees, by estimate.\n",
                      questions.clipped_table(rows)])


def write(results, drawn, root):
    """The document.  drawn: {name: address of a picture}.  root: address of the repository."""
    rows = usual(results["rows"])
    parts = [introduction(results, root), "## What became of its claims\n",
             f"Decided by rule ([claims.py]({root}/experiments/claims.py)) from the numbers.\n",
             claims.RULES, claims.claims_table(results)]
    if "local_tier" in drawn:
        parts.append(f"![Local maps against shared maps alone]({drawn['local_tier']})\n")
    parts += [scene_3(rows), creases_part(results["creases"], drawn), open_questions(results, root),
              identical_part(results), "## Photons and maps\n\nIn mode `thesis` on balanced trees. Maps "
              "of global and of caustic photons are counted apart. Counts are exact.\n",
              tables.stored_table(rows)]
    parts += [tables.scene_part(rows, scene, drawn) for scene in values(rows, "scene")]
    return "\n".join(part for part in parts if part)
