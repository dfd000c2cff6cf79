"""Judges what was measured of a room, and writes it as lines and as a Markdown page."""

import math

import report  # of experiments/agreement, whose folder measure has put on the path

CHANCE = 0.0005  # of a room that is called wrong though it is right, by each judgement
AGREE, WITHIN, VAGUE, REFUSED = ("agree", "within the bias", "no reference", "refused")
DIFFER, BLACK, NOT_REFUSED, ENDLESS = ("**differ**", "**black**", "**refused**", "**not finite**")
WRONG = (DIFFER, BLACK, NOT_REFUSED, ENDLESS)
# Images that state more cannot be compared: there is light that is hardly ever found.
MOST_ERROR = 0.3


def error_stated(case):
    """Of both images, added in squares."""
    return math.hypot(*(case["stated"][name][0] for name in ("progressive", "path")))


def bias_stated(case):
    return math.hypot(*(case["stated"][name][1] for name in ("progressive", "path")))


def worst_region(case):
    return max(case["regions"], key=lambda found: report.excess(found, bias_stated(case)))


def is_off(case, bias):
    """Whether the mean or a region differs by more than the bias and chance explain."""
    freedom = 2 * (case["seeds"] - 1)
    limit = report.student_limit(CHANCE, freedom)
    regional = report.student_limit(CHANCE / max(1, len(case["regions"])), freedom)
    return (report.excess(case["ratio"], bias) > limit or
            any(report.excess(found, bias) > regional for found in case["regions"]))


def verdict(case):
    if "refused" in case:
        return REFUSED if "refused" in case["expect"] else NOT_REFUSED
    if "ratio" not in case:
        return ENDLESS
    if case["ratio"] is None or case["means"]["progressive"] == 0:
        right = "black" in case["expect"] and case["ratio"] is None and case["means"]["progressive"] == 0
        return AGREE if right else BLACK
    if not is_off(case, 0):
        return AGREE
    if not is_off(case, bias_stated(case)):
        return WITHIN
    return VAGUE if error_stated(case) > MOST_ERROR else DIFFER


def percent(value):
    return f"{100 * value:.2g} %" if value < 0.1 else f"{100 * value:.0f} %"


def cells(name, case):
    """Texts of a row."""
    if "refused" in case:
        return [name, "", "", "", "", "", "", verdict(case)]
    if case.get("ratio") is None:
        return [name, "0/0" if "ratio" in case else "nan", "", "", "", "", "", verdict(case)]
    value, error = case["ratio"]
    worst = worst_region(case) if case["regions"] else case["ratio"]
    z = f"{(value - 1) / error:+.1f}" if error else "-"
    return [name, f"{value:.4f} ± {error:.4f}", z, f"{worst[0]:.3f} ± {worst[1]:.3f}",
            f"{case['direct'][0]:.3f}", percent(error_stated(case)), percent(bias_stated(case)),
            verdict(case)]


HEADERS = ("room", "progressive/path", "z", "region most off", "direct/path", "error stated",
           "bias stated", "verdict")
WIDTHS = (30, 18, 7, 15, 11, 12, 11, 8)


def line(name, case):
    text = "  ".join(cell.ljust(width) for cell, width in zip(cells(name, case), WIDTHS))
    return text + (f"  {case['refused']}" if "refused" in case else "")


def header():
    return "  ".join(cell.ljust(width) for cell, width in zip(HEADERS, WIDTHS))


def table(found):
    rows = [HEADERS + ("what is nasty",), ("---",) * (len(HEADERS) + 1)]
    rows += [(*cells(name, case), doc) for name, doc, case in found]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows) + "\n"


def refusals(found):
    lines = [f"* {name}: `{case['refused']}`\n" for name, _, case in found if "refused" in case]
    return "## Refused\n\n" + "".join(lines) if lines else ""


def page(found, date, minutes, options):
    verdicts = [verdict(case) for _, _, case in found]
    counts = ", ".join(f"{verdicts.count(kind)} {kind}" for kind in dict.fromkeys(verdicts))
    return f"""# Sweep: do the integrators agree where scenes are nasty?

Written by `experiments/sweep/sweep.py`; do not edit. Run on {date}, in {minutes:.0f} minutes.

Each room is the same closed diffuse room with one area light and one difficulty. `progressive` and `path` render it
({options.size}x{options.size} pixels, {options.seeds} seeds of each). They share the scene, the materials and the lights, but not the transport of
light. `direct` is shown for comparison.

* **progressive/path**: the ratio of the images' mean radiances, with its standard error from the seeds. **z**: its
  distance from 1 in standard errors.
* **Region most off**: the ratio in the worst of 16 parts of the image and its channels (parts darker than a tenth of the
  mean are left out).
* **Error stated, bias stated**: the estimated errors of both images ([error.md](error.md)), and the part of them that is
  bias, each added in squares.
* **Verdict**: `agree` if chance alone explains the mean and the regions (Student's distribution exceeds the limit once
  in {1 / CHANCE:.0f} rooms). `within the bias` if chance and the stated bias explain them. `no reference` if they do not, but
  the images state errors above {percent(MOST_ERROR)}; such a room is rendered again with wide lights (`_wide`), if
  they can be widened. `refused` if an error names what hipmap cannot render.

{len(found)} rooms: {counts}.

{table(found)}
{refusals(found)}""".rstrip() + "\n"
