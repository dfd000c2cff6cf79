"""What the stages of an image of any size take, by what was measured of small ones."""

import statistics

from stages import Stages

# Of render/film/film.h: the sums of a pixel, of which photon maps have images by narrower radii.
FILM_BYTES_OF_PIXEL = 384

# What each stage grows with: a constant (0), millions of pixels (1), millions of photons (2).
OF_RENDERS = {"load": (0,), "start": (0, 1), "film": (0, 1), "write": (0, 1), "photons": (0, 2), "maps": (0, 2),
              "pilots": (0, 1, 2), "image": (0, 1, 2)}
OF_STATES = {name: (0, 1) for name in ("read", "save", "merge", "merge_begin", "add", "state_bytes")}


def solved(matrix, values):
    """x of matrix x = values, by elimination; the matrix is small and symmetric.  None if it is singular."""
    rows = [[*row, value] for row, value in zip(matrix, values)]
    for i, row in enumerate(rows):
        if row[i] <= 1e-9 * matrix[i][i]:
            return None
        for other in rows[i + 1:]:
            share = other[i] / row[i]
            other[:] = [a - share * b for a, b in zip(other, row)]
    found = []
    for i in reversed(range(len(rows))):
        known = sum(a * b for a, b in zip(reversed(rows[i][i + 1:-1]), found))
        found.append((rows[i][-1] - known) / rows[i][i])
    return found[::-1]


def fit(rows, values):
    """Weights of the numbers of each row, of which none is negative, with the least relative error."""
    used = list(range(len(rows[0])))
    while used:
        scaled = [[row[i] / value for i in used] for row, value in zip(rows, values)]
        matrix = [[sum(row[i] * row[j] for row in scaled) for j in range(len(used))] for i in range(len(used))]
        found = solved(matrix, [sum(row[i] for row in scaled) for i in range(len(used))])
        if found is None:  # points that do not differ say nothing more
            used.pop()
            continue
        if min(found) >= 0:
            weights = dict(zip(used, found))
            return [weights.get(i, 0) for i in range(len(rows[0]))]
        used.remove(used[found.index(min(found))])
    return [0] * len(rows[0])


def law(points, values, columns):
    """A function of a point: a constant, pixels and photons in millions."""
    kept = [([point[i] for i in columns], value) for point, value in zip(points, values) if value > 0]
    weights = fit(*zip(*kept)) if kept else [0] * len(columns)
    return lambda point: sum(weight * point[i] for weight, i in zip(weights, columns))


class Model:
    """The laws of the stages of one scene.  measured: of docs/scaling/measured.json."""

    def __init__(self, measured, scene):
        points = measured["about"]["study"]["points"]
        stages = measured["runs"][f"checked/{scene}"]["stages"]
        found = [stages[f"{size}/{photons}"] for size, photons in points]
        sums = [measured["runs"][f"sums/{scene}/{size}"] for size, _ in points]
        chosen = [run for run, (_, photons) in zip(found, points) if photons == 0] or found
        self.least_photons = min(run["photons_of_pass"] for run in chosen)
        # Of pilots, the part that processes share.
        self.shared = min(1, statistics.mean(one["shared_pilots"] / run["pilots"] for one, run in zip(sums, found)
                                             if run in chosen))
        self.photons_of_pixel = chosen[-1]["photons_of_pass"] / chosen[-1]["pixels"]
        at = [(1, run["pixels"] / 1e6, run["photons_of_pass"] / 1e6) for run in found]
        self.laws = {name: law(at, [run[name] for run in rows], columns)
                     for rows, stages in ((found, OF_RENDERS), (sums, OF_STATES))
                     for name, columns in stages.items()}

    def photons(self, pixels):
        """Those of a pass that render chooses."""
        return max(self.least_photons, self.photons_of_pixel * pixels)

    def stages(self, pixels):
        point = (1, pixels / 1e6, self.photons(pixels) / 1e6)
        found = {name: of(point) for name, of in self.laws.items()}
        return Stages(**found, shared_pilots=self.shared * found["pilots"], film_bytes=FILM_BYTES_OF_PIXEL * pixels)
