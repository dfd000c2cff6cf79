"""Judges what the runs found, and writes docs/agreement.md."""

import math
import statistics

import runs
from student import student_limit

AGREE = "agree"
CHANCE = 0.001  # of a scene that is called wrong though it is right, by each judgement


def ratio(a, a_error, b, b_error):
    """Of two means, and its standard error; nothing where the other is black."""
    return (a / b, math.hypot(a_error, a / b * b_error) / b) if b else None


def excess(found, bias):
    """Standard errors by which a ratio is off by more than the bias that is stated."""
    value, error = found
    beyond = max(0.0, abs(value - 1) - bias)
    return beyond / error if error else (math.inf if beyond else 0.0)


def channels(case):
    """(ratio, its standard error) of the means of the channels."""
    return [ratio(*both) for both in case["channels"]]


def worst_region(case):
    """(ratio, its standard error) of the region and channel that is off most; dark ones, below a
    tenth of the mean, are left out."""
    floor = 0.1 * statistics.mean(mean for _, _, mean, _ in case["channels"])
    found = [ratio(*both) for both in case["regions"] if both[2] > floor]
    return max(found, key=lambda region: excess(region, case["bias"])), len(found)


def judge(case):
    """Whether means, regions and difference are within what is stated, each with a chance of
    CHANCE to be called wrong if it is right.  What differs by less is within."""
    freedom = 2 * (len(case["difference2"]) - 1)
    means = all(excess(found, case["bias"]) < student_limit(CHANCE / 3, freedom)
                for found in channels(case) if found)
    region, regions = worst_region(case)
    off = [d - s for d, s in zip(case["difference2"], case["stated2"])]
    mean, error = runs.mean_and_error(off)
    return {"means": means,
            "regions": excess(region, case["bias"]) < student_limit(CHANCE / regions, freedom),
            "difference": mean < error * student_limit(2 * CHANCE, freedom / 2)}


def verdict_on(case):
    wrong = [name for name, right in judge(case).items() if not right]
    if wrong:
        return f"**{', '.join(wrong)} off**"
    return AGREE if all(judge({**case, "bias": 0}).values()) else "within the bias"


def percent(value, digits=2):
    return f"{100 * value:.{digits}f} %"


def shown(found):
    return f"{found[0]:.4f} ± {found[1]:.4f}" if found else "black"


def z(found):
    return f"{(found[0] - 1) / found[1]:+.1f}" if found and found[1] else "-"


def row(case):
    found = channels(case)
    difference = math.sqrt(statistics.mean(case["difference2"]))
    stated = math.sqrt(statistics.mean(case["stated2"]))
    if case["method"] == "direct":
        verdict = "not judged"
    else:
        verdict = verdict_on(case)
    left_out = f" without {case['effects'][1:]}" if "effects" in case else ""
    return [case["scene"] + left_out, case["method"], case["other"],
            ", ".join(map(str, case["passes"])), *map(shown, found), ", ".join(map(z, found)),
            shown(worst_region(case)[0]), percent(difference), percent(stated),
            percent(case["bias"]), verdict]


def table(cases):
    headers = ["scene", "A", "B", "passes", "red A/B", "green A/B", "blue A/B", "z",
               "region most off", "difference", "stated", "bias stated", "verdict"]
    lines = [headers, ["---"] * len(headers), *map(row, cases)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def reasons(cases):
    return "".join(f"* {case['scene']}: {case['why']}.\n" for case in cases if "why" in case)


def write(results):
    cases = results["comparisons"]
    judged = [case for case in cases if case["method"] != "direct"]
    verdicts = list(map(verdict_on, judged))
    right = verdicts.count(AGREE)
    within = sum(verdict.startswith("within") for verdict in verdicts)
    void = reasons(cases)
    return f"""# Agreement: do the integrators make the same image?

Written by `experiments/agreement/agree.py`; do not edit. Run on {results["date"]}, in
{results["minutes"]:.1f} minutes.

Photon maps and path tracing render each bundled scene. They share the scene, the materials and the lights, but not the
transport of light ({results["size"]}x{results["size"]} pixels, {results["seeds"]} seeds of each). Passes are those of one image.

* **A/B**: the ratio of the images' means by channel, with its standard error from the seeds. z: its distance from 1 in
  standard errors.
* **Region most off**: the ratio in the worst of 16 parts of the image and its channels (parts darker than a tenth of the
  mean are left out).
* **Difference**: the root of the mean square of A - B over that of the truth, like an error ([error.md](error.md) (3)).
  **Stated**: the difference that the estimated errors of both images predict, added in squares. **Bias stated**: the
  part of it that is bias.
* **Verdict**: `agree` if chance alone explains the means, the regions and a difference above the stated one (Student's
  distribution exceeds the limit once in {1 / CHANCE:.0f} scenes). `within the bias` if chance and the stated bias, which shrinks with every
  pass, explain the means and regions. `direct` states no bias and is not judged.

{right} of {len(judged)} agree, {within} more are within the bias.

{table(cases)}
{"## Where paths are no reference" if void else ""}

{void}{'''
In these scenes `progressive` is compared with itself, with three times the photons and 16 neighbours, which is a tenth
of the area. That finds errors that depend on the radius, but not errors that both share. Without caustics it is
compared with path tracing.
''' if void else ""}""".rstrip() + "\n"
