"""Renders images and references, and measures time, memory and error."""

import dataclasses
import functools
import json
import pathlib
import sys
import tempfile

import rival_plan as plan

sys.path += [str(plan.ROOT / "experiments"), str(plan.ROOT / "experiments/accuracy")]
import arithmetic
import programs
from notebook import Job

PEAK = plan.ROOT / "experiments/rivals/rival_peak.py"
STAGES = ("pilots", "photons", "maps", "image", "film")  # of render, after loading


@dataclasses.dataclass(frozen=True)
class Lab:
    """tools: folder of the programs.  folder: for partitions, references and the images shown."""

    tools: pathlib.Path
    folder: pathlib.Path
    study: plan.Study

    def partition(self, scene):
        return self.folder / f"{scene.name}.hpm"

    def make_partition(self, scene):
        programs.run(self.tools, "preprocess", scene.path, "-o", self.partition(scene))

    def half(self, scene, kind, number):
        return self.folder / f"{scene.name}_{kind.replace(' ', '_')}_{number}.pfm"

    def shown(self, scene, method):
        """The image of the first seed by the last setting."""
        return self.folder / f"{scene.name}_{method.name.replace(' ', '_')}.pfm"

    def render_words(self, scene, stats):
        return (scene.path, self.partition(scene), "--size", self.study.width, "--stats", stats,
                *plan.OF_RENDER, *plan.COMMON)

    def make_half(self, scene, kind, number):
        """One half of a reference."""
        passes = self.study.passes[plan.KINDS.index(kind)]
        with tempfile.TemporaryDirectory() as folder:
            stats = pathlib.Path(folder, "stats.json")
            done = programs.run(self.tools, "render", *self.render_words(scene, stats), "-o",
                                self.half(scene, kind, number), "--passes", passes, "--seed",
                                plan.REFERENCE_SEED + number, "--photons", self.study.photons,
                                *plan.reference(scene, kind))
            check = json.loads(stats.read_text())["error"]["checks"][-1]
        return {"seconds": done.seconds, "bias2": max(0, check.get("bias2") or 0)}

    @functools.lru_cache
    def halves(self, scene, kind):
        return [arithmetic.read_pfm(self.half(scene, kind, number)) for number in (0, 1)]

    def noise2(self, scene, kind):
        return arithmetic.noise_of(self.halves(scene, kind))

    def spend(self, scene, method, options, folder):
        """What a run took; loading does not count."""
        stats, peak = folder / "stats.json", folder / "peak"
        words = ((scene.path, "--size", self.study.width, *plan.COMMON) if method.program == "rivals"
                 else self.render_words(scene, stats))
        python = pathlib.Path(sys.executable)
        done = programs.run(python.parent, python.name, "-S", PEAK, peak, self.tools / method.program,
                            *words, *options)
        out = {"peak": int(peak.read_text()), "prepared": 0, "stored": 0}
        if method.program == "rivals":
            said = json.loads(done.output)
            return {**out, "prepared": said["prepared_s"], "rendered": said["rendered_s"],
                    "stored": said["stored_bytes"]}
        seconds = json.loads(stats.read_text())["processor_seconds"]
        return {**out, "rendered": sum(seconds[stage] for stage in STAGES)}

    def measure(self, scene, method, point, seed):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            image = folder / "image.pfm"
            options = (*method.arguments(point, self.study), "--seed", seed, "-o", image)
            spent = self.spend(scene, method, options, folder)
            if seed == 0 and point == method.count() - 1:
                self.shown(scene, method).write_bytes(image.read_bytes())
            read = arithmetic.read_pfm(image)
            errors2 = {kind: arithmetic.relative_mse(read, self.halves(scene, kind))
                       for kind in method.against}
        return {**spent, "errors2": errors2}


def stages(lab, scenes):
    """[[Job]]: references, then images."""
    references = [Job(f"reference/{scene.name}/{kind}/{number}", 50,
                      functools.partial(lab.make_half, scene, kind, number))
                  for scene in scenes for kind in plan.KINDS for number in (0, 1)]
    noise = [Job(f"noise/{scene.name}/{kind}", 1, functools.partial(lab.noise2, scene, kind))
             for scene in scenes for kind in plan.KINDS]
    images = [Job(f"image/{scene.name}/{method.name}/{point}/{seed}", 4 ** point,
                  functools.partial(lab.measure, scene, method, point, seed))
              for seed in range(lab.study.seeds) for scene in scenes
              for method in plan.METHODS.values() for point in range(method.count())]
    return [references, noise, images]
