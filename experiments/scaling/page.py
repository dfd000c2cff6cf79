#!/usr/bin/env python3
"""Writes the section on scaling of docs/many_machines.md, and its charts.

    experiments/scaling/page.py             # docs/many_machines.md and docs/scaling/*.png
    experiments/scaling/page.py --to FOLDER # the same below another folder, which has many_machines.md

Simulates renders by what docs/scaling/measured.json has.  Needs matplotlib for the charts (Debian: apt-get
install python3-matplotlib, for /usr/bin/python3).  The text between <!-- scaling --> and <!-- end --> is
replaced.  Takes a minute.
"""

import argparse
import dataclasses
import json
import pathlib
import re
import textwrap

import measure
import scenario
from model import FILM_BYTES_OF_PIXEL, Model
from ranks import simulate_ranks
from stages import Cluster

LIMITS = {"load": "start and load", "pilots": "pilots", "queue": "queue", "save": "states and images",
          "add": "adding up films", "merge": "merge", "wait": "waiting", "lost": "failures"}


def table(headers, rows):
    lines = ["| " + " | ".join(map(str, cells)) + " |" for cells in (headers, *rows)]
    return "\n".join([lines[0], "|" + "---|" * len(headers), *lines[1:]])


@dataclasses.dataclass(frozen=True)
class Sweep:
    """By number of machines.  plain, checked: of MPI, without and with --error.  passes, tiles: Choice of tasks
    of passes alone, and of tiles too."""

    plain: dict
    checked: dict
    passes: dict
    tiles: dict


def sweep(stages, image, counts):
    clusters = {count: scenario.with_machines(count) for count in counts}
    return Sweep({n: scenario.by_mpi(stages, image, cluster) for n, cluster in clusters.items()},
                 {n: scenario.by_mpi(stages, image, cluster, checks=True) for n, cluster in clusters.items()},
                 {n: scenario.by_tasks(stages, image, cluster, (1,)) for n, cluster in clusters.items()},
                 {n: scenario.by_tasks(stages, image, cluster) for n, cluster in clusters.items()})


def check_rows(measured):
    """The model beside renders by one process and by more."""
    rows = []
    for scene in measured["scenes"]:
        model, runs = Model(measured, scene), measured["runs"]
        size = measured["about"]["study"]["checked"]
        stages = model.stages(size * round(size * runs[f"error/{scene}"]["aspect"]))

        def simulated(ranks, passes):
            started = runs.get(f"launch/{scene}/{ranks}", {"wall": 0})["wall"]  # none without MPI
            return simulate_ranks(stages, passes, Cluster(machines=ranks), keeps_states=False).seconds + started

        for check in runs[f"checked/{scene}"]["checks"]:
            ranks, passes, took = check["processes"], check["passes"], check["wall"]
            by_model = simulated(ranks, passes)
            rows.append((scene, ranks, passes, f"{took:.1f}", f"{by_model:.1f}", f"{100 * (by_model / took - 1):+.0f} %",
                         *(f"{100 * alone / (ranks * all_s):.0f} %"
                           for alone, all_s in ((check["alone"], took), (simulated(1, passes), by_model)))))
    return rows


def check_table(measured):
    return table(("scene", "processes", "passes", "measured: s", "simulated: s", "difference", "efficiency, measured",
                  "efficiency, simulated"), check_rows(measured))


def section_of_all_cores(measured):
    """What was measured with all cores of a machine busy."""
    text = (f"And on a machine with more cores ({measured['about']['machine']}, {measured['date']}), all of them busy: each "
            "row is of parts of an image that ran at once, each by so many processes, and the rows took turns. The "
            "efficiency compares with the same passes by one process alone: all parts of the first row, less their setups "
            "but one:")
    return "\n".join([textwrap.fill(text, 140), "", check_table(measured)])


def best(found, count):
    return min(found.plain[count].seconds, found.tiles[count].out.seconds)


def efficiency(found, count):
    """Seconds of one machine by those of all."""
    return best(found, min(found.tiles)) / (count * best(found, count))


def count_rows(found):
    rows = []
    for n, choice in found.tiles.items():
        plan, out = choice.plan, choice.out
        rows.append((f"{n:,}", f"{found.plain[n].seconds:.0f}", LIMITS[scenario.limit(found.plain[n])],
                     f"{found.checked[n].seconds:.0f}", f"{found.passes[n].out.seconds:.0f}", f"{out.seconds:.0f}",
                     f"{plan.chunk} of 1/{plan.tiles}", LIMITS[scenario.limit(out)], f"{100 * efficiency(found, n):.0f} %"))
    return rows


