"""Plots of error against time; none where matplotlib is not installed."""

import math
import sys

import findings
import plan

sys.path.append(str(plan.ROOT / "experiments"))
try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    import error_axes
except ImportError:
    pyplot = None

STYLES = {
    plan.BASE: ("#3a8f4b", "D-"), plan.DEFAULT: ("#2f6db3", "s-"), plan.PATH: ("#b3412e", "o-"),
    "direct": ("#d99a1c", "^-"), "progressive, 12,500 photons": ("#7b5aa6", "v-"),
    "progressive, k = 20": ("#8a8a1c", "<--"), "progressive, k = 125": ("#1c8a8a", ">--"),
    "progressive, 2 samples": ("#444444", "1--"), "progressive, 8 samples": ("#b3412e", "2--"),
    "progressive, global": ("#b3412e", "o:"), "progressive, shared": ("#d99a1c", "^:"),
    "direct, 200,000 photons": ("#2f6db3", "s--"), "direct, k = 200": ("#7b5aa6", "v--"),
    "direct, global": ("#b3412e", "o:"), "direct, thesis": ("#444444", "x:"),
}
PLOTS = {
    "frontier": (plan.BASE, plan.DEFAULT, "direct", plan.PATH),
    "progressive": [name for name in plan.SETTINGS if name.startswith("progressive")],
    "direct": [name for name in plan.SETTINGS if name.startswith("direct")],
}


def draw_scene(axes, found, names):
    for name in names:
        if name in found:
            error_axes.draw_curve(axes, [point[:3] for point in found[name]], STYLES[name], name)
    error_axes.scale_axes(axes)


def draw(results, names, path):
    """A panel for each scene."""
    scenes = findings.scenes(results)
    across = min(2, len(scenes))
    down = math.ceil(len(scenes) / across)
    figure, panels = pyplot.subplots(down, across, squeeze=False,
                                     figsize=(5.2 * across, 3.6 * down))
    for axes in panels.flat[len(scenes):]:
        axes.set_visible(False)
    for axes, scene in zip(panels.flat, scenes):
        draw_scene(axes, findings.curves(results, scene), names)
        axes.set_title(scene.name)
        axes.set_xlabel("processor seconds")
        axes.set_ylabel("error, %")
    panels[0][0].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    pyplot.close(figure)


def draw_all(results, folder):
    """{name: address from the document}; empty where matplotlib is not installed."""
    if pyplot is None:
        return {}
    for name, names in PLOTS.items():
        draw(results, names, folder / f"{name}.png")
    return {name: f"accuracy/{name}.png" for name in PLOTS}
