"""Renders images and references, and measures what they took and how far off they are."""

import dataclasses
import functools
import json
import math
import pathlib
import sys
import tempfile

import arithmetic
import plan

sys.path.append(str(plan.ROOT / "experiments"))
import programs
import promises

SPACING = 3  # passes from point to point of a curve, times


def schedule(start, each, seconds, spacing=SPACING):
    """Passes at which a curve has its points: from 1 to as many as take so many seconds, evenly spaced in
    logarithms.  start: seconds before the first pass.  Every point takes them again, so there are only as
    many points between as these repeated starts take no more than `seconds` in all.  each: seconds of a
    pass."""
    last = max(1, int(seconds / each))
    steps = max(1, min(round(math.log(last) / math.log(spacing)), int(seconds / start)))
    return sorted({round(last ** (i / steps)) for i in range(steps + 1)})


@dataclasses.dataclass(frozen=True)
class Lab:
    """tools: folder of the programs.  folder: for partitions and references."""

    tools: pathlib.Path
    folder: pathlib.Path
    study: plan.Study

    def partition(self, scene):
        return self.folder / f"{scene.name}.hpm"

    def make_partition(self, scene):
        programs.run(self.tools, "preprocess", scene.path, "-o", self.partition(scene))

    def half(self, scene, by_filter, number):
        return self.folder / f"{scene.name}_{by_filter}_{number}.pfm"

    def render(self, scene, setting, size, *options):
        """The processor's seconds that it took."""
        return programs.run(self.tools, "render", scene.path, self.partition(scene), "--size", size,
                            *setting.arguments(self.study), *options).seconds

    def probe(self, scene, setting, size):
        """Seconds before the first pass, and of one."""
        with tempfile.TemporaryDirectory() as folder:
            image, state = pathlib.Path(folder, "image.pfm"), pathlib.Path(folder, "state")
            options = ("-o", image, "--state", state, "--passes", 1)
            first = self.render(scene, setting, size, *options)
            # Again: it finds nothing to do.
            start = self.render(scene, setting, size, *options)
        return {"start": start, "pass": max(first - start, 0.02 * first)}

    def make_half(self, scene, by_filter, number, probed):
        """One half of a reference."""
        setting = plan.reference_of(scene, by_filter).setting
        passes = max(1, int((setting.seconds * self.study.share - probed["start"]) /
                            probed["pass"]))
        seconds = self.render(scene, setting, self.study.reference_size, "-o",
                              self.half(scene, by_filter, number), "--passes", passes, "--seed",
                              plan.REFERENCE_SEED + number, "--fireflies", "keep")
        return {"passes": passes, "seconds": seconds}

    @functools.lru_cache
    def halves(self, scene, by_filter, size):
        """Of the reference, at this size; at the smaller one by the B-spline alone."""
        found = [arithmetic.read_pfm(self.half(scene, by_filter, number)) for number in (0, 1)]
        return [arithmetic.halved(half) for half in found] if size == self.study.size else found

    def errors2(self, scene, setting, size, image):
        """[relMSE, that with plan.MARKS_CONSTANT]"""
        read, halves = arithmetic.read_pfm(image), self.halves(scene, setting.filter, size)
        return [arithmetic.relative_mse(read, halves, constant)
                for constant in (None, plan.MARKS_CONSTANT)]

    def noise2(self, scene):
        return {str(size): arithmetic.noise_of(self.halves(scene, plan.FILTER, size))
                for size in (self.study.size, self.study.reference_size)}

    def run(self, scene, setting, size, seed, passes, start):
        """[[passes, seconds, *errors2]]: one image at these passes.  Seconds are those of a render
        that does them all at once.  start: those before its first pass, which going on takes again."""
        points, spent = [], start
        with tempfile.TemporaryDirectory() as folder:
            image, state = pathlib.Path(folder, "image.pfm"), pathlib.Path(folder, "state")
            for count in passes:
                spent += self.render(scene, setting, size, "-o", image, "--state", state,
                                     "--passes", count, "--seed", seed) - start
                points.append([count, spent, *self.errors2(scene, setting, size, image)])
        return points

    def keep_promise(self, scene, setting, error, seed):
        """What `--quote` promises of an error, and what then happens.  Seconds: the clock's, of
        pilots and all passes."""
        with tempfile.TemporaryDirectory() as folder:
            image, file = pathlib.Path(folder, "image.pfm"), pathlib.Path(folder, "stats.json")
            options = ("--error", 100 * error, "--stats", file, "--seed", seed)
            self.render(scene, setting, self.study.size, "--quote", *options)
            prices = json.loads(file.read_text())["error"]["prices"]
            price = min(prices, key=lambda price: abs(price["error"] - error))
            passes = promises.promised(price, "passes")
            self.render(scene, setting, self.study.size, "-o", image, "--passes",
                        max(8, math.ceil(promises.PATIENCE * passes[1])), *options)
            stats = json.loads(file.read_text())
            check = stats["error"]["checks"][-1]
            return {"error": error, "promised_passes": passes,
                    "promised_seconds": promises.promised(price, "seconds"), "passes": check["passes"],
                    "seconds": stats["error"]["seconds_before"] + check["seconds"],
                    "stated": check["error"],
                    "met": stats["ended_by"] == "error",
                    "error2": self.errors2(scene, setting, self.study.size, image)[0]}
