"""Plots of what the experiment measured; none where matplotlib is not installed."""

from measure import CELLS, MODES, SCENES, TREES, label, ratio
from tables import one, pick, usual, values

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    pyplot = None

COLOURS = {"global": "#b3412e", "shared": "#2f6db3", "thesis": "#d99a1c", "hierarchical": "#3a8f4b"}
MARKERS = {"global": "o", "shared": "s", "thesis": "^", "hierarchical": "D"}


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    pyplot.close(figure)


def draw_net(rows, path):
    """rows: of one scene.  Figures 15 to 17 of the dissertation, for each kind of tree."""
    figure, panels = pyplot.subplots(1, len(TREES), figsize=(12, 3.8))
    for axes, tree in zip(panels, TREES):
        for mode in MODES:
            points = sorted((row["stored"] / 1e6, row["net_s"])
                            for row in pick(rows, tree=tree, mode=mode))
            axes.plot(*zip(*points), marker=MARKERS[mode], color=COLOURS[mode], label=mode,
                      markersize=5, alpha=0.85)
        axes.set_title(f"{tree} trees")
        axes.set_xlabel("photons stored, millions")
        axes.set_ylabel("net query cost, processor s")
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.25)
    panels[0].legend()
    figure.suptitle(f"Scene {label(rows[0]['scene'])}: {SCENES[rows[0]['scene']]}")
    save(figure, path)


def interval(found):
    return found.bounds() if found.freedom else (found.value, found.value)


def draw_local_tier(rows, path):
    """How many times faster than shared maps alone local maps make it, with intervals."""
    scenes = [scene for scene in values(rows, "scene") if scene != CELLS]
    figure, panels = pyplot.subplots(1, len(scenes), figsize=(4 * len(scenes), 3.6), squeeze=False,
                                     sharey=True)
    for axes, scene in zip(panels[0], scenes):
        for shift, (tree, colour) in enumerate(zip(TREES, ("#b3412e", "#d99a1c", "#2f6db3"))):
            points = []
            for test in values(pick(rows, scene=scene), "test"):
                pair = [one(rows, scene=scene, test=test, tree=tree, mode=mode)
                        for mode in ("shared", "thesis")]
                found = ratio(*pair) if all(pair) else None
                if found is not None:
                    points.append((test + 0.08 * (shift - 1), found.value, *interval(found)))
            if not points:
                continue
            at, middle, low, high = zip(*points)
            errors = [[max(0, m - l) for m, l in zip(middle, low)],
                      [max(0, h - m) for m, h in zip(middle, high)]]
            axes.errorbar(at, middle, yerr=errors, marker="o", color=colour, label=tree, capsize=2,
                          markersize=4)
        axes.axhline(1, color="black", linewidth=0.8)
        axes.set_title(f"scene {scene}")
        axes.set_xlabel("test")
        axes.set_xticks(values(pick(rows, scene=scene), "test"))
        axes.grid(alpha=0.25)
    panels[0][0].set_ylabel("net cost: shared / thesis")
    panels[0][0].legend()
    save(figure, path)


def draw_creases(creases, path):
    """creases: rows of crease_profile."""
    figure, panels = pyplot.subplots(1, 3, figsize=(12, 3.6))
    for axes, crease in zip(panels, ("edge", "corner")):
        rows = pick(creases, crease=crease)
        at = [float(row["distance"]) for row in rows]
        for name, label, colour in (("shared clipped", "shared maps, ours", "#3a8f4b"),
                                    ("shared thesis", "shared maps, k / disc", "#2f6db3"),
                                    ("global thesis", "one map, k / disc", "#b3412e")):
            axes.plot(at, [float(row[name]) for row in rows], label=label, color=colour)
        axes.axhline(1, color="black", linewidth=0.8, linestyle=":")
        axes.set_ylim(0, 1.3)
        axes.set_title(f"even light near {'an edge' if crease == 'edge' else 'a corner'}")
    rows = pick(creases, crease="edge")
    at = [float(row["distance"]) for row in rows]
    panels[2].plot(at, [float(row["dark global"]) for row in rows], label="one map",
                   color="#b3412e")
    panels[2].plot(at, [float(row["dark shared"]) for row in rows], label="shared maps",
                   color="#2f6db3")
    panels[2].set_title("dark floor beside a lit wall")
    for axes in panels:
        axes.set_xlabel("distance, in radii of k photons")
        axes.set_ylabel("irradiance (true: 0)" if axes is panels[2] else "irradiance (true: 1)")
        axes.grid(alpha=0.25)
        axes.legend(fontsize=8)
    save(figure, path)


def draw_all(results, folder):
    """{name: file name}; empty where matplotlib is not installed."""
    if pyplot is None:
        return {}
    rows, drawn = usual(results["rows"]), {}
    for scene in values(rows, "scene"):
        if scene == CELLS:
            continue  # one test
        drawn[f"net_{scene}"] = f"net_query_cost_scene_{scene}.png"
        draw_net(pick(rows, scene=scene), folder / drawn[f"net_{scene}"])
    if drawn:
        drawn["local_tier"] = "local_tier.png"
        draw_local_tier(rows, folder / drawn["local_tier"])
    if not results["creases"]:
        return drawn
    drawn["creases"] = "creases.png"
    draw_creases(results["creases"], folder / drawn["creases"])
    return drawn
