"""Writes what the experiment measured as Markdown."""

from measure import ANGLE_DEG, MODES, SCENES

# Photons stored in tests 1 to 5 by the dissertation; it says no more of scene 3.
DISSERTATION_STORED = {1: (26019, 50513, 152881, 384119, 778138),
                       2: (7814, 16178, 48869, 97588, 180389),
                       3: (None, 1152000, None, None, None)}


def table(headers, rows):
    lines = [headers, ["---"] * len(headers), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def number(value):
    return "-" if value is None else f"{value:,}"


def seconds(value):
    return f"{value:.3f}"


def ratio(above, below):
    """The net cost of few photons may be lost in the noise, or below nothing."""
    return f"{above / below:.2f}" if above > 0 and below > 0 else "-"


def net_table(rows):
    """rows: of one scene.  Tables 3 and 4 of the dissertation."""
    lines = []
    for test in sorted({row["test"] for row in rows}):
        net = {row["mode"]: row["net_s"] for row in rows if row["test"] == test}
        stored = next(row["stored"] for row in rows if row["test"] == test)
        lines.append([test, number(stored), *(seconds(net[mode]) for mode in MODES),
                      *(ratio(net["global"], net[mode]) for mode in MODES[1:])])
    against = [f"global / {mode}" for mode in MODES[1:]]
    return table(["test", "photons stored", *(f"{mode}, s" for mode in MODES), *against], lines)


def raw_table(rows):
    """rows: of one scene and mode.  Tables 5 to 9 of the dissertation."""
    headers = ["test", "k", "photons emitted", "aimed besides", "photons stored",
               "stored in the dissertation", "shared maps", "local maps", "building, s",
               "rendering, s", "without photons, s"]
    return table(headers, [[
        row["test"], row["k"], number(row["emitted"]), number(row["aimed"]), number(row["stored"]),
        number(DISSERTATION_STORED[row["scene"]][row["test"] - 1]), number(row["shared_maps"]),
        number(row["local_maps"]), seconds(row["build_s"]), seconds(row["image_s"]),
        seconds(row["empty_s"])] for row in rows])


def introduction(results, readme):
    about = results["about"]
    return f"""# The experiment of the dissertation, repeated

Written by `experiments/run_experiment.py`; do not edit. Scenes and settings:
[experiments/README.md]({readme}). Commit {about["commit"]}; {about["machine"]}; images
{about["size"]} pixels wide, one sample a pixel; runs of each: {about["repeats"]}, the fastest counts;
angle threshold {ANGLE_DEG} degrees; M = 10 k. Photons emitted and k are those of the dissertation
divided by {about["divide"]}.

Building is splitting and ordering the photons. Caustic photons have maps of their own in every
mode. The **net query cost** is the time to render an image whose light comes from the photons alone
less the time to render it without photons.
"""


def document(results, figures, readme):
    """results: as in experiments.json.  figures: {scene: file}, from the document's folder."""
    parts = [introduction(results, readme)]
    for scene in sorted({row["scene"] for row in results["rows"]}):
        rows = [row for row in results["rows"] if row["scene"] == scene]
        parts.append(f"## Scene {scene}: `{SCENES[scene]}`\n\nNet query cost:\n")
        parts.append(net_table(rows))
        if scene in figures:
            parts.append(f"![Net query cost of scene {scene}]({figures[scene]})\n")
        for mode in MODES:
            parts.append(f"Mode `{mode}`:\n")
            parts.append(raw_table([row for row in rows if row["mode"] == mode]))
    return "\n".join(parts)
