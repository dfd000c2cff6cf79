"""Writes docs/accuracy.md from the results."""

import math
import sys

import arithmetic
import findings
import plan

sys.path.append(str(plan.ROOT / "experiments"))
import promises
from tables import table

UNKNOWN = "not known"
AT_ONCE = "first pass"


def percent(share):
    return f"{100 * share:.2g} %"


def seconds(value):
    return "-" if value is None else f"{value:.2g}" if value < 10 else f"{value:.0f}"


def verdict(held):
    return UNKNOWN if held is None else "held" if held else "**missed**"


def introduction(results):
    study, about = results["about"]["study"], results["about"]
    cores = about["machine"].rsplit(" ", 2)[-2]
    return f"""# Accuracy: which setting reaches an error first?

Written by `experiments/accuracy/measure_accuracy.py`; do not edit. Run on {results["date"]};
{about["machine"]}; measured in {results["seconds"] / 60 / int(cores):.1f} minutes of all
cores. Every figure is from that run and in [results.json](accuracy/results.json).

* **Errors** are true ones: the root of relMSE ([error.md](error.md) (3)) against long references ([below](#references)).
* **Times** are processor seconds, user and system, of the whole program. Each program ran on one thread, one on each core.
* **Images** are {study["size"]} pixels wide and use `--look gltf`. Means are over {study["seeds"]} seeds (errors: mean of squares); bars are
  standard errors.
* **Names** say how a setting differs from `render`'s defaults. All settings have {plan.PHOTONS:,} photons in a pass unless the
  name says otherwise. For this size that equals the default of {plan.DEFAULT_PHOTONS:,} for an image twice as wide.
"""


def choose(results):
    """What to render with, for an error."""
    names = list(plan.SETTINGS)
    scenes = findings.scenes(results)
    found = {scene.name: findings.curves(results, scene) for scene in scenes}
    lines, advice = [], []
    for error in plan.ERRORS:
        line = [percent(error)]
        for scene in scenes:
            best = findings.quickest(found[scene.name], names, error)
            line.append(f"{best[0]}: {seconds(best[1])} s" if best else "-")
        lines.append(line)
        one = findings.recommended(results, names, error)
        if one:
            each = ", ".join("-" if value is None else seconds(value) for value in one[2])
            advice.append([percent(error), one[0], f"{one[1]:.2g}", each])
    parts = ["## What to choose\n", "The setting that reaches an error first, and when:\n",
             table(["error", *(scene.name for scene in scenes)], lines)]
    if advice:
        parts += ["""For an unknown scene, the setting with the smallest worst-case loss against the quickest setting, of those that reach
the error wherever any does:
""", table(["error", "setting", "times the quickest, at most", "processor s, by scene"], advice)]
    return "\n".join(parts)


def regrets(results):
    """What a user loses who sets nothing."""
    lines, most = [], 1.0
    for scene in findings.scenes(results):
        found = findings.curves(results, scene)
        end = min(findings.measured_to(found, name) for name in plan.GRID)
        line = [scene.name]
        for part in plan.REGRET_PARTS:
            one = findings.regret(found, part * end)
            if one:
                most = max(most, one[0] or math.inf)
            line.append("-" if one is None else
                        f"{part * end:.2g} s: {f'{one[0]:.2f}' if one[0] else UNKNOWN} ({one[1]})")
        lines.append(line)
    return f"""## What the defaults lose

The time that `{plan.BASE}` takes to the least error that any of these settings has after some seconds, over those seconds: 1 if it is
the best itself. Brackets have the best, which chance helps, as it is the best of {len(plan.GRID)}: {", ".join(plan.GRID[1:])}, or
`{plan.BASE}`. The mark: at most {plan.MOST_REGRET}; {verdict(most <= plan.MOST_REGRET)}.

""" + table(["scene", *(f"after {'all' if part == 1 else f'{part:.2g}'} of the time"
                       for part in plan.REGRET_PARTS)], lines)


def ratio_text(against):
    if against is None:
        return "-"
    mine, _, ratio, only_below = against
    return f"{seconds(mine)} ({'< ' if only_below else ''}{ratio:.2g})"


