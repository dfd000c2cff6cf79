"""The limits of Student's distribution."""

import math


def student_limit(chance, freedom):
    """|t| that Student's distribution exceeds with this probability (two-sided): by bisection of the
    integral over x = t/sqrt(freedom + t²), by Simpson's rule."""
    def inside(limit):
        steps = 400
        top = math.atan(limit / math.sqrt(freedom))
        weights = [1 if i in (0, steps) else 4 if i % 2 else 2 for i in range(steps + 1)]
        area = sum(w * math.cos(i * top / steps) ** (freedom - 1)
                   for i, w in enumerate(weights)) * top / steps / 3
        whole = (math.sqrt(math.pi) * math.gamma(freedom / 2) / math.gamma((freedom + 1) / 2))
        return 2 * area / whole
    low, high = 0.0, 1e6
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if inside(middle) < 1 - chance else (low, middle)
    return high
