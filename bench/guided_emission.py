#!/usr/bin/env python3
"""Measures what guided emission gains where light is hard to find, and writes docs/guided_emission.md.

    bench/guided_emission.py [--before BIN] [--seconds 30] [--reference 150] [--seeds 1] [--size 192] [--keep] [SCENE...]

Each scene is rendered by integrator progressive for the same wall time with --emission by-power and guided, and
by the render of another build if one is given.  relMSE (docs/error.md (3)) is against two renders of narrower
radii and other seeds, each as long as half of the reference: the noise of one does not agree with that of the
other, and so averages out.  Takes (reference + 2 or 3 times seeds times seconds) for each scene, on all cores.
With --keep the rows of other scenes stay as they are on the page.
"""

import argparse
import datetime
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "experiments/accuracy"))

import arithmetic  # noqa: E402

BIN = ROOT / "build/release/bin"
PAGE = ROOT / "docs/guided_emission.md"
PICTURES = ROOT / "docs/images/guided"
HARD = ("window_room", "sixty_rooms", "wide_plane")
PRESENT = ("cornell", "cornell_diffuse", "cornell_spheres", "glass_globe", "hall_of_lamps")
FEW = 12  # of the references: radii like those of the images would hide the bias of both


def run(command):
    """Runs a command.  Returns all that it printed."""
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        sys.exit(f"error: {command[0]}: {done.stdout.strip().splitlines()[-1]}")
    return done.stdout


class Lab:
    def __init__(self, options, folder):
        self.options, self.folder = options, pathlib.Path(folder)

    def render(self, scene, name, seconds, *more, tool=BIN):
        """Returns the picture, the passes and the stated error."""
        image = self.folder / f"{scene}_{name}.pfm"
        partition = self.folder / f"{scene}_{'now' if tool == BIN else 'before'}.hpm"
        if not partition.exists():
            run([tool / "preprocess", ROOT / f"assets/{scene}.glb", "-o", partition])
        printed = run([tool / "render", ROOT / f"assets/{scene}.glb", partition, "-o", image,
                       "--size", self.options.size, "--filter", "box", "--time", seconds, *more])
        stated = re.search(r"accuracy: error ([\d.]+ %)", printed)
        passes = re.search(r"in (\d+) passes", printed)
        return image, passes[1] if passes else "", stated[1] if stated else ""

    def halves(self, scene):
        """The two halves of the reference."""
        return [arithmetic.read_pfm(self.render(
                    scene, f"half_{seed}", self.options.reference / 2, "--seed", seed,
                    "--fireflies", "keep", "--neighbours", FEW)[0]) for seed in (98, 99)]

    def kinds(self, scene):
        """What render made of each kind and seed."""
        seeds = range(1, self.options.seeds + 1)
        before = [("before", self.options.before, ())] if self.options.before else []
        now = [(kind, BIN, ("--emission", kind)) for kind in ("by-power", "guided")]
        return {kind: [self.render(scene, f"{kind}_{seed}", self.options.seconds, "--seed", seed,
                                   *more, tool=tool) for seed in seeds]
                for kind, tool, more in before + now}

    def row(self, scene):
        """A row of the table."""
        halves, kinds = self.halves(scene), self.kinds(scene)
        errors = {kind: statistics.mean(arithmetic.relative_mse(arithmetic.read_pfm(each[0]), halves)
                                        for each in made) for kind, made in kinds.items()}
        first = next(iter(kinds))
        if scene in HARD:
            PICTURES.mkdir(parents=True, exist_ok=True)
            run([BIN / "compare_images", kinds[first][0][0], kinds["guided"][0][0], "--side-by-side",
                 PICTURES / f"{scene}.png"])
        cells = [f"{errors[kind]:.3g} ({made[0][1]} passes; {made[0][2]} stated)"
                 for kind, made in kinds.items()]
        noise = arithmetic.noise_of(halves)
        return [scene, *cells, f"{errors[first] / errors['guided']:.2f}", f"{noise:.2g}",
                datetime.date.today().isoformat()]


def kept_rows(scenes):
    """The rows of the page that are of other scenes."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    return [row for row in rows if row[0] in HARD + PRESENT and row[0] not in scenes]


def page(options, rows):
    """The text of the page."""
    kinds = (["before"] if options.before else []) + ["by power", "guided"]
    lines = [
        "# What does guided emission gain?", "",
        "Written by `bench/guided_emission.py`; do not edit.", "",
        f"relMSE ([error.md](error.md) (3)) of images {options.size} pixels wide after "
        f"{options.seconds:g} s on all cores, the mean of {options.seeds} seed{'s'[:options.seeds > 1]}; passes "
        f"and stated error of the first. References are two of {options.reference / 2:g} s, of other seeds and "
        f"`--neighbours {FEW}`, so of less bias. One factor of each square is against each of them: "
        "their noise, in the last column, is not in the figures. "
        "[light_transport.md](light_transport.md) (41) says how paths are guided.",
        *(["`before` is the version without guides, and with the weights of (21) before (42). In the other "
            "columns gather rays are guided, (43)."]
          if options.before else []),
        "", "| scene | " + " | ".join(kinds) + f" | {kinds[0]} over guided | noise | run on |",
        "| --- |" + " --- |" * (len(kinds) + 3)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    lines += ["", f"Each picture: {kinds[0]}, and guided, after the same time.", ""]
    for row in rows:
        if row[0] in HARD:
            lines += [f"![{row[0]}](images/guided/{row[0]}.png)", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", default=HARD + PRESENT)
    parser.add_argument("--before", type=pathlib.Path, help="folder of another build's programs")
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--reference", type=float, default=150, help="seconds of references")
    parser.add_argument("--seeds", type=int, default=1, help="images of each kind")
    parser.add_argument("--size", type=int, default=192, help="pixels across")
    parser.add_argument("--keep", action="store_true", help="keep the rows of other scenes")
    options = parser.parse_args()
    rows = kept_rows(options.scenes) if options.keep else []
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(options, folder)
        for scene in options.scenes:
            rows.append(lab.row(scene))
            print("| " + " | ".join(rows[-1]) + " |", flush=True)
    order = [*HARD, *PRESENT, *options.scenes]
    rows.sort(key=lambda row: order.index(row[0]))
    PAGE.write_text(page(options, rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