def against_path(results):
    lines, said = [], []
    names = [name for name in plan.SETTINGS if name.endswith("photons") and "progressive" in name]
    for scene in findings.scenes(results):
        found, marks = findings.curves(results, scene), []
        for error in plan.ERRORS:
            against = findings.against_path(found, plan.BASE, error)
            if against is None:
                continue
            if findings.begins_better(found, plan.BASE, error):
                judged = AT_ONCE
            else:
                marks.append(findings.keeps_mark(scene, against[2], against[3]))
                judged = verdict(marks[-1])
            path = (f"> {seconds(findings.measured_to(found, plan.PATH))}" if against[3]
                    else seconds(against[1]))
            lines.append([scene.name, "yes" if scene.caustics else "no", percent(error), path,
                          ratio_text(against),
                          *(ratio_text(findings.against_path(found, name, error))
                            for name in names), judged])
        all_held = (False if False in marks else True if True in marks else None)
        said.append(f"* {scene.name}: {verdict(all_held)}\n")
    return f"""## Progressive against path: seconds to equal error

Times are interpolated on the curves, in logarithms. Brackets have the ratio to the path tracer's time, with `<` where the
path tracer does not reach the error in the measured time. The mark is for `{plan.BASE}`: faster on scenes with
caustics, and at most {findings.MOST_SLOWER} times slower elsewhere. `{AT_ONCE}`: the first pass of `{plan.BASE}` is already better, so there is
no equal error to compare; the seconds are those of that pass.

{"".join(said)}
""" + table(["scene", "caustics", "error", "path, s", f"{plan.BASE}, s", *(f"{name}, s"
             for name in names), "mark"], lines)


def verdict_of(square, scene, share):
    return verdict(square <= scene.mark if square and share == 1 else None)


def minute_line(results, scene, name, setting):
    """None: not measured."""
    share = results["about"]["study"]["share"]
    line, verdicts = None, []
    for column in (2, 3):
        points = findings.curve(results, "minute", scene, setting, column)
        if not points:
            return None
        error = arithmetic.error_after(points, plan.MINUTE * share)
        square = None if error is None else error ** 2
        line = line or [scene.name, name, points[-1][3], seconds(points[-1][0]),
                        f"{scene.mark:.0e}"]
        line.append(UNKNOWN if square is None else f"{square:.2g}")
        verdicts.append(verdict_of(square, scene, share) if name == plan.BASE else "-")
    return [*line[:-1], verdicts[0], line[-1], verdicts[1]]


def minute(results):
    lines, share = [], results["about"]["study"]["share"]
    rivals = {**plan.MINUTE_SETTINGS, plan.CYCLES.name: plan.CYCLES}
    width = 2 * results["about"]["study"]["size"]
    for scene in findings.scenes(results):
        for name, setting in rivals.items() if scene.mark else ():
            line = minute_line(results, scene, name, setting)
            if line:
                lines.append(line)
    note = "" if share == 1 else (
        f"\nThis run was another: the images had {plan.MINUTE * share:.3g} s, of which the marks are not.")
    return f"""## After a minute of two cores

relMSE after {plan.MINUTE} processor seconds, {width} pixels wide, with `render`'s default of {plan.DEFAULT_PHOTONS:,} photons unless the name says
otherwise (seeds: {results["about"]["study"]["minute_seeds"]}). It is extrapolated from an image that took about as long, with the slope between half the
time and all of it. Passes of Cycles (Blender's path tracer, where `blender` is installed) are samples per pixel; its time is that
of rendering alone, on one thread too. `box`: box filter, with references by it, since Cycles has no B-spline.

The marks are what other renderers reach on similar scenes, with c = {plan.MARKS_CONSTANT} in [error.md](error.md) (3). hipmap's c is the square
of a tenth of the image's mean. It is smaller in all of these scenes, so dark pixels count more. The table has both.{note}

""" + table(["scene", "method", "passes", "processor s", "mark", "relMSE", "verdict",
             f"with c = {plan.MARKS_CONSTANT}", "verdict"], lines)


