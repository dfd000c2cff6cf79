"""What is to be done, in stages: each needs what the stages before it found."""

import sys

import cycles
import plan
import findings
from lab import schedule

sys.path.append(str(plan.ROOT / "experiments"))
from notebook import Job


def probe(lab, kind, scene, setting, size):
    return Job(f"probe/{kind}/{scene.name}/{setting.name}",
               0.1 * setting.seconds * lab.study.share,
               lambda: lab.probe(scene, setting, size))


def probes(lab, scene):
    """What a pass takes, by each setting."""
    small, large = lab.study.size, lab.study.reference_size
    yield probe(lab, "reference", scene, plan.reference_of(scene).setting, large)
    for setting in plan.SETTINGS.values():
        yield probe(lab, "image", scene, setting, small)
    for setting in plan.MINUTE_SETTINGS.values() if scene.mark else ():
        yield probe(lab, "minute", scene, setting, large)


def references(lab, notebook, scene):
    setting = plan.reference_of(scene).setting
    for by_filter in plan.filters_of(scene):
        for half in (0, 1):
            def make(by_filter=by_filter, half=half):
                return lab.make_half(scene, by_filter, half,
                                     notebook[f"probe/reference/{scene.name}/{setting.name}"])
            yield Job(f"reference/{scene.name}/{by_filter}/{half}",
                      setting.seconds * lab.study.share, make)


def images(lab, notebook, scene, setting):
    """All seeds at the same passes."""
    study, seconds = lab.study, setting.seconds * lab.study.share
    for seed in range(study.seeds):
        def render(seed=seed):
            probed = notebook[f"probe/image/{scene.name}/{setting.name}"]
            passes = schedule(probed["start"], probed["pass"], seconds)
            return lab.run(scene, setting, study.size, seed, passes, probed["start"])
        yield Job(f"image/{scene.name}/{setting.name}/{seed}", seconds, render)


def minutes(lab, notebook, scene, setting):
    """At half the time and at all of it."""
    study, seconds = lab.study, setting.seconds * lab.study.share
    for seed in range(study.minute_seeds):
        def render(seed=seed):
            probed = notebook[f"probe/minute/{scene.name}/{setting.name}"]
            # More than needed: the first pass takes longer than the others.
            last = max(2, round(1.15 * (seconds - probed["start"]) / probed["pass"]))
            return lab.run(scene, setting, study.reference_size, plan.MINUTE_SEED + seed,
                           [last // 2, last], probed["start"])
        yield Job(f"minute/{scene.name}/{setting.name}/{seed}", seconds, render)


def cycles_minute(lab, scene):
    """The same by Blender's Cycles, by one seed."""
    size = lab.study.reference_size
    yield Job(f"minute/{scene.name}/{plan.CYCLES.name}/0", 1.5 * plan.MINUTE * lab.study.share,
              lambda: cycles.run(lab, scene, size, plan.MINUTE * lab.study.share))


def quotes(lab, notebook, scene):
    """Of errors about as small as the smallest of the curve."""
    for number, part in enumerate(plan.QUOTED_PARTS):
        def ask(number=number, part=part):
            curve = findings.curve(notebook.results, "image", scene, plan.SETTINGS[plan.BASE])
            if not curve:
                return None
            error = float(f"{min(1, part * curve[-1][1]):.2g}")
            return lab.keep_promise(scene, plan.SETTINGS[plan.BASE], error,
                                    plan.QUOTE_SEED + number)
        yield Job(f"quote/{scene.name}/{number}", plan.QUOTE_SECONDS * lab.study.share, ask)


def noises(lab, scene):
    yield Job(f"noise/{scene.name}", 0.1, lambda: lab.noise2(scene))


def stages(lab, notebook, scenes):
    """[[Job]]: those of a stage in any order, at the same time."""
    first = [job for scene in scenes for job in probes(lab, scene)]
    second = [job for scene in scenes for job in references(lab, notebook, scene)]
    third = [job for scene in scenes for job in noises(lab, scene)]
    for scene in scenes:
        for setting in plan.MINUTE_SETTINGS.values() if scene.mark else ():
            third += minutes(lab, notebook, scene, setting)
        if scene.mark and cycles.is_there(lab.study):
            third += cycles_minute(lab, scene)
        for setting in plan.SETTINGS.values():
            third += images(lab, notebook, scene, setting)
    return [first, second, third, [job for scene in scenes
                                   for job in quotes(lab, notebook, scene)]]
