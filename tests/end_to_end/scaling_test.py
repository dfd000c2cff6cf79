"""experiments/scaling simulates what closed forms say.

    scaling_test.py ROOT
"""

import dataclasses
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = sys.argv[1]
FOLDER = os.path.join(ROOT, "experiments/scaling")
sys.path.insert(0, FOLDER)
import farm
import measure  # finds turns
import model
import page
import ranks
import scenario
from farm import Plan, simulate_farm
from ranks import simulate_ranks
from stages import Cluster, Stages
from turns import Turn, in_turns, members

STAGES = Stages(start=0.1, load=0.4, pilots=1.5, photons=0.2, maps=0.3, image=1.4, film=0.1, save=0.3,
                read=0.2, write=0.25, add=0.05, merge_begin=0.6, merge=0.15, state_bytes=3e8)
SETUP, PASS = 2.0, 2.0
HARD = Cluster(machines=40, spread=0.2, slow_share=0.1, slow_speed=0.5, failures_per_hour=6, replace_s=20,
               queue_s=1, network=1e9, storage=4e9)
EASY = dataclasses.replace(HARD, failures_per_hour=0)


class ByMpi(unittest.TestCase):
    def test_one_machine_takes_the_sum_of_its_stages(self):
        found = simulate_ranks(STAGES, 20, Cluster(), keeps_states=False)
        # One round of 20 passes, after which the image is written, and once more at the end.
        self.assertEqual(found.rounds, 1)
        self.assertAlmostEqual(found.seconds, SETUP + 20 * PASS + 2 * STAGES.write)

    def test_equal_machines_take_whole_turns_of_passes_and_the_serial_part(self):
        for machines, passes in ((4, 20), (4, 21), (7, 20), (32, 20)):
            found = simulate_ranks(STAGES, passes, Cluster(machines=machines))
            turns = math.ceil(passes / machines)
            adding = math.ceil(math.log2(machines)) * STAGES.add
            serial = SETUP + adding + STAGES.save + 2 * STAGES.write
            self.assertEqual(found.rounds, 1)
            self.assertAlmostEqual(found.seconds, serial + turns * PASS)

    def test_machines_share_a_part_of_the_pilots(self):
        stages = dataclasses.replace(STAGES, shared_pilots=1.2)
        for machines in (1, 4):
            found, alike = (simulate_ranks(of, 8, Cluster(machines=machines)) for of in (stages, STAGES))
            self.assertAlmostEqual(alike.seconds - found.seconds, 1.2 * (1 - 1 / machines))
            self.assertAlmostEqual(found.spent["pilots"], machines * 1.5 - 1.2 * (machines - 1))

    def test_a_round_ends_after_30_passes_of_a_machine(self):
        found = simulate_ranks(STAGES, 2 * 31 * 8, Cluster(machines=8))
        # The pass that begins as the 30 end is of the round.
        self.assertEqual(found.rounds, 2)

    def test_looks_at_the_error_end_rounds(self):
        # After 4, 6, 8, 11, 16, 23 and 32 passes: the numbers of docs/statistics.md.
        numbers, passes = [], 0
        while passes < 32:
            passes = ranks.next_check(passes)
            numbers.append(passes)
        self.assertEqual(numbers, [4, 6, 8, 11, 16, 23, 32])
        found = simulate_ranks(STAGES, 32, Cluster(machines=16), checks=True)
        self.assertEqual(found.rounds, len(numbers))

    def test_a_fast_machine_renders_more_passes(self):
        class Two(Cluster):
            def speeds(self):
                return [1, 3]
        found = simulate_ranks(STAGES, 8, Two(machines=2), keeps_states=False)
        # All load as slowly as the slowest.  The fast one renders 5 passes until the slow one has
        # rendered two, and the sixth: 8 passes in three turns of the slow one or less.
        setup = 0.5 + 1.5
        self.assertLess(found.seconds, setup + 3 * PASS + STAGES.add + 2 * STAGES.write)
        self.assertGreaterEqual(found.seconds, setup + 2 * PASS + STAGES.add + 2 * STAGES.write)

    def test_a_run_of_failures_ends_with_all_passes_or_is_given_up(self):
        seldom = dataclasses.replace(HARD, failures_per_hour=0.2)
        found = simulate_ranks(STAGES, 6000, seldom)
        self.assertEqual(found.kept, 6000)
        self.assertGreater(found.failures, 0)
        # With a failure every 15 s no round of 30 passes is ever whole.
        self.assertEqual(simulate_ranks(STAGES, 6000, HARD).seconds, math.inf)


