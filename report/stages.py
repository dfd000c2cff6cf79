"""Seconds of each stage, as bars."""

from markup import duration, element, escape, section

NAMES = {
    "preprocess": "Partition", "scene": "Read scene and partition", "rays": "Build ray tracing",
    "pilots": "Pilots",
    "photons": "Trace photons", "maps": "Build photon maps", "image": "Eye paths and gathering",
    "film": "Add passes up", "previews": "Rewrite images meanwhile",
    "wait": "Wait for other processes", "add": "Add films up",
    "state": "Read and write states", "write": "Write images", "passes": "Passes",
}


def stages(results):
    seconds = dict(results.stats.get("seconds", {}))
    passes = results.partition.get("seconds", {})
    if passes:
        seconds = {"preprocess": sum(passes.values()), **seconds}
    if not seconds:
        return ""
    within = ""
    if passes:
        within = element("details", element("summary", "Within the partition") + bars(passes))
    total = element("p", f"{duration(sum(seconds.values()))} in all, by the clock.", class_="note")
    return section("Time by stage", bars(seconds) + total + within)


def bars(seconds):
    longest = max(max(seconds.values()), 1e-9)
    rows = []
    for name, value in seconds.items():
        bar = element("span", style=f"width:{max(100 * value / longest, 0.3):.1f}%", class_="bar")
        rows.append(element("tr", element("th", escape(NAMES.get(name, name)), scope="row") +
                            element("td", bar, class_="bars") + element("td", duration(value))))
    return element("table", element("tbody", "".join(rows)), class_="stages numbers")