def purchases(stages, image):
    """The same cores in machines of other sizes, and other networks."""
    base = scenario.MACHINES
    cores = 64 * base.cores
    offers = [(f"{cores // each} machines of {each} cores", dataclasses.replace(base, machines=cores // each,
                                                                                 cores=each))
              for each in (4, base.cores, 64)]
    offers += [(f"{cores // base.cores} machines of {base.cores} cores, network of {bits} Gbit/s",
                dataclasses.replace(base, machines=cores // base.cores, network=bits * scenario.GIGABIT,
                                    storage=4 * bits * scenario.GIGABIT)) for bits in (1, 100)]
    offers += [(f"{2 * cores // base.cores} machines of {base.cores} cores",
                dataclasses.replace(base, machines=2 * cores // base.cores))]
    rows = []
    for name, cluster in offers:
        mpi, tasks = scenario.by_mpi(stages, image, cluster), scenario.by_tasks(stages, image, cluster)
        rows.append((name, f"{mpi.seconds:.0f}", f"{tasks.out.seconds:.0f}", f"{100 * mpi.share('passes'):.0f} %",
                     f"{100 * tasks.out.share('passes'):.0f} %"))
    return rows


def crossing(found):
    """The least number of machines from which on tiles beat passes alone by a tenth; None: never."""
    for n in found.tiles:
        if found.tiles[n].out.seconds < 0.9 * found.passes[n].out.seconds:
            return n
    return None


def advice(found, image):
    half = max(n for n in found.tiles if efficiency(found, n) >= 0.5)
    tasks = min(found.tiles, key=lambda n: found.tiles[n].out.seconds)
    mpi = min(found.plain, key=lambda n: found.plain[n].seconds)
    many = [out.rounds for n, out in found.checked.items() if n > 1]
    lines = [f"* Up to {half:,} machines, the efficiency (the time of one machine divided by the time of all machines together) "
             "is 50 % or more. Frames of an animation share nothing, so an animation keeps more machines busy.",
             f"* The image is quickest by tasks on {tasks:,} machines ({found.tiles[tasks].out.seconds:.0f} s) and "
             f"by MPI on {mpi:,} ({found.plain[mpi].seconds:.0f} s). More machines do not help.",
             f"* With `--error`, MPI adds up all films at each look at the error, {min(many)} to {max(many)} times here; "
             f"{FILM_BYTES_OF_PIXEL * image.pixels() / 1e6:.0f} MB go from machine to machine at each step of a sum. Give "
             "`--passes` where the number of passes is known."]
    if tiles_from := crossing(found):
        lines.append(f"* Passes run out at {image.passes:,} machines. From {tiles_from:,} machines on, tasks of tiles and "
                     "passes (`--tiles`) are quicker by a tenth than those of passes: a state is then a part of the image, "
                     "and merges sooner.")
    return [textwrap.fill(line, 140, subsequent_indent="  ") for line in lines]


def section(measured, image, counts):
    """The text, and what charts show."""
    stages = Model(measured, image.scene).stages(image.pixels())
    found = sweep(stages, image, counts)
    base = scenario.MACHINES
    about = (
        f"Simulated: {image.passes} passes of assets/{image.scene}.glb, {image.width}x{image.height}, on machines of "
        f"{base.cores} cores with {base.network / scenario.GIGABIT:.0f} Gbit/s to each and "
        f"{base.storage / scenario.GIGABIT:.0f} Gbit/s to the folder of all. Their speeds differ by "
        f"{100 * base.spread:.0f} %, tasks start after {base.queue_s:g} s, and none fails. Stages follow from renders of "
        f"small images on one core ({measured['about']['machine']}, {measured['date']}): those that threads divide are "
        "divided by the cores. `experiments/scaling/page.py` writes this section.")
    text = [
        textwrap.fill(about, 140), "",
        "![Seconds by number of machines](scaling/times.png)", "",
        table(("machines", "MPI: s", "most of the rest is", "with `--error`: s", "tasks of passes: s",
               "tasks of passes and tiles: s", "passes and part of the image of a task", "most of the rest is",
               "efficiency"), count_rows(found)), "",
        "![What machines do by number of machines](scaling/shares.png)", "", *advice(found, image), "",
        "What to buy, by seconds and by the share of the machines' time that goes into passes:", "",
        table(("machines", "MPI: s", "tasks: s", "MPI: passes", "tasks: passes"), purchases(stages, image)), "",
        textwrap.fill(
            f"The same simulation beside renders of {measured['about']['study']['checked']} pixels across on the machine "
            "that was measured, a thread for each process. The render by one process (beside another such render), the one by "
            "two, and those that gave the stages took turns of half a second, so that the machine was as fast for each:",
            140), "", check_table(measured)]
    return "\n".join(text), found


def draw(found, folder):
    import charts

    one = found.tiles[min(found.tiles)].out.seconds * min(found.tiles)
    charts.draw_times({"no loss": {n: one / n for n in found.tiles},
                       "MPI": {n: out.seconds for n, out in found.plain.items()},
                       "MPI with --error": {n: out.seconds for n, out in found.checked.items()},
                       "tasks of passes": {n: choice.out.seconds for n, choice in found.passes.items()},
                       "tasks of passes and tiles": {n: choice.out.seconds for n, choice in found.tiles.items()}},
                      folder / "times.png")
    charts.draw_shares({"MPI": found.plain,
                        "tasks of passes and tiles": {n: choice.out for n, choice in found.tiles.items()}},
                       folder / "shares.png")


def replace_section(page, text):
    """page: with both markers.  text: of the section."""
    return re.sub(r"(<!-- scaling -->\n).*?(<!-- end -->)", lambda match: match[1] + text + "\n" + match[2], page,
                  flags=re.S)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--to", type=pathlib.Path, default=measure.ROOT / "docs", help="folder to write to [docs]")
    options = parser.parse_args()
    folder = measure.ROOT / "docs/scaling"
    text, found = section(json.loads((folder / "measured.json").read_text()), scenario.Image(), scenario.COUNTS)
    for file in sorted(folder.glob("measured_*.json")):
        text += "\n\n" + section_of_all_cores(json.loads(file.read_text()))
    (options.to / "scaling").mkdir(parents=True, exist_ok=True)
    draw(found, options.to / "scaling")
    page = options.to / "many_machines.md"
    page.write_text(replace_section(page.read_text(), text))


if __name__ == "__main__":
    main()