class ByTasks(unittest.TestCase):
    def test_one_machine_takes_the_sum_of_its_stages(self):
        found = simulate_farm(STAGES, Plan(20, 20), Cluster())
        # A state is saved when that takes 2 % of the time: after every 8 passes of 2 s, and at the end.
        self.assertAlmostEqual(found.seconds, SETUP + 20 * PASS + 3 * STAGES.save +
                               STAGES.merge_begin + STAGES.merge)

    def test_equal_machines_take_whole_turns_of_tasks_and_the_merge(self):
        for machines, passes in ((4, 80), (7, 80), (32, 80)):
            found = simulate_farm(STAGES, Plan(passes, 4), Cluster(machines=machines, queue_s=3))
            tasks = passes // 4
            turns = math.ceil(tasks / machines)
            merge = 3 + STAGES.merge_begin + tasks * STAGES.merge
            self.assertAlmostEqual(found.seconds,
                                   turns * (3 + SETUP + 4 * PASS + STAGES.save) + merge)

    def test_a_tile_costs_its_pixels_and_all_photons(self):
        tile = simulate_farm(STAGES, Plan(4, 4, tiles=10), Cluster(machines=10))
        one_pass = 0.2 + 0.3 + (1.4 + 0.1) / 10
        merge = STAGES.merge_begin + 10 * STAGES.merge / 10
        saves = 2 * STAGES.save / 10  # after 3 passes, and at the end
        self.assertAlmostEqual(tile.seconds, SETUP + 4 * one_pass + saves + merge)

    def test_a_tree_of_merges_takes_a_level_after_the_other(self):
        merged = lambda states, fan_in: farm.merge_seconds(STAGES, Cluster(machines=64), states, 1, fan_in)
        one = lambda states: STAGES.merge_begin + states * STAGES.merge
        self.assertAlmostEqual(merged(64, 0), one(64))
        self.assertAlmostEqual(merged(64, 8), 2 * one(8))
        self.assertAlmostEqual(merged(64, 4), 3 * one(4))
        # The folder of all gives each of 8 an eighth of what it has: 8 x 3e8 bytes at 8e8 bytes/s.
        shared = Cluster(machines=64, storage=8e8)
        each = 8 * 3e8 / 8e8
        self.assertAlmostEqual(farm.merge_once(STAGES, shared, 8, 1, 8),
                               STAGES.merge_begin + 8 * each + each)

    def test_failures_lose_no_pass_and_cost_what_was_not_saved(self):
        plan = Plan(4000, 16)
        found, quiet = simulate_farm(STAGES, plan, HARD), simulate_farm(STAGES, plan, EASY)
        self.assertAlmostEqual(found.kept, 4000)
        self.assertAlmostEqual(quiet.kept, 4000)
        self.assertEqual(quiet.failures, 0)
        self.assertEqual(quiet.spent.get("lost", 0), 0)
        # Failures come at the rate told, in the time that machines work: a Poisson number.
        working = sum(found.spent[name] for name in ("queue", "load", "pilots", "passes", "save"))
        expected = 6 / 3600 * (working + found.spent["lost"] - 20 * found.failures)
        self.assertLess(abs(found.failures - expected), 4 * math.sqrt(expected))
        # Each loses the time to replace the machine, and a saved group of passes or the setup at most.
        most = 20 + 1 + (8 * PASS + STAGES.save) / 0.3
        self.assertLess(found.spent["lost"], most * found.failures)


