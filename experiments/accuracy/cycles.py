"""Renders by Blender's Cycles, in as much time as hipmap is given."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import plan

SCRIPT = pathlib.Path(__file__).resolve().parent / "cycles_image.py"
FEW_SAMPLES = 16
SEED = 1


def is_there(study):
    """Never for a quick look: Blender takes seconds to start."""
    return study.divide == 1 and shutil.which("blender") is not None


def render(scene, image, samples, size):
    """The processor's seconds that rendering took."""
    # Debian's Blender takes the first python3 on the PATH, which must be Debian's too.
    done = subprocess.run(
        ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", str(SCRIPT),
         "--", str(scene.script), str(image), str(samples), str(size), str(SEED)],
        env={"PATH": "/usr/bin:/bin", "HOME": str(image.parent)}, check=False, text=True,
        capture_output=True)
    found = re.search(r"^processor seconds: ([0-9.]+)$", done.stdout, re.MULTILINE)
    if done.returncode != 0 or found is None:
        sys.exit(f"error: blender ended with code {done.returncode}: "
                 f"{(done.stderr.splitlines() or ['no message'])[-1]}")
    return float(found[1])


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
