"""Writes docs/calibration.md from the results."""

import math
import statistics

STATED = 0.95
LEAST_CHANCE = 0.01
POOLED = (0.92, 0.98)


def chance(inside, images, stated=STATED):
    """Of a count no likelier than this one, if each image is inside with chance `stated`."""
    def probability(count):
        return (math.comb(images, count) * stated ** count *
                (1 - stated) ** (images - count))
    found = probability(inside) * (1 + 1e-9)
    return min(1.0, sum(p for p in map(probability, range(images + 1)) if p <= found))


def is_inside(image):
    return image["low"] <= image["true"] <= image["high"]


def percent(share, digits=1):
    return f"{100 * share:.{digits}f} %"


def case_row(case):
    images = case["images"]
    inside = sum(map(is_inside, images))
    above = sum(image["true"] > image["high"] for image in images)
    found = chance(inside, len(images))
    error = statistics.mean(image["error"] for image in images)
    width = statistics.median((image["high"] - image["low"]) / image["error"] for image in images)
    truth = math.sqrt(statistics.mean(image["true"] ** 2 for image in images))
    passes = statistics.mean(image["passes"] for image in images)
    verdict = "right" if found >= LEAST_CHANCE else "**not right**"
    return [case["scene"], case["integrator"], f"{case['target']:g} %", f"{passes:.0f}",
            case["reference"], percent(case["reference_error"], 2), percent(error),
            percent(truth), percent(width, 0), f"{inside} of {len(images)}",
            f"{len(images) - inside - above}, {above}", f"{found:.2g}", verdict]


def table(cases):
    headers = ["scene", "integrator", "target", "passes", "reference", "its error", "error stated",
               "true error", "width of the interval", "inside", "below, above", "chance",
               "verdict"]
    lines = [headers, ["---"] * len(headers), *map(case_row, cases)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def pooled(cases):
    """A line for all images, and for those of each integrator."""
    lines = []
    names = dict.fromkeys(case["integrator"] for case in cases)
    for name in ["", *names]:
        images = [image for case in cases if name in ("", case["integrator"])
                  for image in case["images"]]
        inside = sum(map(is_inside, images))
        share = inside / len(images)
        verdict = "right" if POOLED[0] <= share <= POOLED[1] else "**not right**"
        lines.append(f"* {name or 'All images'}: {inside} of {len(images)}, {percent(share)}: "
                     f"{verdict}.\n")
    return "".join(lines)


def write(results):
    low, high = (percent(share, 0) for share in POOLED)
    return f"""# Calibration: does the interval hold the error?

Written by `experiments/calibration/calibrate.py`; do not edit. Run on {results["date"]}.

Each image is rendered with `--error` ({results["size"]} pixels wide, each with its own seed): `render` stops when its estimated
error reaches the target, and states a {percent(STATED, 0)} confidence interval for the error ([error.md](error.md)). This page
counts how often the interval holds the true error.

The true error is measured against a reference whose own estimated error is at most a fifth of the target, without the
reference's noise. The reference depends on the integrator:

* `path`, and `progressive` where path tracing finds all light: a long `path`.
* `progressive` where path tracing cannot find some lights (those without size behind glass or in mirrors), or hardly
  finds the light (`glass_globe`, which is left out for `path`): `progressive` with 30 times the photons and 4
  neighbours. Its radii are less than a tenth as wide, because a bias that both share would not show.
* `direct`: its own mean over 16 seeds, because it states noise alone, and the mean depends on what the pilots of a seed choose. Its images take 8 samples per pixel in each pass: `hexagonal`
  has a bright line narrower than a hundredth of two pixels, and an estimate includes light that no sample has found only where
  pilots know of it.

Scenes are left out for an integrator where rare samples are so bright that a good enough reference takes more than a
quarter of an hour: `carafe`, where glass and water show a small bright lamp (four images of 1,000 passes by `direct` state errors of 17 % to
47 %, and differ by 22 % to 126 %), the furnished scenes for `path`, the museum also for `direct`.

A row is `right` if its count is not too unlikely: where each image is inside with {percent(STATED, 0)}, counts as unlikely as this one
have a chance of {percent(LEAST_CHANCE, 0)} or more. All images together are right if {low} to {high} of them are inside. `below, above`
counts true errors below and above the interval. Errors are means over the images; the true one is a mean of squares.

{pooled(results["cases"])}
{table(results["cases"])}"""
