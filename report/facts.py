"""What is told in words and tables."""

import shlex

from compare import gallery
from markup import duration, element, escape, listing, memory, number, percent, section, table

KINDS = ("global", "caustic", "indirect")
ROWS = {
    "stored": "Photons stored", "shared_maps": "Shared maps", "local_maps": "Local maps",
    "group_maps": "Group maps", "largest_map": "Photons of the largest map",
    "queries": "Estimates asked for",
}


def header(results):
    stats = results.stats
    image, options = stats.get("image", {}), stats.get("options", {})
    said = ["hipmap " + stats["version"]] if "version" in stats else ["hipmap"]
    said += [f"{image['width']} \u00d7 {image['height']}"] if "width" in image else []
    said += [f"{options['integrator']}, {options['maps']} maps"] if options else []
    return element("header", element("h1", escape(results.title())) +
                   element("p", escape(" \u00b7 ".join(said))) + tiles(stats))


def tiles(stats):
    """The few numbers that matter most."""
    checks = stats["error"].get("checks", [])
    shown = []
    if checks:
        last = checks[-1]
        known = last.get("high") is not None
        shown.append(("Error", percent(last["error"]),
                      f"95 %: {percent(last['low'])} to {percent(last['high'])}" if known else ""))
        shown.append(("Time on passes", duration(last["seconds"]), ended(stats)))
    shown.append(("Passes", number(stats["passes_done"]), ""))
    if emitted := stats.get("photons", {}).get("emitted"):
        shown.append(("Light paths", number(emitted), ""))
    if faces := stats.get("scene", {}).get("faces"):
        maps = stats.get("partition", {}).get("shared_maps", 0)
        shown.append(("Faces", number(faces), f"{number(maps)} shared maps"))
    if size := stats["error"].get("memory"):
        shown.append(("Memory at most", memory(size), ""))
    return element("dl", "".join(
        element("div", element("dt", escape(name)) + element("dd", escape(value)) +
                (element("dd", escape(note), class_="note") if note else ""))
        for name, value, note in shown), class_="tiles")


def ended(stats):
    return {"passes": "ended after the passes asked for", "time": "ended by the time",
            "error": "ended by the error asked for",
            "signal": "stopped by a signal"}.get(stats.get("ended_by"), "")


def audit(stats):
    found = stats.get("audit")
    if not found:
        return ""
    groups = ("found", "Found"), ("assumed", "Assumed"), ("lost", "Lost or not read")
    parts = [element("h3", title) + listing(found[name]) for name, title in groups
             if found.get(name)]
    return section("Scene audit", "".join(parts))


def effects(stats):
    plan = stats.get("effects")
    if not plan:
        return ""
    rows = []
    for effect in sorted(plan, key=lambda effect: not effect["on"]):
        state = element("span", "on" if effect["on"] else "off",
                        class_="on" if effect["on"] else "off")
        rows.append([escape(effect["name"]), state, escape(effect.get("reason", "")),
                     escape(effect.get("cost", ""))])
    return section("Effects", table(["Effect", "", "Why", "Cost"], rows))


def photons(stats):
    known = stats.get("photons", {})
    kinds = [kind for kind in KINDS if known.get(kind, {}).get("stored")]
    if not kinds:
        return ""
    rows = [[escape(title)] + [number(known[kind].get(name, 0)) for kind in kinds]
            for name, title in ROWS.items()]
    rows.append(["Photons found by each"] + [found_by_each(known[kind]) for kind in kinds])
    sentences = [f"{tier.capitalize()} maps of {kind} photons: {known[kind][tier]['decision']}."
                 for kind in kinds for tier in ("local", "group")
                 if "decision" in known[kind].get(tier, {})]
    note = element("p", f"{number(known['emitted'])} light paths, and {number(known['aimed'])} "
                   "aimed at specular surfaces. Maps are those of the last pass.", class_="note")
    tiers = element("h3", "Which tiers pay") + listing(sentences) if sentences else ""
    return section("Photons and their maps", table(
        [""] + [kind.capitalize() for kind in kinds], rows, class_="numbers") + note + tiers)


def found_by_each(kind):
    return f"{kind['photons_found'] / kind['queries']:.1f}" if kind.get("queries") else "\u2013"


def partition(results):
    found = results.partition
    if not found:
        return ""
    edges = [f"{number(count)} {name.replace('_', '-')}" for name, count in found["edges"].items()
             if count and name != "in_tolerance_band"]
    sentences = [f"{number(found['shared_maps'])} shared maps of {number(found['faces'])} faces: "
                 f"neighbours that meet at less than {found['angle_deg']:g} degrees share one.",
                 f"Edges: {', '.join(edges)}.",
                 f"Candidates: {number(found['candidates'])} faces for local maps, "
                 f"{number(found['groups'])} patches for group maps."]
    defects = [f"{number(count)} {name.replace('_', ' ')}"
               for name, count in found.get("defects", {}).items() if count]
    if defects:
        sentences.append(f"Defects of the mesh: {', '.join(defects)}.")
    largest = sorted(found["maps"], key=lambda part: -part["area_m2"])[:8]
    rows = [[number(part["id"]), escape(names(part["objects"])), escape(names(part["materials"])),
             number(part["faces"]), f"{part['area_m2']:.3g}"] for part in largest]
    head = ["Map", "Objects", "Materials", "Faces", "Area, m\u00b2"]
    return section("Partition", listing(sentences) + gallery(results.others) + element(
        "details", element("summary", f"The {len(rows)} largest maps") + table(head, rows)))


def names(found, most=3):
    shown = ", ".join(found[:most])
    return shown + (f" and {len(found) - most} more" if len(found) > most else "")


def options(stats):
    chosen = stats.get("options") or stats.get("settings")
    if not chosen:
        return ""
    pairs = "".join(element("div", element("dt", escape(name.replace("_", " "))) +
                            element("dd", escape(value)))
                    for name, value in chosen.items() if value is not None)
    return section("Options", element("dl", pairs, class_="options"))


def how_to_repeat(results):
    commands = [found["command"] for found in (results.partition, results.stats)
                if found.get("command")]
    if not commands:
        return ""
    lines = "\n".join(shlex.join(command) for command in commands)
    note = element("p", "The same seed gives the same image, bit for bit, at any number of "
                   "threads; a render ended by time, for the same number of passes.",
                   class_="note")
    return section("To make it again",
                   element("pre", element("code", escape(lines)), tabindex="0") + note)
