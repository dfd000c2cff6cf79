"""What the stages of a render take, and on what machines it runs."""

import dataclasses
import random

# Stages that render divides among the threads of a process.
DIVIDED = ("pilots", "shared_pilots", "photons", "maps", "image")
# Stages whose work is in the pixels that a task renders.  The others are those of the whole image.
OF_PIXELS = ("image", "film", "save", "read", "merge")


@dataclasses.dataclass(frozen=True)
class Stages:
    """Seconds of one core.  photons, maps, image and film are of a pass."""

    start: float = 0  # of a process, in no stage
    load: float = 0  # scene, partition, ray tracing structure
    pilots: float = 0
    shared_pilots: float = 0  # the part of the pilots that processes by MPI divide
    photons: float = 0
    maps: float = 0
    image: float = 0
    film: float = 0
    save: float = 0  # writing a state
    read: float = 0  # reading a state
    write: float = 0  # images
    add: float = 0  # films of two processes
    merge_begin: float = 0  # of render merge, whatever the number of states
    merge: float = 0  # a state more
    state_bytes: float = 0
    film_bytes: float = 0  # the sums of a film, as MPI moves them

    def setup(self):
        return self.start + self.load + self.pilots

    def pilots_by(self, machines):
        """Of each machine, by MPI."""
        return self.pilots - self.shared_pilots * (1 - 1 / machines)

    def one_pass(self):
        return self.photons + self.maps + self.image + self.film

    def of_part(self, share):
        """The stages of a task that renders a share of the pixels."""
        parts = {name: share * getattr(self, name) for name in (*OF_PIXELS, "state_bytes")}
        return dataclasses.replace(self, **parts)

    def by_cores(self, cores):
        """The stages of a process with so many threads, of whose time none is lost."""
        return dataclasses.replace(self, **{name: getattr(self, name) / cores for name in DIVIDED})


@dataclasses.dataclass(frozen=True)
class Cluster:
    """machines: with a process each.  spread: standard deviation of the logarithm of their speeds.
    slow_share of them have slow_speed besides.  failures_per_hour: of a machine, which is replaced
    after replace_s.  queue_s: from a task's submission to its start.  ask_s: to get a pass by MPI.
    network and storage: bytes/s, of a machine and of the folder of all; 0: time for nothing."""

    machines: int = 1
    cores: int = 1
    spread: float = 0
    slow_share: float = 0
    slow_speed: float = 1
    failures_per_hour: float = 0
    replace_s: float = 0
    queue_s: float = 0
    ask_s: float = 0
    network: float = 0
    storage: float = 0
    seed: int = 0

    def speeds(self):
        """[machines]; 1: the core that was measured."""
        numbers = random.Random(f"speeds {self.seed}")
        def one():
            speed = 2.718281828459045 ** numbers.gauss(0, self.spread)
            return speed * (self.slow_speed if numbers.random() < self.slow_share else 1)
        return [one() for _ in range(self.machines)]

    def transfer(self, size, readers=1):
        """Seconds in which each of so many machines moves the bytes, to or from the folder of all."""
        by_network = size / self.network if self.network else 0
        return max(by_network, size * readers / self.storage if self.storage else 0)


class Failures:
    """When machines fail: at any moment with the same rate."""

    def __init__(self, cluster, name):
        self.numbers = random.Random(f"{name} {cluster.seed}")
        self.rate = cluster.failures_per_hour / 3600

    def within(self, machines=1):
        """Seconds until the first of so many fails."""
        rate = self.rate * machines
        return self.numbers.expovariate(rate) if rate > 0 else float("inf")


@dataclasses.dataclass
class Outcome:
    """spent: seconds of machines by what they did, which make up machines x seconds.  kept: passes in
    the image, counted in pixels of the whole."""

    seconds: float = 0
    kept: float = 0
    failures: int = 0
    rounds: int = 0
    spent: dict = dataclasses.field(default_factory=dict)

    def spend(self, name, seconds):
        self.spent[name] = self.spent.get(name, 0) + seconds

    def share(self, name):
        return self.spent.get(name, 0) / sum(self.spent.values())
