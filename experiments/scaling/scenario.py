"""The image and the machines that the simulations of docs/many_machines.md are of."""

import dataclasses

from farm import Plan, simulate_farm
from ranks import simulate_ranks
from stages import Cluster


@dataclasses.dataclass(frozen=True)
class Image:
    scene: str = "window_room"
    width: int = 1920
    height: int = 1080
    passes: int = 512

    def pixels(self):
        return self.width * self.height


# Bytes/s of networks: 8 bits a byte, of which a tenth is lost.
GIGABIT = 0.9e9 / 8
MACHINES = Cluster(cores=16, spread=0.05, ask_s=0.001, network=10 * GIGABIT, storage=40 * GIGABIT, queue_s=3)
COUNTS = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1000, 2500, 5000, 10_000)
TILES = (1, 2, 4, 8, 16)
FAN_INS = (0, 8)
# More tasks than this for each machine only add setups.
MOST_TURNS = 8


@dataclasses.dataclass(frozen=True)
class Choice:
    plan: Plan
    out: object


def with_machines(count, **changes):
    return dataclasses.replace(MACHINES, machines=count, **changes)


def by_mpi(stages, image, cluster, checks=False):
    return simulate_ranks(stages, image.passes, cluster, checks=checks)


def plans(image, machines, tiles):
    """Tasks of halves, quarters, .. of the passes and of the image: neither many more than machines nor many
    fewer, except where the passes of all tiles run out."""
    chunks = [2**i for i in range(image.passes.bit_length()) if 2**i <= image.passes]
    made = [Plan(image.passes, chunk, count, fan_in) for count in tiles for chunk in chunks
            for fan_in in FAN_INS]
    most = max(len(plan.tasks()) for plan in made)
    least = min(machines // MOST_TURNS, most // 4, image.passes // 2)
    return [plan for plan in made if least <= len(plan.tasks()) <= MOST_TURNS * machines]


def by_tasks(stages, image, cluster, tiles=TILES):
    """The quickest plan."""
    return min((Choice(plan, simulate_farm(stages, plan, cluster))
                for plan in plans(image, cluster.machines, tiles)), key=lambda choice: choice.out.seconds)


def limit(out):
    """What machines do most besides passes."""
    rest = {name: seconds for name, seconds in out.spent.items() if name != "passes"}
    return max(rest, key=rest.get)
