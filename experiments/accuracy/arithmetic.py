"""Errors of images, and curves of error against time.

An image is (width, numbers): rows from the bottom, three numbers a pixel, linear."""

import array
import math
import sys


def read_pfm(path):
    """A colour PFM of little-endian numbers."""
    with open(path, "rb") as file:
        if file.readline() != b"PF\n":
            raise ValueError(f"{path}: not a colour PFM")
        width, height = map(int, file.readline().split())
        if float(file.readline()) >= 0:
            raise ValueError(f"{path}: not little endian")
        numbers = array.array("f", file.read(12 * width * height))
    if sys.byteorder == "big":
        numbers.byteswap()
    return width, numbers


def write_pfm(path, image):
    """Writes what read_pfm reads."""
    width, numbers = image
    out = array.array("f", numbers)
    if sys.byteorder == "big":
        out.byteswap()
    with open(path, "wb") as file:
        file.write(b"PF\n%d %d\n-1\n" % (width, len(out) // (3 * width)))
        file.write(out.tobytes())


def mean_image(images):
    """Of images of the same size."""
    return images[0][0], [sum(values) / len(images)
                          for values in zip(*(numbers for _, numbers in images))]


def taps(size):
    """[[(index, weight)]] by index of the line half as long: a quadratic B-spline is made of four
    of half its width.  At an end, of those that there are."""
    out = []
    for first in range(-1, size - 1, 2):
        found = [(first + i, weight) for i, weight in enumerate((1, 3, 3, 1))
                 if 0 <= first + i < size]
        total = sum(weight for _, weight in found)
        out.append([(i, weight / total) for i, weight in found])
    return out


def halved(image):
    """The image by half as many pixels across, of one filtered by a quadratic B-spline.  Width and
    height are even."""
    width, numbers = image
    line = 3 * width
    across, down = taps(width), taps(len(numbers) // line)
    out = array.array("d")
    for rows in down:
        mixed = [sum(weight * numbers[row * line + i] for row, weight in rows)
                 for i in range(line)]
        for columns in across:
            for channel in range(3):
                out.append(sum(weight * mixed[3 * i + channel] for i, weight in columns))
    return width // 2, out


def weights(halves, constant=None):
    """1/(r² + c) of docs/error.md (3), r the mean of the halves of the reference.  constant: c, if
    another."""
    means = [(a + b) / 2 for a, b in zip(halves[0][1], halves[1][1])]
    if constant is None:
        constant = (0.1 * sum(means) / len(means)) ** 2
    return [1 / (mean * mean + constant) for mean in means]


def relative_mse(image, halves, constant=None):
    """relMSE of docs/error.md (3) against a reference of two independent halves of one expectation:
    one factor of each square is against each half, so that their noise averages out.  Below zero
    by chance, if the error is small beside that noise."""
    total = sum(w * (x - a) * (x - b) for w, x, a, b in
                zip(weights(halves, constant), image[1], halves[0][1], halves[1][1]))
    return total / len(image[1])


def noise_of(halves):
    """relMSE that is noise, of the mean of the halves."""
    total = sum(w * (a - b) ** 2 for w, a, b in
                zip(weights(halves), halves[0][1], halves[1][1]))
    return total / 4 / len(halves[0][1])


def mean_curve(runs, column=2):
    """[(seconds, error, its standard error, passes)] of the runs of some seeds, each [(passes,
    seconds, relMSE, ...)] at the same passes, by the relMSE in that column.  Where the mean relMSE
    is not above zero the reference does not tell the error, and there is no point."""
    curve = []
    for points in zip(*runs):
        squares = [point[column] for point in points]
        mean = sum(squares) / len(squares)
        if mean <= 0:
            continue
        spread = math.sqrt(sum((square - mean) ** 2 for square in squares) /
                           (max(1, len(squares) - 1) * len(squares)))
        error = math.sqrt(mean)
        seconds = sum(point[1] for point in points) / len(points)
        curve.append((seconds, error, spread / (2 * error), points[0][0]))
    return curve


def between(x, left, right):
    """y of a straight line in logarithms through two points (x, y), at x."""
    (x0, y0), (x1, y1) = left, right
    return y0 * math.exp(math.log(y1 / y0) * math.log(x / x0) / math.log(x1 / x0))


def seconds_to(curve, error):
    """When the error is first met; None: not as far as the curve goes.  Where the first point's error
    is smaller, its time: it does not go quicker."""
    if curve and curve[0][1] <= error:
        return curve[0][0]
    for (t0, e0, *_), (t1, e1, *_) in zip(curve, curve[1:]):
        if e0 > error >= e1:
            return between(error, (e0, t0), (e1, t1))
    return None


def error_after(curve, seconds, beyond=1.25):
    """Error after so many seconds; the last line goes on to `beyond` times its end.  None: not
    known."""
    if len(curve) < 2 or not curve[0][0] <= seconds <= beyond * curve[-1][0]:
        return None
    for left, right in zip(curve, curve[1:]):
        if seconds <= right[0] or right is curve[-1]:
            return between(seconds, left[:2], right[:2])
    return None