class Both(unittest.TestCase):
    def found(self, cluster):
        return [simulate_ranks(STAGES, 500, cluster), simulate_ranks(STAGES, 500, cluster, checks=True),
                simulate_farm(STAGES, Plan(500, 8, tiles=2, fan_in=8), cluster)]

    def test_the_time_of_all_machines_is_accounted_for(self):
        for cluster in (EASY, HARD):
            for found in self.found(cluster):
                self.assertAlmostEqual(found.kept, 500)
                self.assertAlmostEqual(sum(found.spent.values()) / (40 * found.seconds), 1)

    def test_the_seed_makes_the_outcome(self):
        self.assertEqual(self.found(HARD), self.found(HARD))
        other = self.found(dataclasses.replace(HARD, seed=1))
        for one, two in zip(self.found(HARD), other):
            self.assertNotEqual(one.seconds, two.seconds)

    def test_threads_divide_what_render_divides(self):
        several = STAGES.by_cores(4)
        self.assertAlmostEqual(several.one_pass(), (0.2 + 0.3 + 1.4) / 4 + 0.1)
        self.assertAlmostEqual(several.setup(), 0.5 + 1.5 / 4)


class InTurns(unittest.TestCase):
    """Jobs are stopped with the programs that they start while others have their turn."""

    @staticmethod
    def steps(number):
        """A job that says when a program of its own made each of so many steps."""
        text = f"import time\nfor i in range({number}):\n    time.sleep(0.002)\n    print(time.monotonic())"
        def job():
            done = subprocess.run([sys.executable, "-c", text], check=True, capture_output=True, text=True)
            return [float(line) for line in done.stdout.split()]
        return job

    def test_one_runs_at_a_time(self):
        begun = time.monotonic()
        turns = in_turns([self.steps(100), self.steps(150)], 0.05)
        took = time.monotonic() - begun
        self.assertEqual([len(turn.result) for turn in turns], [100, 150])
        owners = [owner for _, owner in sorted((at, i) for i, turn in enumerate(turns) for at in turn.result)]
        changes = sum(one != two for one, two in zip(owners, owners[1:]))
        self.assertGreaterEqual(changes, 3)
        self.assertLessEqual(changes, 2 * took / 0.05)
        self.assertLessEqual(sum(turn.seconds() for turn in turns), took)

    def test_seconds_between_two_times_are_those_in_which_it_ran(self):
        turn = Turn(None, None, ran=[(1, 2), (4, 6)])
        self.assertEqual([turn.seconds(), turn.seconds(1.5, 5), turn.seconds(2, 4), turn.seconds(5)], [3, 1.5, 0, 1])

    def test_a_job_that_fails_ends_all(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "process")
            def endless():
                with subprocess.Popen(["sleep", "1000"]):
                    file.write_text(str(os.getsid(0)), encoding="utf-8")
            def fails():
                while not file.exists():
                    time.sleep(0.001)
                os._exit(1)
            with self.assertRaises(SystemExit):
                in_turns([endless, fails], 0.05)
            session = int(file.read_text(encoding="utf-8"))
            for _ in range(1000):
                if not members(session):
                    break
                time.sleep(0.01)
            self.assertEqual(members(session), [])


TOOL = """#!/bin/sh
while [ $# -gt 0 ]; do
    case "$1" in
        --stats) cp "$(dirname "$0")/stats.json" "$2"; shift;;
        -o|--state) echo > "$2"; shift;;
    esac
    shift
done
"""
MPIRUN = """#!/bin/sh
while [ "${1##*/}" != render ]; do shift; done
exec "$@"
"""
STATS = {"processor_seconds": {"process": 9, "scene": 0.2, "rays": 0.1, "pilots": 2, "photons": 1, "maps": 1, "image": 3,
                               "film": 0.5, "previews": 0.5, "write": 0.25, "state": 0,
                               "add": 0.1},
         "rounds": 2, "image": {"width": 24, "height": 16},
         "options": {"photons": 1000, "samples": 4}, "error": {"law": {}}}


