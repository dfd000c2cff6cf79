"""The error, its history and its predicted cost: the curve and the cost table."""

import math

from axes import BOTTOM, HEIGHT, LEFT, RIGHT, WIDTH, Axes, finest, padded, round_values
from markup import duration, element, escape, listing, number, percent, section, table

# Round times: milliseconds, seconds, minutes, hours, days.
TIMES = ([step * 10.0 ** power for power in range(-3, 1) for step in (1, 2, 5)] +
         [10, 20, 60, 120, 300, 600, 1200, 3600, 7200, 18000, 36000] +
         [86400 * step * 10.0 ** power for power in range(6) for step in (1, 2, 5)])
MOST_TICKS = 7
FARTHEST = 100  # times the time spent: costs beyond it are in the table alone


def price(stats):
    error = stats["error"]
    before = error.get("seconds_before", 0)
    found = error.get("checks", [])
    checks = [{**check, "seconds": before + check["seconds"]} for check in found
              if check["error"] > 0 and check["seconds"] > 0]
    if not checks:
        said = "No error was found." if found else "Not known: it takes two passes at least."
        return section("Accuracy and its cost", element("p", said))
    target = stats.get("options", {}).get("error")
    sentences = listing(sentences_of(error, checks[-1]))
    curve = element("figure", chart(error, checks, target) + element("figcaption", CAPTION))
    prices = element("div", price_list(stats, error, checks[-1]))
    values = element("details", element("summary", "All values") + table_of_checks(checks))
    return section("Accuracy and its cost", sentences +
                   element("div", curve + prices, class_="columns chart") + values)


CAPTION = ("Error against time, both logarithmic. Dots: estimated errors; band: 95 % confidence "
           "interval; line: error law fitted at the end, dashed where it predicts.")


def sentences_of(error, last):
    yield f"Error {percent(last['error'])} after {number(last['passes'])} passes{interval(last)}."
    if error.get("bias") == "from radii":
        yield (f"Noise {percent(last['noise'])}, bias {percent(math.sqrt(max(last['bias2'], 0)))}: "
               "both vanish with more passes.")
    elif error.get("bias") == "unknown":
        yield "By noise alone: the bias of estimates from the k nearest photons is unknown."
    if last.get("removed"):
        yield f"Of that, {percent(last['removed'])} is bias of removed fireflies."
    if last.get("clamp"):
        yield f"Of that, {percent(last['clamp'])} is bias of --clamp, which no pass reduces."
    if last.get("missing", 0) > last["error"]:
        yield f"Light that few samples find may be missing, up to {percent(last['missing'])}."
    half = [entry for entry in error.get("prices", [])
            if math.isclose(entry["error"], last["error"] / 2, rel_tol=1e-6)]
    if half and half[0]["seconds"] is not None:
        yield (f"Half this error would take {span(half[0], 'passes', number)} passes and "
               f"{span(half[0], 'seconds', duration)} in total.")


def span(price, what, text):
    """A cost, or from which to which where few samples find some of the light."""
    most = price.get(f"most_{what}")
    return text(price[what]) + (f" to {text(most)}" if most is not None else "")


def interval(check):
    if check.get("high") is None:
        return " (too few passes for an interval)"
    return f", with 95 % confidence between {percent(check['low'])} and {percent(check['high'])}"


def law_of(error, last):
    """The error after so many seconds."""
    law, before = error.get("law", {}), error.get("seconds_before", 0)
    parts = [(law.get("by_pass", 0), 1), (law.get("by_photon", 0), law.get("photon_power", 1)),
             (law.get("by_bias", 0), law.get("bias_power", 1)), (law.get("by_clamp", 0), 0)]

    def at(seconds):
        passes = (seconds - before) / (last["seconds"] - before) * last["passes"]
        return math.sqrt(sum(factor / passes ** power for factor, power in parts))
    return at if any(factor > 0 for factor, _ in parts) else None


def predicted(error, last, target):
    """The costs shown in the chart: of half the error, and of the target error."""
    wanted = [last["error"] / 2] + ([target] if target else [])
    return [entry for entry in error.get("prices", []) if entry["seconds"] is not None and
            last["seconds"] < entry["seconds"] < FARTHEST * last["seconds"] and
            any(math.isclose(entry["error"], one, rel_tol=1e-6) for one in wanted)]


def chart(error, checks, target):
    last = checks[-1]
    ahead = predicted(error, last, target)
    times = [entry["seconds"] for entry in checks + ahead]
    with_interval = [check for check in checks
                     if check.get("high") is not None and check["low"] > 0]
    errors = [entry["error"] for entry in checks + ahead] + ([target] if target else [])
    errors += [check[end] for check in with_interval for end in ("low", "high")]
    axes = Axes(padded(times, 1.15), padded(errors, 1.15))
    parts = [grid(axes), band(axes, with_interval), lines(axes, error, checks, ahead),
             target_line(axes, target), "".join(dot(axes, check) for check in checks),
             "".join(ahead_dot(axes, entry) for entry in ahead)]
    first = checks[0]
    said = (f"Error against time: {percent(first['error'])} after {duration(first['seconds'])}, "
            f"{percent(last['error'])} after {duration(last['seconds'])}")
    drawn = element("svg", element("title", "Error against time") + "".join(parts),
                    viewBox=f"0 0 {WIDTH} {HEIGHT}", role="img", aria_label=said)
    return element("div", drawn, class_="scroll", tabindex="0")


