"""Writes docs/experiments.md from the results."""

import claims
import identical
import questions
import tables
from measure import (ANGLE_DEG, LEAST_ROUNDS, MANY_PATHS, PRECISE, ROUNDS_OF_MANY, maps,
                     ratio)
from ratios import written
from tables import percent, pick, seconds, table, values


def introduction(results, root):
    about = results["about"]
    return f"""# The experiment of the dissertation, done again

Written by `experiments/run_experiment.py`; do not edit. Every figure below is from that run and in
[results.json](experiments/results.json). Scenes and settings: [experiments/README.md]({root}/experiments/README.md).
Run on {about["date"]}; {about["machine"]}; measured in {about["minutes"]:.0f} minutes; images {about["size"]} pixels
wide, one sample a pixel; angle threshold {ANGLE_DEG} degrees; M = 10 k; the dissertation's estimate
(`--estimate thesis`). Photons emitted and k are the dissertation's divided by {about["divide"]}.

Seconds are of the processor, of all threads together, so that other programs disturb them little. Each
scene and test was run in rounds through all modes and trees, in an order that changes, until every ratio on trees
of one kind had an interval within {percent(PRECISE)}: {min(LEAST_ROUNDS, about["most_rounds"])} rounds at least, {about["most_rounds"]} at most ({min(ROUNDS_OF_MANY, about["most_rounds"])}
with {MANY_PATHS:,} light paths or more). Seconds are
geometric means of the rounds. A ratio is the geometric mean of the rounds' ratios, with its 95 % confidence interval in
brackets (Student's, of the logarithms). Images whose photons take less than {about.get("net_seconds", 0):g} s are rendered
larger, and their seconds are those of as many pixels.
{again(about)}Building is splitting and ordering the photons. The **net query cost** is the time to render an image whose
light comes from the photons alone less the time to render it without photons. Caustic photons have maps of
their own in every mode. `balanced` is Jensen's kd-tree, `unbalanced` one made by inserting, `midpoint` one whose cells are halved, `wide`
hipmap's ([photon_maps.md]({root}/docs/photon_maps.md)). Other methods beside photon maps: [rivals.md]({root}/docs/rivals.md).
"""


def again(about):
    """What replaced rows of the run: a sentence, or nothing."""
    return f"Measured anew after the run: {'; '.join(about['again'])}.\n" if "again" in about else ""


def identical_part(results):
    differing = identical.complaints(results)
    said = "; ".join(differing) if differing else "all ratios are 1 within their intervals"
    return f"""## Identical computations

Where a mode has no local and no group map, it makes the searches of mode `shared`, and costs differ by noise
alone. Checked at a probability of 5 % that any of the intervals misses 1 by chance: {said}.

{identical.identical_table(results)}"""


def scene_3(rows):
    """Local maps against shared maps alone where the dissertation has 40 s against 85 s."""
    found = pick(rows, scene=3, test=2)
    if not found:
        return ""
    lines = [["dissertation", "1,152,000", 12, 529, "85", "40", f"{85 / 40:.2f}"]]
    for tree in ("balanced", "unbalanced", "wide"):
        shared, both = (tables.one(found, tree=tree, mode=mode) for mode in ("shared", "thesis"))
        lines.append([f"here, {tree}", tables.number(both["stored"]),
                      *(maps(both, "global", level) for level in ("shared_maps", "local_maps")),
                      seconds(shared["net_s"]), seconds(both["net_s"]),
                      written(ratio(shared, both))])
    return ("## Scene 3, test 2: local maps beside Larsen's maps\n\n" + table(
        ["", "photons", "shared maps of global photons", "local maps of global photons",
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


def open_questions(results, root):
    asked = results["questions"]
    parts = ["## What the dissertation left open\n"]
    if asked["ratio"]:
        parts += ["### The ratio of M to k\n", questions.best_ratio(asked["ratio"]),
                  questions.ratio_table(asked["ratio"])]
    if asked["tiers"]:
        parts += ["### Group maps\n", f"""Mode `hierarchical` adds maps of groups of faces. On wide trees a
map level is used only where it is expected to pay ([photon_maps.md]({root}/docs/photon_maps.md) (8)); `--tiers all`
forces it. On kd-trees it is always used.
""", questions.tier_table(asked["tiers"], results["rows"])]
    if asked.get("unbalanced"):
        parts += ["### Unbalanced trees\n", """Mode `global`. `unbalanced` is built by inserting photon after photon, `midpoint` all
at once: cells are split in their middle. Both are searched alike.
""", questions.unbalanced_table(asked["unbalanced"])]
    if results.get("rebuilds"):
        parts += ["### One map rebuilt alone\n", """Processor time to build all shared maps of one set of photons, and of the photons
of one map alone: the largest, and the median map by photons. Photons of caustics are left out.
""", questions.rebuild_table(results["rebuilds"])]
    parts += ["### Caustics apart from the rest\n",
              "Mode `thesis` on balanced trees, by kind of photon.\n",
              questions.caustic_table(results["rows"])]
    if results["filter"]:
        parts += ["### A better filter radius\n", """A search is begun in a local map if the radius predicted for it is
within the limiting radius. Of all searches on faces with a local map: those answered there, those begun in vain
and then repeated in the shared map, and those that would have been answered but were not begun; and
what one search takes in all. No rule can do better than the one that is always right.
""", questions.most_by_prediction(results["filter"]), questions.filter_table(results["filter"])]
    if asked["clipped"]:
        parts += ["### What an estimate without dark creases costs\n",
                  "Net query cost of mode `shared` on wide trees, by estimate.\n",
                  questions.clipped_table(asked["clipped"])]
    return "\n".join(parts)


def write(results, drawn, root):
    """The document.  drawn: {name: address of a picture}.  root: address of the repository."""
    rows = results["rows"]
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