class Scripts(unittest.TestCase):
    """scale.py with programs that do nothing, and what page.py writes by it and by docs/scaling."""

    def measured(self, folder, *options, file="measured.json"):
        for name, text in (("preprocess", TOOL), ("render", TOOL), ("mpirun", MPIRUN)):
            (folder / name).write_text(text)
            (folder / name).chmod(0o755)
        (folder / "stats.json").write_text(json.dumps(STATS))
        subprocess.run([sys.executable, "-B", os.path.join(FOLDER, "scale.py"), *options, "--scenes", "cornell",
                        "--tools", folder, "--work", folder / "work", "--to", folder], check=True,
                       stderr=subprocess.DEVNULL, env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"})
        return json.loads((folder / "scaling" / file).read_text())

    def test_what_is_measured_makes_a_section(self):
        with tempfile.TemporaryDirectory() as folder:
            measured = self.measured(pathlib.Path(folder), "--quick")
        stages = model.Model(measured, "cornell").stages(24 * 16)
        self.assertAlmostEqual(stages.load, 0.3)
        self.assertAlmostEqual(stages.pilots, 2)
        self.assertAlmostEqual(stages.image, 3 / measured["about"]["study"]["passes"])
        self.assertEqual(stages.film_bytes, 384 * 24 * 16)
        text, found = page.section(measured, scenario.Image("cornell", 64, 48, 8), (1, 4))
        self.assertEqual(list(found.tiles), [1, 4])
        self.assertIn("| cornell | 2 |", text)

    def test_all_cores_are_compared_with_one_for_the_same_passes(self):
        with tempfile.TemporaryDirectory() as folder:
            measured = self.measured(pathlib.Path(folder), "--processes", "2", "4", "--passes", "3",
                                     file="measured_4.json")
        checks = measured["runs"]["checked/cornell"]["checks"]
        self.assertEqual([(check["processes"], check["passes"]) for check in checks], [(1, 3), (2, 6), (4, 12)])
        passes = 1 + 1 + 3 + 0.5  # of STATS
        for check in checks[1:]:
            self.assertAlmostEqual(check["alone"] - checks[0]["alone"], (check["processes"] - 1) * passes)
        self.assertIn("| cornell | 4 | 12 |", page.section_of_all_cores(measured))

    def test_more_machines_are_no_slower_by_tasks(self):
        with open(os.path.join(ROOT, "docs/scaling/measured.json"), encoding="utf-8") as file:
            measured = json.load(file)
        _, found = page.section(measured, scenario.Image(width=640, height=480, passes=32), (1, 4, 16))
        one, four, many = (found.tiles[n].out.seconds for n in (1, 4, 16))
        self.assertLess(four, one)
        self.assertLess(many, four)

    def test_a_fit_finds_the_weights_and_none_below_zero(self):
        rows = [(1, 1, 2), (1, 4, 3), (1, 9, 1), (1, 2, 7)]
        found = model.fit(rows, [0.5 + 2 * a + 3 * b for _, a, b in rows])
        for weight, expected in zip(found, (0.5, 2, 3)):
            self.assertAlmostEqual(weight, expected)
        self.assertEqual(model.fit([(1, 1), (1, 2), (1, 3)], [3, 2, 1])[1], 0)

    def test_only_the_section_is_replaced(self):
        text = "a\n<!-- scaling -->\nold\n<!-- end -->\nb\n<!-- end -->\n"
        self.assertEqual(page.replace_section(text, "new"),
                         "a\n<!-- scaling -->\nnew\n<!-- end -->\nb\n<!-- end -->\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
