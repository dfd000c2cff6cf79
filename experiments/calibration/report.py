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

Every image is rendered with `--error` until it says that its error is at the target ({results["size"]} pixels
wide, each by a seed of its own), and states an interval that is to hold its true error with {percent(STATED, 0)}
([error.md](error.md)). The true error is that against a reference whose own stated error is a fifth of the target
or less; its noise is taken off. Images by `path`, and by `progressive` where paths find all the light, are
compared with a long `path`; where there are lamps without size behind glass or in mirrors, which paths do not
find, or where all light comes through glass (`glass_globe`, which paths hardly ever find and are left out),
`progressive` is compared with itself by 30 times the photons and 4 neighbours: by radii less than a tenth as wide,
since what bias the reference has left would be missing in that of the images. What `direct` states is noise alone:
it is compared with its own mean. Its images have 8 samples of a pixel in each pass: `hexagonal` has a bright line of less than a
hundredth of two pixels, and of what no sample has met no estimate knows.

A line is right if a count as unlikely as the one found has a chance of {percent(LEAST_CHANCE, 0)} or more where each image
is inside with {percent(STATED, 0)}; all together are, if {low} to {high} of the images are inside.
Below, above: true errors below and above the interval. Errors are means over the images, the true one in squares.

{pooled(results["cases"])}
{table(results["cases"])}"""
