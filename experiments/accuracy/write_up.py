"""Writes docs/accuracy.md from the results."""

import math
import sys

import arithmetic
import findings
import plan

sys.path.append(str(plan.ROOT / "experiments"))
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
    return f"""# Accuracy: error against time

Written by `experiments/accuracy/measure_accuracy.py`; do not edit. Run on {results["date"]};
{about["machine"]}; measured in {results["seconds"] / 60 / int(cores):.1f} minutes of all
cores. Every figure is from that run and in [results.json](accuracy/results.json).

Errors are true ones: the root of relMSE ([error.md](error.md) (3)) against long references
([below](#references)), not what `render` states of itself. Times are the processor's seconds of the whole program, user
and system, from its start to the image; each program ran on one thread, one on each core. Images are
{study["size"]} pixels wide, means are over {study["seeds"]} seeds (of errors: of their squares), bars are standard errors. All
scenes are rendered with `--diffuse lambert`. A name says how a setting differs from `render`'s defaults, but that all
have {plan.PHOTONS:,} photons in a pass unless they say otherwise: to such an image these are what the default of
{plan.DEFAULT_PHOTONS:,} is to one twice as wide.
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
    parts = ["## What to choose\n", "The setting that meets an error first, and when:\n",
             table(["error", *(scene.name for scene in scenes)], lines)]
    if advice:
        parts += ["""For a scene of which nothing is known, the setting that loses least to the quickest where it loses most,
of those that meet the error wherever any does:
""", table(["error", "setting", "times the quickest, at most", "processor s, by scene"], advice)]
    return "\n".join(parts)


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

By interpolation on the curves, in logarithms; in brackets the ratio to the path tracer's time. Where paths do not
meet the error in the time measured, the ratio is below that to this time. The mark, for `{plan.BASE}`: faster
on scenes with caustics, and nowhere else more than {findings.MOST_SLOWER} times slower. `{AT_ONCE}`: `{plan.BASE}` is better than
that after its first pass, whose seconds these are, so there is no equal error to compare at.

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

relMSE after {plan.MINUTE} processor seconds, {width} pixels wide, by `render`'s default of {plan.DEFAULT_PHOTONS:,} photons where
nothing else is said, from images that took about as long, by the slope between half the time and all of it (seeds:
{results["about"]["study"]["minute_seeds"]}). Passes of Cycles (Blender's path tracer, where `blender` is installed) are samples of a pixel; its time is
that of rendering alone, on one thread too. `box`: by the box filter, against references by it, since Cycles has no B-spline.

The marks come from what other renderers reach on scenes of these kinds, measured with c = {plan.MARKS_CONSTANT} in (3) of
[error.md](error.md). Here c is the square of a tenth of the image's mean, which is less in each of
these scenes, so that what is dark counts for more. Both are told.{note}

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
            lines.append([scene.name, percent(quote["error"]), f"{quote['promised_passes']:.0f}",
                          f"{quote['passes']}{'' if quote['met'] else ', given up'}",
                          f"{quote['passes'] / quote['promised_passes']:.2f}",
                          seconds(quote["promised_seconds"]), seconds(quote["seconds"]),
                          percent(quote["stated"]), percent(true) if true else UNKNOWN,
                          f"{true / quote['error']:.2f}" if true else "-", verdict(held[-1])])
    return f"""## Quotes: what was promised, and what then happened

`--quote --error E` by eight passes, then a render with `--error E` by the same setting (`{plan.BASE}`) and seed. A
render ends only at passes that are √2 apart. The mark: passes and true error within a factor of {findings.WITHIN}
of what was promised. Held by {sum(held)} of {len(held)}.

""" + table(["scene", "E", "passes promised", "taken", "ratio", "seconds promised", "taken",
             "error stated", "true error", "true / E", "mark"], lines)


def all_settings(results, drawn):
    parts = ["## All settings\n", """The longest image of each, and the seconds to an error. Modes `shared` and `hierarchical` find
the same photons; `thesis` differs from them only with `direct`.
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

Each has two halves by seeds of their own, {2 * study["size"]} pixels wide: of four by four pixels, by 1, 3, 3 and 1 along
each axis, comes one of the images half as wide, since that is what such a B-spline is made of. Images `by the box` have references by it. An error's square is the mean of the products of what the image differs from the one half and from the
other, so that the noise of the references averages out. Their bias does not: where the reference is by
`{plan.BASE}` itself, errors of `{plan.BASE}` are told too small by what bias they share. The path tracer shares
none: were the reference wrong, its error would cease to fall.

""" + table(["scene", "by", "passes", "processor s", f"noise at {study['size']}",
             f"at {2 * study['size']}", "why"], lines)


def write(results, drawn):
    """The document.  drawn: {name: address of a plot}."""
    parts = [introduction(results)]
    if "frontier" in drawn:
        parts.append(f"![Error against processor seconds, by scene]({drawn['frontier']})\n")
    parts += [choose(results), against_path(results), minute(results), quotes(results),
              all_settings(results, drawn), references(results)]
    return "\n".join(parts)