def quotes(results):
    lines, held = [], []
    for scene in findings.scenes(results):
        for number in range(len(plan.QUOTED_PARTS)):
            quote = results["runs"].get(f"quote/{scene.name}/{number}")
            if quote is None:
                continue
            held.append(findings.kept(quote))
            true = math.sqrt(quote["error2"]) if quote["error2"] > 0 else None
            lines.append([scene.name, percent(quote["error"]), promises.written(quote["promised_passes"], ".0f"),
                          f"{quote['passes']}{'' if quote['met'] else ', given up'}",
                          f"{quote['passes'] / quote['promised_passes'][0]:.2f}",
                          " to ".join(dict.fromkeys(map(seconds, quote["promised_seconds"]))),
                          seconds(quote["seconds"]),
                          percent(quote["stated"]), percent(true) if true else UNKNOWN,
                          f"{true / quote['error']:.2f}" if true else "-", verdict(held[-1])])
    return f"""## Quotes: are predicted costs right?

`--quote --error E` predicts the cost from two to eight passes; then `--error E` renders with the same setting (`{plan.BASE}`) and
seed. A render stops only at passes that are a factor of √2 apart. The mark: passes and true error within a factor of
{promises.WITHIN} of the prediction, which is a range where few samples find some of the light ([error.md](error.md) (29)). Held by {sum(held)} of {len(held)}.

""" + table(["scene", "E", "passes promised", "taken", "ratio", "seconds promised", "taken",
             "error stated", "true error", "true / E", "mark"], lines)


def all_settings(results, drawn):
    parts = ["## All settings\n", """The longest image of each setting, and the seconds to an error. Modes `shared` and `hierarchical` find the same photons;
`thesis` differs from them only with `direct`.
"""]
    for name in ("progressive", "direct"):
        if name in drawn:
            parts.append(f"![Settings of {name}]({drawn[name]})\n")
    lines = []
    for scene in findings.scenes(results):
        for name, points in findings.curves(results, scene).items():
            time, error, spread, passes = points[-1]
            lines.append([scene.name, name, passes, seconds(time),
                          f"{100 * error:.2f} ± {100 * spread:.2f} %",
                          *(seconds(arithmetic.seconds_to(points, wanted))
                            for wanted in plan.ERRORS)])
    parts.append(table(["scene", "setting", "passes", "processor s", "error",
                        *(f"s to {percent(error)}" for error in plan.ERRORS)], lines))
    return "\n".join(parts)


def references(results):
    study = results["about"]["study"]
    lines = []
    for scene in findings.scenes(results):
        reference = plan.reference_of(scene)
        done = results["runs"][f"reference/{scene.name}/{plan.FILTER}/0"]["passes"]
        options = " ".join(map(str, reference.setting.arguments(plan.Study(**study))))
        lines.append([scene.name, f"`{options}`", f"2 x {done}",
                      seconds(findings.reference_seconds(results, scene)),
                      *(percent(findings.reference_noise(results, scene, size))
                        for size in (study["size"], 2 * study["size"])), reference.reason])
    return f"""## References

Each reference has two halves with different seeds, {2 * study["size"]} pixels wide. A pixel of the images half as wide is the mean of four by
four of its pixels with weights 1, 3, 3 and 1 along each axis, which is the B-spline at that size. Images with the box filter
have references with the box filter.

The square of an error is the mean product of the differences from the two halves, so that the noise of the references
averages out. Their bias does not: if `{plan.BASE}` made the reference, errors of `{plan.BASE}` are too small by the bias
that they share. The path tracer shares none: with a wrong reference, its error would stop falling.

""" + table(["scene", "by", "passes", "processor s", f"noise at {study['size']}",
             f"at {2 * study['size']}", "why"], lines)


def write(results, drawn):
    """The document.  drawn: {name: address of a plot}."""
    parts = [introduction(results)]
    if "frontier" in drawn:
        parts.append(f"![Error against processor seconds, by scene]({drawn['frontier']})\n")
    parts += [choose(results), regrets(results), against_path(results), minute(results), quotes(results),
              all_settings(results, drawn), references(results)]
    return "\n".join(parts)
