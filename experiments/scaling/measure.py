"""Measures the stages of renders, and whole renders by one process and by two."""

import concurrent.futures
import dataclasses
import json
import pathlib
import shutil
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "experiments"))
import programs
from turns import in_turns

SCENES = ("cornell", "hall_of_lamps", "window_room")
SUMMED = ("pilots", "photons", "maps", "image", "film", "write")


@dataclasses.dataclass(frozen=True)
class Study:
    """points: pixels across the images from which stages follow, and photons of a pass; 0: as many as
    render chooses.  checked: pixels across those by one process and by two, at no point.  passes: of which the
    average counts, for later passes cost less.  checked_passes: over a minute of them.  error_passes: to
    which the law of the error is fitted.  repeats: of which the least counts, of what is not done in turns."""

    points: tuple = ((96, 0), (160, 0), (224, 0), (224, 1_000_000))
    checked: int = 192
    passes: int = 10
    checked_passes: int = 48
    error_passes: int = 40
    repeats: int = 2


FULL = Study()
QUICK = Study(points=((16, 1000), (32, 1000), (32, 8000)), checked=24, passes=2, checked_passes=4, error_passes=16,
              repeats=1)


@dataclasses.dataclass(frozen=True)
class Lab:
    """tools: folder of the programs.  folder: for partitions."""

    tools: pathlib.Path
    folder: pathlib.Path
    study: Study

    def scene(self, name):
        return ROOT / "assets" / f"{name}.glb"

    def partition(self, name):
        return self.folder / f"{name}.hpm"

    def make_partition(self, name):
        programs.run(self.tools, "preprocess", self.scene(name), "-o", self.partition(name))

    def words(self, name, size, folder, *options):
        """Of a render on one thread."""
        return [self.scene(name), self.partition(name), "-o", folder / "a.exr", "-o", folder / "a.png",
                "--size", size, "--threads", 1, "--stats", folder / "stats.json", *options]

    def render(self, name, size, folder, *options):
        programs.run(self.tools, "render", *self.words(name, size, folder, *options))
        return json.loads((folder / "stats.json").read_text())

    def run_ranks(self, ranks, name, size, folder, *options):
        """What the program took, and the statistics."""
        mpirun = pathlib.Path(shutil.which("mpirun"))
        done = programs.run(mpirun.parent, mpirun.name, "--oversubscribe", "--bind-to", "none", "-n",
                            ranks, self.tools / "render",
                            *self.words(name, size, folder, "--mpi", *options))
        return done, json.loads((folder / "stats.json").read_text())


def twice(job):
    """Both results of a job done on two cores at once, each in a folder of its own: a core is slower
    while its neighbour works, as it does where machines are busy."""
    def do(_):
        with tempfile.TemporaryDirectory() as folder:
            return job(pathlib.Path(folder))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(do, range(2)))


def least(rows):
    """Of each stage by itself."""
    return {name: min(row[name] for row in rows) for name in rows[0]}


def mean(rows):
    """Of each stage by itself."""
    return {name: sum(row[name] for row in rows) / len(rows) for name in rows[0]}


def without_start(seconds):
    """Processor seconds of the stages, and of what is none."""
    found = {name: seconds[name] for name in SUMMED}
    found["load"] = seconds["scene"] + seconds["rays"]
    found["start"] = max(0, seconds["process"] - found["load"] - sum(seconds[name] for name in SUMMED) -
                         seconds["previews"] - seconds["state"])
    return found


def merge_all(lab, folder, states):
    return programs.run(lab.tools, "render", "merge", *states, "-o", folder / "m.exr", "-o",
                        folder / "m.png").seconds


def point_key(size, photons):
    return f"{size}/{photons}"


def chosen(photons):
    return ("--photons", photons) if photons else ()


def measure_passes(lab, name, point, folder, first=0):
    """Stages of a render from pass `first` on, passes on the average; and the pixels."""
    passes, (size, photons) = lab.study.passes, point
    stats = lab.render(name, size, folder, "--first-pass", first, "--passes", passes,
                       *chosen(photons))
    found = without_start(stats["processor_seconds"])
    for stage in ("photons", "maps", "image", "film"):
        found[stage] /= passes
    return {**found, "pixels": stats["image"]["width"] * stats["image"]["height"],
            "photons_of_pass": stats["options"]["photons"]}


def make_states(lab, name, size, folder):
    """Three, of passes that take little time: of a state only its pixels count."""
    def one(i):
        path = folder / f"{i}.state"
        own = folder / str(i)
        own.mkdir()
        lab.render(name, size, own, "--samples", 1, "--photons", 1000, "--first-pass", 8 * i, "--passes",
                   8, "--state", path)
        return path
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(one, range(3)))


