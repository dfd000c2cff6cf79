"""A plot whose both axes are logarithmic, as SVG."""

import math

from markup import element, escape

WIDTH, HEIGHT = 560, 360
LEFT, RIGHT, TOP, BOTTOM = 58, 14, 14, 44


class Axes:
    """x, y: least and largest value of each axis, above zero."""

    def __init__(self, x, y):
        self.x, self.y = x, y

    def across(self, value):
        return LEFT + (WIDTH - LEFT - RIGHT) * share(value, self.x)

    def up(self, value):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * share(value, self.y)

    def point(self, x, y):
        return f"{self.across(x):.1f},{self.up(y):.1f}"

    def points(self, pairs):
        return " ".join(self.point(x, y) for x, y in pairs)

    def line(self, pairs, name, **attributes):
        return element("polyline", points=self.points(pairs), class_=name, **attributes)

    def grid(self, x_ticks, y_ticks):
        """Ticks: values and what is written at them."""
        lines, words = [], []
        for value, text in x_ticks:
            at = f"{self.across(value):.1f}"
            lines.append(element("line", x1=at, x2=at, y1=TOP, y2=HEIGHT - BOTTOM))
            words.append(element("text", escape(text), x=at, y=HEIGHT - BOTTOM + 18,
                                 text_anchor="middle"))
        for value, text in y_ticks:
            at = f"{self.up(value):.1f}"
            lines.append(element("line", x1=LEFT, x2=WIDTH - RIGHT, y1=at, y2=at))
            words.append(element("text", escape(text), x=LEFT - 8, y=at, text_anchor="end",
                                 dominant_baseline="middle"))
        return (element("g", "".join(lines), class_="grid") +
                element("g", "".join(words), class_="ticks"))


def share(value, ends):
    low, high = math.log(ends[0]), math.log(ends[1])
    return (math.log(value) - low) / (high - low)


def padded(values, factor):
    """Ends of an axis that holds the values, and a decade's third at least."""
    low, high = min(values) / factor, max(values) * factor
    middle = math.sqrt(low * high)
    return min(low, middle / 1.5), max(high, middle * 1.5)


def round_values(ends, steps):
    """The values step * 10^n within the ends."""
    first, last = (math.floor(math.log10(end)) for end in ends)
    return [step * 10.0 ** power for power in range(first, last + 1) for step in steps
            if ends[0] <= step * 10.0 ** power <= ends[1]]


def finest(choices, most):
    """The longest of the lists with at most so many values."""
    return max([choice for choice in choices if len(choice) <= most], key=len, default=[])
