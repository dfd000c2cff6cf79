"""Draws net query cost against photons stored, as Figures 15 to 17 of the dissertation."""

from measure import MODES, SCENES

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    pyplot = None


def draw(rows, path):
    """rows: of one scene."""
    figure, axes = pyplot.subplots(figsize=(6, 4))
    for mode, marker in zip(MODES, "os^D"):
        points = sorted((row["stored"], row["net_s"]) for row in rows if row["mode"] == mode)
        axes.plot(*zip(*points), marker=marker, label=mode)
    axes.set_xlabel("photons stored")
    axes.set_ylabel("net query cost, s")
    axes.set_title(f"Scene {rows[0]['scene']}: {SCENES[rows[0]['scene']]}")
    axes.ticklabel_format(axis="x", style="plain")
    axes.set_ylim(bottom=0)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, dpi=100)
    pyplot.close(figure)


def draw_all(rows, folder):
    """{scene: file name}; empty where matplotlib is not installed."""
    if pyplot is None:
        return {}
    drawn = {}
    for scene in sorted({row["scene"] for row in rows}):
        drawn[scene] = f"experiment_scene_{scene}.png"
        draw([row for row in rows if row["scene"] == scene], folder / drawn[scene])
    return drawn
