"""farm/hipmap.sbatch with stand-ins for Slurm's programs, which run each job at once: its tasks, of which one
fails and one is lost, make the image of one render.  farm/test_slurm.sh does so under a real Slurm.

    slurm_test.py FOLDER_OF_TOOLS ROOT
"""

import os
import stat
import subprocess
import sys
import tempfile
import unittest

TOOLS, ROOT = sys.argv[1:3]
SCENE = os.path.join(ROOT, "assets/cornell.glb")
OPTIONS = ["--size", "12x8", "--photons", "500"]

# Runs the tasks of an array, or a single job, at once; a task that asked to be queued again runs again.
SBATCH = """
words=() array= log=/dev/null
for word in "$@"; do
    case $word in
    --array=*) array=${word#*=} ;;
    --output=*) log=${word#*=} ;;
    --*) ;;
    *) words+=("$word") ;;
    esac
done
echo 7
exec >/dev/null
export SLURM_JOB_ID=7 SLURM_ARRAY_JOB_ID=7
if [[ -z $array ]]; then bash "${words[@]}" >>"$log" 2>&1 || true; exit 0; fi
[[ $array != *-* ]] || array=$(seq -s, "${array%-*}" "${array#*-}")
for n in ${array//,/ }; do
    for restart in 0 1 2 3 4 5 6; do
        rm -f "$STAND_IN/again"
        SLURM_ARRAY_TASK_ID=$n SLURM_RESTART_COUNT=$restart bash "${words[@]}" \
            >>"${log/\\%a/$n}" 2>&1 || true
        [[ -e $STAND_IN/again ]] || break
    done
done
"""
# The render of task 1 is killed once, that of task 2 is lost with its job.
SRUN = """
shift
if [[ $* == */1.state* && ! -e $STAND_IN/1 ]]; then touch "$STAND_IN/1"; exit 137; fi
if [[ $* == */2.state* && ! -e $STAND_IN/2 ]]; then touch "$STAND_IN/2"; kill -KILL $PPID; exit 137; fi
exec "$@"
"""
STAND_INS = {"sbatch": SBATCH, "srun": SRUN, "scontrol": 'touch "$STAND_IN/again"\n', "sleep": ":\n"}


class Slurm(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        os.mkdir(self.path("bin"))
        for name, text in STAND_INS.items():
            with open(self.path("bin", name), "w", encoding="utf-8") as file:
                file.write("#!/usr/bin/env bash\n" + text)
            os.chmod(self.path("bin", name), stat.S_IRWXU)
        self.tool("preprocess", "-o", self.path("a.hpm"))

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def tool(self, name, *arguments):
        subprocess.run([os.path.join(TOOLS, name), SCENE, *arguments], stderr=subprocess.DEVNULL, check=True)

    def content(self, *names):
        with open(self.path(*names), "rb") as file:
            return file.read()

    def submit(self, *options, code=0):
        environment = {**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"],
                       "RENDER": os.path.join(TOOLS, "render"), "STAND_IN": self.folder}
        done = subprocess.run([os.path.join(ROOT, "farm/hipmap.sbatch"), SCENE, self.path("a.hpm"), "-o",
                               self.path("a.pfm"), "--to", self.path("farm"), *options],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment,
                              check=False)
        self.assertEqual(done.returncode, code, done.stdout)
        return done.stdout

    def test_tasks_that_fail_or_are_lost_are_rendered_again(self):
        self.tool("render", self.path("a.hpm"), "-o", self.path("one.pfm"), "--passes", "5", *OPTIONS)
        options = "--passes", "5", "--chunk", "3", "--tiles", "2x1"
        self.submit(*options, "--", *OPTIONS)
        self.assertEqual(self.content("a.pfm"), self.content("one.pfm"))
        self.assertIn(b"queued again", self.content("farm/logs/task-1.log"))
        self.assertIn(b"tasks without a result: 2", self.content("farm/logs/merge.log"))
        said = self.submit(*options, "--", *OPTIONS, "--seed", "1", code=2)
        self.assertIn("holds the states of another render", said)

    def test_it_stops_at_an_error(self):
        self.submit("--passes", "60", "--chunk", "2", "--error", "90%", "--", *OPTIONS)
        self.assertNotIn(b"reached", self.content("farm/logs/task-0.log"))  # 2 passes: not known yet
        self.assertIn(b"error of 90 % reached", self.content("farm/logs/task-1.log"))
        self.assertIn(b"not rendered", self.content("farm/logs/task-29.log"))
        self.assertIn(b"4 passes from 2 states", self.content("farm/logs/merge.log"))

    def test_what_makes_no_sense_is_refused(self):
        for options, naming in ((("--passes", "0"), "whole numbers"), (("--tiles", "2"), "COLUMNSxROWS"),
                                (("--error", "few"), "no error"), (("--huge",), "after --"),
                                (("--frames", "a"), "no range")):
            said = self.submit(*options, code=2)
            self.assertIn(naming, said)
            self.assertEqual(said.count("\n"), 1, said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
