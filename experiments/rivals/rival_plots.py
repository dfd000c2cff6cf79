"""Plots of error against time and the images; none where matplotlib is not installed."""

import sys

import rival_findings as findings
import rival_plan as plan

sys.path.extend((str(plan.ROOT / "experiments"), str(plan.ROOT / "experiments/accuracy")))
import arithmetic

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    import error_axes
    import numpy
except ImportError:
    pyplot = None

STYLES = {
    plan.DIRECT: ("#d99a1c", "^-"), plan.OF_ITS_TIME: ("#d99a1c", "^:"),
    plan.PROGRESSIVE: ("#3a8f4b", "D-"), plan.PATH: ("#b3412e", "o-"),
    plan.RADIOSITY: ("#7b5aa6", "v--"), plan.MAP: ("#2f6db3", "s--"), plan.CACHE: ("#1c8a8a", ">--"),
    plan.BOTH_WAYS: ("#444444", "x--"), plan.FIELD: ("#8a8a1c", "<--"),
}
SHOWN = (plan.PROGRESSIVE, plan.PATH, *plan.RIVALS)


def draw_scene(results, scene, axes):
    for name, style in STYLES.items():
        points = findings.curve(results, scene, name, plan.WHOLE)
        if points:
            error_axes.draw_curve(axes, points, style, name)
    error_axes.scale_axes(axes)
    axes.set_title(scene.name)
    axes.set_xlabel("processor seconds")
    axes.set_ylabel("error of the whole image, %")


def draw_curves(results, path):
    """A panel for each scene."""
    scenes = findings.scenes(results)
    figure, panels = pyplot.subplots(2, 2, figsize=(11, 7.6), squeeze=False)
    for axes in panels.flat[len(scenes):]:
        axes.set_visible(False)
    for axes, scene in zip(panels.flat, scenes):
        draw_scene(results, scene, axes)
    panels[0][0].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path, dpi=85)
    pyplot.close(figure)


def display(image, white):
    """sRGB of a PFM image."""
    width, numbers = image
    linear = numpy.clip(numpy.array(numbers).reshape(-1, width, 3)[::-1] / white, 0, 1)
    return numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def draw_images(results, lab, path):
    """A row for each scene: the reference and the methods, by their last setting."""
    scenes = findings.scenes(results)
    figure, panels = pyplot.subplots(len(scenes), 1 + len(SHOWN), squeeze=False,
                                     figsize=(1.9 * (1 + len(SHOWN)), 1.95 * len(scenes)))
    for first, row, scene in zip([True] + len(scenes) * [False], panels, scenes):
        reference = lab.halves(scene, plan.WHOLE)[0]
        white = 1.5 * float(numpy.percentile(numpy.array(reference[1]), 85))
        named = [("reference", reference)]
        named += [(name, arithmetic.read_pfm(lab.shown(scene, plan.METHODS[name])))
                  for name in SHOWN]
        for axes, (name, image) in zip(row, named):
            axes.imshow(display(image, white))
            axes.set_axis_off()
            if first:
                axes.set_title(name, fontsize=8)
    figure.subplots_adjust(left=0, right=1, bottom=0, top=0.95, wspace=0.03, hspace=0.03)
    figure.savefig(path, dpi=75)
    pyplot.close(figure)


def draw_all(results, lab, folder):
    """Draws what it has the images for; {name: address from the document}."""
    if pyplot is None:
        return {}
    draw_curves(results, folder / "curves.png")
    drawn = {"curves": "rivals/curves.png"}
    if all(lab.shown(scene, plan.METHODS[name]).exists() for scene in findings.scenes(results)
           for name in SHOWN):
        draw_images(results, lab, folder / "images.png")
    if (folder / "images.png").exists():
        drawn["images"] = "rivals/images.png"
    return drawn
