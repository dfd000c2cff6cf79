"""Renders by Blender's Cycles, in as much time as hipmap is given."""

import pathlib
import shutil
import sys
import tempfile

import plan

sys.path.append(str(plan.ROOT / "bench"))
import in_blender  # noqa: E402

SCRIPT = pathlib.Path(__file__).resolve().parent / "cycles_image.py"
FEW_SAMPLES = 16
SEED = 1


def is_there(study):
    """Never for a quick look: Blender takes seconds to start."""
    return study.divide == 1 and shutil.which("blender") is not None


def render(scene, image, samples, size):
    """The processor's seconds that rendering took."""
    return in_blender.processor_seconds(SCRIPT, scene.script,
                                        [scene.script, image, samples, size, SEED], image.parent)


def run(lab, scene, size, seconds):
    """[[samples, seconds, *errors2]]: at half the time and at all of it."""
    points = []
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder, "image.pfm")
        few = render(scene, image, FEW_SAMPLES, size)
        several = render(scene, image, 4 * FEW_SAMPLES, size)
        each = max((several - few) / (3 * FEW_SAMPLES), 0.02 * few)
        last = max(2, round((seconds - few) / each))
        for samples in (last // 2, last):
            spent = render(scene, image, samples, size)
            points.append([samples, spent, *lab.errors2(scene, plan.CYCLES, size, image)])
    return points
