"""Writes docs/rivals.md: replaces the text between its markers and keeps all other text."""

import math
import re
import sys

import rival_findings as findings
import rival_plan as plan

sys.path.append(str(plan.ROOT / "experiments"))
from ratios import written
from tables import table

LISTED = (plan.DIRECT, plan.OF_ITS_TIME, plan.PROGRESSIVE, plan.PATH, *plan.RIVALS)


def mean(numbers):
    return sum(numbers) / len(numbers)


def number(value):
    """Two digits."""
    return "-" if value is None else f"{float(f'{value:.2g}'):g}"


def error_after(results, scene, method, seconds):
    """Root of the mean of squares; None: not measured."""
    found = findings.errors_after(results, scene, method, plan.WHOLE, seconds)
    return math.sqrt(mean([error ** 2 for error in found])) if found else None


def error_cell(error, least):
    """least: of the column, which stands out."""
    if error is None:
        return "-"
    text = f"{number(100 * error)} %"
    return f"**{text}**" if error == least else text


def run_part(results, _):
    study = results["about"]["study"]
    noise = [math.sqrt(results["runs"][f"noise/{scene.name}/{plan.WHOLE}"])
             for scene in findings.scenes(results)]
    return (f"Run on {results['date']}; {results['about']['machine']}; images {study['width']} pixels wide, "
            f"{study['seeds']} seeds; {study['photons']:,} light paths in a pass of hipmap; noise of the "
            f"references at most {number(100 * max(noise))} %.\n")


def curves_part(_, drawn):
    return f"![Error against processor seconds, by scene]({drawn['curves']})\n" if "curves" in drawn else ""


def images_part(_, drawn):
    return f"![The reference and each method]({drawn['images']})\n" if "images" in drawn else ""


def errors_part(results, _):
    scenes = findings.scenes(results)
    budgets = [findings.budget(results, scene) for scene in scenes]
    columns = [[error_after(results, scene, method, seconds) for method in LISTED]
               for scene, seconds in zip(scenes, budgets)]
    least = [min(error for error in column if error is not None) for column in columns]
    lines = [[f"`{method}`", *map(error_cell, errors, least)]
             for method, errors in zip(LISTED, zip(*columns))]
    return table(["method", *(f"{scene.name}, {number(seconds)} s"
                              for scene, seconds in zip(scenes, budgets))], lines)


def cannot_part(results, _):
    lines = []
    for name in LISTED:
        method = plan.METHODS[name]
        last = [run for scene in findings.scenes(results)
                for run in findings.images(results, scene, name, method.count() - 1)]
        lines.append([f"`{name}`", method.cannot,
                      number(max(run["stored"] for run in last) / 2 ** 20) if last[0]["stored"] else "-",
                      number(max(run["peak"] for run in last) / 2 ** 20)])
    return table(["method", "leaves out, or blurs", "stored, MiB", "peak of the program, MiB"], lines)


def left_out_part(results, _):
    scenes, lines = findings.scenes(results), []
    for name in (plan.RADIOSITY, plan.CACHE, plan.PATH_EFFECTS):
        cells = []
        for scene in scenes:
            runs = findings.images(results, scene, name, plan.METHODS[name].count() - 1)
            errors = [[findings.error_of(run, kind) for run in runs if kind in run["errors2"]]
                      for kind in (plan.WHOLE, plan.EFFECTS)]
            cells.append(" / ".join(f"{number(100 * mean(one))} %" if one and all(one) else "-"
                                    for one in errors))
        lines.append([f"`{name}`", *cells])
    return table(["method", *(scene.name for scene in scenes)], lines)


def view_part(results, _):
    lines = []
    for name in (plan.RADIOSITY, plan.MAP, plan.FIELD):
        cells = []
        for scene in findings.scenes(results):
            runs = findings.images(results, scene, name, plan.METHODS[name].count() - 1)
            cells.append(" / ".join(number(mean([run[key] for run in runs]))
                                    for key in ("prepared", "rendered")))
        lines.append([f"`{name}`", *cells])
    return table(["method", *(scene.name for scene in findings.scenes(results))], lines)


def claims_part(results, _):
    scenes = findings.scenes(results)
    lines = [[claim.text, claim.source, *(findings.shown(claim, results, scene) for scene in scenes)]
             for claim in findings.CLAIMS]
    sources = "\n".join(f"* *{key}*: {text}." for key, text in findings.SOURCES.items())
    return table(["claim: ratio of errors", "source", *(scene.name for scene in scenes)],
                 lines) + "\n" + sources + "\n"


PARTS = {"run": run_part, "curves": curves_part, "images": images_part, "errors": errors_part,
         "cannot": cannot_part, "left out": left_out_part, "views": view_part, "claims": claims_part}


def write(text, results, drawn):
    """The document with its parts filled in.  text: with markers <!-- NAME --> and <!-- end -->."""
    for name, part in PARTS.items():
        marked = re.compile(rf"(<!-- {name} -->\n).*?(<!-- end -->)", re.DOTALL)
        if len(marked.findall(text)) != 1:
            raise ValueError(f"the document has not one part <!-- {name} --> ... <!-- end -->")
        filled = part(results, drawn)
        text = marked.sub(lambda found, filled=filled: found[1] + filled + found[2], text)
    return text
