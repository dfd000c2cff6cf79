"""What the results say: curves of error against time, and the claims judged by rule."""

import dataclasses
import math
import sys
import typing

import rival_plan as plan

sys.path.append(str(plan.ROOT / "experiments"))
import claims
from claims import Shown
from ratios import of_rounds, written


def scenes(results):
    return [scene for scene in plan.SCENES.values()
            if f"noise/{scene.name}/{plan.WHOLE}" in results["runs"]]


def images(results, scene, method, point):
    """Of all seeds."""
    begin = f"image/{scene.name}/{method}/{point}/"
    return [run for key, run in sorted(results["runs"].items()) if key.startswith(begin)]


def seconds_of(run):
    return run["prepared"] + run["rendered"]


def error_of(run, kind):
    """Root of relMSE; where the reference's noise hides it, none."""
    error2 = run["errors2"].get(kind)
    return math.sqrt(error2) if error2 is not None and error2 > 0 else None


def curve(results, scene, method, kind):
    """[(seconds, error, its standard error)]: the mean over seeds of squares."""
    out = []
    for point in range(plan.METHODS[method].count()):
        runs = images(results, scene, method, point)
        squares = [run["errors2"][kind] for run in runs if kind in run["errors2"]]
        if not squares or sum(squares) <= 0:
            continue
        mean = sum(squares) / len(squares)
        spread = math.sqrt(sum((square - mean) ** 2 for square in squares) /
                           max(1, len(squares) - 1) / len(squares))
        out.append((sum(map(seconds_of, runs)) / len(runs), math.sqrt(mean),
                    spread / (2 * math.sqrt(mean))))
    return out


def after(points, seconds):
    """Error after so many seconds of a curve of (seconds, error): a line in logarithms between two
    points; before the first point its error, after the last the least of all."""
    if seconds <= points[0][0]:
        return points[0][1]
    for (t0, e0), (t1, e1) in zip(points, points[1:]):
        if seconds <= t1:
            along = math.log(seconds / t0) / math.log(t1 / t0)
            return e0 * (e1 / e0) ** along
    return min(error for _, error in points)


def errors_after(results, scene, method, kind, seconds):
    """By seed."""
    out = []
    for seed in range(results["about"]["study"]["seeds"]):
        points = []
        for point in range(plan.METHODS[method].count()):
            run = results["runs"].get(f"image/{scene.name}/{method}/{point}/{seed}")
            error = error_of(run, kind) if run else None
            if error is not None:
                points.append((seconds_of(run), error))
        if not points:
            return None
        out.append(after(points, seconds))
    return out


def budget(results, scene, kind=plan.WHOLE):
    """Seconds of the last point of progressive, at which methods are compared."""
    return curve(results, scene, plan.PROGRESSIVE, plan.WHOLE)[-1][0]


def against(results, scene, worse, better, kind):
    """Ratio of errors at equal time; None: not measured."""
    seconds = budget(results, scene)
    pair = [errors_after(results, scene, method, kind, seconds) for method in (worse, better)]
    return of_rounds(*pair) if all(pair) else None


def left_out(results, scene, method):
    """Ratio of the error against the whole image to that against one without caustics, by the last
    setting."""
    runs = images(results, scene, method, plan.METHODS[method].count() - 1)
    pair = [[error_of(run, kind) for run in runs] for kind in (plan.WHOLE, plan.EFFECTS)]
    return of_rounds(*pair) if runs and all(pair[0] + pair[1]) else None


@dataclasses.dataclass(frozen=True)
class Claim:
    """source: a key of SOURCES.  find(results, scene): a ratio that exceeds 1 if the claim holds;
    then(results, scene): with a balanced tree of the dissertation's time, if it is about photon
    maps."""

    text: str
    source: str
    find: typing.Callable
    then: typing.Callable = None


DISSERTATION, BOOK, COURSE = "dissertation", "book", "course"
SOURCES = {
    DISSERTATION: "the abstract of the dissertation, as documents.pub shows it",
    BOOK: "H. W. Jensen, Realistic Image Synthesis Using Photon Mapping (2001), the openings of chapters "
          "3, 4 and 11, as globalspec.com shows them",
    COURSE: "slides of CS395T, University of Texas at Austin (2007), on photon mapping",
}


def ahead_of(rival, ours, kind=plan.WHOLE):
    return lambda results, scene: against(results, scene, rival, ours, kind)


CLAIMS = [
    *(Claim(f"Photon maps are preferred for caustics: `{rival}` / `direct`", DISSERTATION,
            ahead_of(rival, plan.DIRECT), ahead_of(rival, plan.OF_ITS_TIME)) for rival in plan.RIVALS),
    Claim("Radiosity has problems with specular materials: its error on the whole image / without "
          "caustics", BOOK, lambda results, scene: left_out(results, scene, plan.RADIOSITY)),
    Claim("Radiosity suffers from mesh artifacts: `radiosity` / `path`, both without caustics", BOOK,
          ahead_of(plan.RADIOSITY, plan.PATH_EFFECTS, plan.EFFECTS)),
    Claim("Irradiance caching is faster: `path` / `irradiance-cache`, both without caustics",
          BOOK, ahead_of(plan.PATH_EFFECTS, plan.CACHE, plan.EFFECTS)),
    Claim("Bidirectional path tracing is good for caustics of small lights: `path` / `bidirectional`",
          COURSE, ahead_of(plan.PATH, plan.BOTH_WAYS)),
    Claim("Bidirectional path tracing needs many samples: `bidirectional` / `progressive`", COURSE,
          ahead_of(plan.BOTH_WAYS, plan.PROGRESSIVE)),
]


def verdict(claim, results, scene):
    """(ratio or None, that with the dissertation's trees or None, verdict)"""
    found = claim.find(results, scene)
    then = claim.then(results, scene) if claim.then else None
    on_ours = Shown(written(found), found.exceeds(1)) if found else None
    on_theirs = Shown(written(then), then.exceeds(1)) if then else None
    return found, then, claims.verdict(on_theirs if claim.then else on_ours, on_ours)


def shown(claim, results, scene):
    """A cell of a table."""
    found, then, word = verdict(claim, results, scene)
    if found is None:
        return word
    also = f"; then {written(then)}" if then else ""
    return f"{written(found)}{also}: **{word}**"
