"""What a long run says on standard error while it goes on."""

import sys
import time


class Progress:
    """Says what was done and how long the rest takes.

    total: number of steps.  weight: of all steps together, in any unit; 0: all weigh the same."""

    def __init__(self, total, weight=0):
        self.start = time.monotonic()
        self.total, self.weight = total, weight or total
        self.done, self.done_weight = 0, 0

    def skip(self, count, weight):
        """Leaves out steps.  weight: of them together."""
        self.total -= count
        self.weight -= weight

    def ran(self, text, weight=1):
        """After each step.  weight: of this step."""
        self.done += 1
        self.done_weight += weight
        left = (time.monotonic() - self.start) * (self.weight / self.done_weight - 1)
        print(f"[{self.done}/{self.total}] {text}; about {max(0, left) / 60:.1f} min left",
              file=sys.stderr, flush=True)