def measure_states(lab, states, folder):
    """Reading, merging and writing them."""
    merge = ("merge", "-o", folder / "m.exr", "-o", folder / "m.png")
    def seconds(*words):
        return programs.run(lab.tools, "render", *words).seconds
    return {"read": seconds("describe", states[0]), "two": seconds(*merge, *states[:2]),
            "three": seconds(*merge, *states),
            "saved": seconds(*merge, *states, "--state", folder / "m.state")}


def of_states(lab, name, size):
    """The stages of states, from the least times."""
    with tempfile.TemporaryDirectory() as made:
        states = make_states(lab, name, size, pathlib.Path(made))
        rows = []
        for _ in range(2 * lab.study.repeats):
            rows += twice(lambda folder: measure_states(lab, states, folder))
        size = states[0].stat().st_size
    found = least(rows)
    merge = max(0, found["three"] - found["two"])
    return {"read": found["read"], "merge": merge, "save": max(0, found["saved"] - found["three"]),
            "merge_begin": max(0, found["two"] - 2 * merge), "state_bytes": size}


def of_ranks(lab, name, size):
    """Processor seconds of the lead: adding up two films, with waiting for it, and the part of the pilots that
    processes share."""
    def lead(ranks, folder):
        _, stats = lab.run_ranks(ranks, name, size, folder, "--passes", 4, "--samples", 1)
        return {"add": stats["processor_seconds"]["add"] / stats["rounds"],
                "pilots": stats["processor_seconds"]["pilots"]}
    alone, both = [], []
    for _ in range(lab.study.repeats):
        alone += twice(lambda folder: lead(1, folder))
        with tempfile.TemporaryDirectory() as folder:
            both.append(lead(2, pathlib.Path(folder)))
    alone, both = least(alone), least(both)
    return {"add": both["add"], "shared_pilots": max(0, 2 * (alone["pilots"] - both["pilots"]))}


def measure_sums(lab, name, size):
    """The stages of states and of films, whatever the photons."""
    return {**of_states(lab, name, size), **of_ranks(lab, name, size)}


def run_by(lab, name, ranks, size, *options):
    """A render by processes, one of them beside another such render: processor seconds of all and seconds of
    the clock, the least.  The start of MPI is in them."""
    def one(folder):
        begun = time.monotonic()
        done, _ = lab.run_ranks(ranks, name, size, folder, *options)
        return {"processor": done.seconds, "wall": time.monotonic() - begun}
    if ranks == 1:
        return least(twice(one))
    with tempfile.TemporaryDirectory() as folder:
        return one(pathlib.Path(folder))


def measure_stages(lab, name):
    """The stages at each point, by the words of point_key."""
    return {point_key(*point): mean(twice(lambda folder: measure_passes(lab, name, point, folder)))
            for point in lab.study.points}


def measure_checked(lab, name):
    """In turns, so that the machine is as fast for each: the stages, and the checks of a render by one process
    and by two.  A check has seconds of the clock, and those of the same render by one process alone."""
    passes = lab.study.checked_passes
    def by(ranks):
        return run_by(lab, name, ranks, lab.study.checked, "--passes", passes)
    stages, one, two = in_turns([lambda: measure_stages(lab, name), lambda: by(1), lambda: by(2)])
    return {"stages": stages.result,
            "checks": [{"processes": ranks, "passes": passes, "wall": turn.seconds(), "alone": one.seconds()}
                       for ranks, turn in ((1, one), (2, two))]}


def launch(lab, name, ranks):
    """What starting and ending MPI takes, by a small image: processor seconds of all processes and
    seconds of the clock beyond those of a render without MPI."""
    small = ("--passes", 1, "--samples", 1)
    runs, plain = [], []
    for _ in range(lab.study.repeats):
        def one(folder):
            begun = time.monotonic()
            done = programs.run(lab.tools, "render", *lab.words(name, 8, folder, *small))
            return {"processor": done.seconds, "wall": time.monotonic() - begun}
        runs.append(run_by(lab, name, ranks, 8, *small))
        plain += twice(one)
    with_mpi, without = least(runs), least(plain)
    return {"processor": max(0, with_mpi["processor"] - ranks * without["processor"]),
            "wall": max(0, with_mpi["wall"] - without["wall"])}


def passes_to_error(lab, name):
    """The law of the image's error (docs/error.md (12)), and what a pass has."""
    with tempfile.TemporaryDirectory() as folder:
        stats = lab.render(name, lab.study.checked, pathlib.Path(folder), "--passes",
                           lab.study.error_passes)
    image, options = stats["image"], stats["options"]
    return {"law": stats["error"]["law"], "samples": options["samples"],
            "aspect": image["height"] / image["width"]}