def grid(axes):
    times = [[time for time in TIMES[::stride] if axes.x[0] <= time <= axes.x[1]]
             for stride in (3, 2, 1)]
    errors = [round_values(axes.y, steps)
              for steps in ((1,), (1, 3), (1, 2, 5), (1, 1.5, 2, 3, 4, 5, 7))]
    x_ticks, y_ticks = finest(times, MOST_TICKS), finest(errors, MOST_TICKS)
    names = element("text", "time from the start", x=(WIDTH + LEFT - RIGHT) / 2, y=HEIGHT - 6,
                    text_anchor="middle", class_="axis")
    return axes.grid([(value, duration(value)) for value in x_ticks],
                     [(value, percent(value)) for value in y_ticks]) + names


def band(axes, checks):
    if not checks:
        return ""
    if len(checks) == 1:
        at = checks[0]["seconds"]
        return axes.line([(at, checks[0]["low"]), (at, checks[0]["high"])], "whisker")
    around = [(check["seconds"], check["high"]) for check in checks]
    around += [(check["seconds"], check["low"]) for check in reversed(checks)]
    return element("polygon", points=axes.points(around), class_="band")


def lines(axes, error, checks, ahead):
    """The law of docs/error.md (12), from as many passes as an interval needs."""
    law = law_of(error, checks[-1])
    if law is None:
        return ""
    spent = checks[-1]["seconds"]
    known = [check["seconds"] for check in checks if check.get("high") is not None]
    begin = min(known, default=spent)
    end = max([spent] + [entry["seconds"] for entry in ahead])
    drawn = axes.line(curve_of(law, begin, spent), "law")
    return drawn + (axes.line(curve_of(law, spent, end), "law ahead") if end > spent else "")


def curve_of(law, begin, end, steps=24):
    times = [begin * (end / begin) ** (i / steps) for i in range(steps + 1)]
    return [(time, law(time)) for time in times]


def target_line(axes, target):
    if not target:
        return ""
    line = axes.line([(axes.x[0], target), (axes.x[1], target)], "target")
    return line + element("text", escape(f"asked for: {percent(target)}"), x=LEFT + 6,
                          y=f"{axes.up(target) - 6:.1f}", class_="target")


def dot(axes, check):
    said = (f"{duration(check['seconds'])}, {number(check['passes'])} passes: "
            f"{percent(check['error'])}{interval(check)}")
    return marker(axes, check, said, "dot", 4)


def ahead_dot(axes, entry):
    said = (f"{percent(entry['error'])} would take {duration(entry['seconds'])}, "
            f"{number(entry['passes'])} passes")
    text = element("text", escape(f"{percent(entry['error'])}: {duration(entry['seconds'])}"),
                   x=f"{axes.across(entry['seconds']) - 8:.1f}",
                   y=f"{min(axes.up(entry['error']) + 18, HEIGHT - BOTTOM - 4):.1f}",
                   text_anchor="end", class_="ahead")
    return marker(axes, entry, said, "dot ahead", 4) + text


def marker(axes, entry, said, name, radius):
    """A dot, and a larger one that is not seen, to hover over."""
    place = {"cx": f"{axes.across(entry['seconds']):.1f}", "cy": f"{axes.up(entry['error']):.1f}"}
    return element("g", element("title", escape(said)) +
                   element("circle", r=14, class_="hover", **place) +
                   element("circle", r=radius, class_=name, **place))


def price_list(stats, error, last):
    by_photons = (stats.get("options", {}).get("integrator") != "path" and
                  any(entry["photons"] for entry in error.get("prices", [])))
    head = ["Error", "Passes", "Time"] + (["Light paths"] if by_photons else [])
    rows = []
    for entry in error.get("prices", []):
        if entry["passes"] is None:
            continue
        cells = [span(entry, "passes", number), span(entry, "seconds", duration)]
        cells += [number(entry["photons"])] if by_photons else []
        mark = " \u2713" if entry["error"] >= last["error"] else ""
        rows.append([percent(entry["error"]) + mark] + cells)
    note = element("p", "From the start of the render; \u2713 reached.", class_="note")
    return element("h3", "Cost table") + table(head, rows, class_="numbers") + note if rows else ""


def table_of_checks(checks):
    biased = any("bias2" in check for check in checks)
    head = ["Passes", "Time", "Error", "95 %", "Noise"] + (["Bias"] if biased else [])
    rows = []
    for check in checks:
        known = check.get("high") is not None
        row = [number(check["passes"]), duration(check["seconds"]), percent(check["error"]),
               f"{percent(check['low'])} \u2013 {percent(check['high'])}" if known else "\u2013",
               percent(check["noise"])]
        rows.append(row + ([percent(math.sqrt(max(check.get("bias2", 0), 0)))] if biased else []))
    return table(head, rows, class_="numbers")
