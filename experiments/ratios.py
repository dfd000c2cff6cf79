"""Ratios of costs that were measured in rounds, and their 95 % confidence intervals."""

import dataclasses
import functools
import math
import statistics

from student import student_limit

CHANCE = 0.05  # probability that an interval misses the true ratio
MOST_LOG = 300.0  # of a bound: math.exp takes it

limit = functools.lru_cache(maxsize=None)(student_limit)


@dataclasses.dataclass(frozen=True)
class Ratio:
    """log: mean logarithm of the rounds' ratios.  error: its standard error.  freedom: degrees of
    freedom of that; 0: there was one round, and the interval is unknown."""

    log: float
    error: float
    freedom: int

    @property
    def value(self):
        return math.exp(self.log)

    def half(self, chance=CHANCE):
        """Half the interval of the logarithm."""
        if self.freedom == 0:
            return MOST_LOG
        return min(MOST_LOG, self.error * limit(chance, self.freedom))

    def bounds(self, chance=CHANCE):
        half = self.half(chance)
        return (math.exp(max(-MOST_LOG, self.log - half)), math.exp(min(MOST_LOG, self.log + half)))

    def over(self, other):
        """This ratio over another one, of other rounds."""
        return Ratio(self.log - other.log, math.hypot(self.error, other.error),
                     min(self.freedom, other.freedom))

    def exceeds(self, threshold):
        """Whether it is above the threshold; None where the interval contains that."""
        low, high = self.bounds()
        return True if low > threshold else False if high < threshold else None


def of_rounds(above, below):
    """The ratio of costs that were measured in the same rounds; None if a cost is lost in noise, as
    it is not above zero."""
    if not above or min(*above, *below) <= 0:
        return None
    logs = [math.log(a / b) for a, b in zip(above, below)]
    error = statistics.stdev(logs) / math.sqrt(len(logs)) if len(logs) > 1 else 0.0
    return Ratio(statistics.mean(logs), error, len(logs) - 1)


def mean_cost(costs):
    """The mean whose ratios are those of `of_rounds`."""
    return statistics.geometric_mean(costs) if min(costs) > 0 else statistics.mean(costs)


def written(ratio, digits=2):
    if ratio is None:
        return "lost in noise"
    if ratio.freedom == 0:
        return f"{ratio.value:.{digits}f} (one round)"
    low, high = ratio.bounds()
    return f"{ratio.value:.{digits}f} ({low:.{digits}f} to {high:.{digits}f})"
