"""What the results (results.json) say of a scene and a setting."""

import math

import arithmetic
import plan
import promises


def runs(results, kind, scene, setting):
    """Of all seeds: [[[passes, seconds, relMSE, that with plan.MARKS_CONSTANT]]]."""
    begin = f"{kind}/{scene.name}/{setting.name}/"
    return [run for key, run in results["runs"].items() if key.startswith(begin)]


def curve(results, kind, scene, setting, column=2):
    """[(seconds, error, its standard error, passes)], the error by that column of the runs."""
    return arithmetic.mean_curve(runs(results, kind, scene, setting), column)


def curves(results, scene):
    """By the name of the setting; those that have a point."""
    found = {name: curve(results, "image", scene, setting)
             for name, setting in plan.SETTINGS.items()}
    return {name: points for name, points in found.items() if points}


def scenes(results):
    return [scene for scene in plan.SCENES.values()
            if f"noise/{scene.name}" in results["runs"]]


def reference_noise(results, scene, size):
    """Error of the reference that is noise."""
    return math.sqrt(results["runs"][f"noise/{scene.name}"][str(size)])


def reference_seconds(results, scene):
    return sum(results["runs"][f"reference/{scene.name}/{plan.FILTER}/{half}"]["seconds"]
               for half in (0, 1))


def quickest(found, names, error):
    """(name, seconds) of the setting that meets an error first; None: none does."""
    met = [(arithmetic.seconds_to(found[name], error), name) for name in names if name in found]
    met = [(seconds, name) for seconds, name in met if seconds is not None]
    return min(met)[::-1] if met else None


def measured_to(found, name):
    """Seconds of the last point of a curve."""
    return found[name][-1][0] if name in found else 0.0


def against_path(found, name, error):
    """(seconds, seconds of path, ratio, whether the ratio is only known to be below that).  None:
    the setting does not meet the error."""
    seconds = arithmetic.seconds_to(found.get(name, []), error)
    if seconds is None:
        return None
    path = arithmetic.seconds_to(found.get(plan.PATH, []), error)
    if path is not None:
        return seconds, path, seconds / path, False
    end = measured_to(found, plan.PATH)
    return (seconds, None, seconds / end, True) if end else None


def regret(found, seconds):
    """(times that BASE takes longer to the least error that any of plan.GRID has after these seconds,
    the name of that).  times: None if BASE does not meet it as far as it was measured.  None: not all
    are measured there."""
    errors = {name: arithmetic.error_after(found.get(name, []), seconds) for name in plan.GRID}
    if None in errors.values():
        return None
    best = min(errors, key=errors.get)
    mine = arithmetic.seconds_to(found[plan.BASE], errors[best])
    return mine and mine / seconds, best


MOST_SLOWER = 1.5  # times that the progressive integrator may take without caustics


def begins_better(found, name, error):
    """Whether the first point of a curve is better than that: there is no equal error to compare
    at."""
    return bool(found.get(name)) and found[name][0][1] < error


def keeps_mark(scene, ratio, only_below):
    """True, False, or None where that is not known."""
    most = 1.0 if scene.caustics else MOST_SLOWER
    if ratio < most:
        return True
    return None if only_below else False


def kept(quote):
    """Whether passes and true error are within a factor of what was promised."""
    if not quote["met"] or quote["error2"] <= 0:
        return False
    true = math.sqrt(quote["error2"])
    return (promises.held(quote["promised_passes"], quote["passes"]) and
            promises.held((quote["error"], quote["error"]), true))


def recommended(results, names, error):
    """The setting that loses least to the quickest of each scene on the scene where it loses most:
    (name, times, [its seconds by scene]).  None: none meets the error wherever any does."""
    worst, taken = {}, {}
    for scene in scenes(results):
        found = curves(results, scene)
        best = quickest(found, names, error)
        if best is None:
            continue
        for name in names:
            seconds = arithmetic.seconds_to(found.get(name, []), error)
            worst[name] = max(worst.get(name, 0),
                              math.inf if seconds is None else seconds / best[1])
            taken.setdefault(name, []).append(seconds)
    if not worst or min(worst.values()) == math.inf:
        return None
    name = min(worst, key=worst.get)
    return name, worst[name], taken[name]
