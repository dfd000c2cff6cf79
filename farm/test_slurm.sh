#!/usr/bin/env bash
# Runs farm/hipmap.sbatch under a real Slurm of one node, set up in a folder and taken down afterwards.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: farm/test_slurm.sh FOLDER_OF_TOOLS

Starts munged, slurmctld and slurmd (Debian: slurmctld, slurmd, slurm-client, munge) in a temporary
folder, as root, and checks that
  - an array of 20 tasks, one killed by scancel --signal=KILL and others by SIGKILL, merges into the bits of one render;
  - tiles do so too;
  - an array with --error ends tasks that are not needed;
  - bad input fails once and is not queued again.
A soak of some minutes; not part of ./test.sh.  The logs stay if it fails.
TEXT
}

[[ $# -eq 1 && $1 != -* ]] || { usage && exit 2; }
for program in munged slurmctld slurmd sbatch; do
    command -v "$program" >/dev/null || {
        echo "skipped: no $program (apt-get install slurmctld slurmd slurm-client munge)"
        exit 77
    }
done

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tools=$(realpath "$1")
work=$(mktemp -d /tmp/hipmap-slurm-XXXXXX)
chmod 755 "$work"
daemons=()

take_down() {
    local code=$?
    scancel --user "$(id -un)" 2>/dev/null || true
    sleep 1
    kill "${daemons[@]}" 2>/dev/null || true
    wait 2>/dev/null || true
    if [[ $code -eq 0 ]]; then rm -rf "$work"; else echo "failed; logs are in $work"; fi
    exit "$code"
}
trap take_down EXIT

start_cluster() {
    mkdir -p "$work"/{munge,ctld,slurmd}
    chmod 755 "$work/munge"
    dd if=/dev/urandom of="$work/munge/key" bs=128 count=1 status=none
    chmod 400 "$work/munge/key"
    munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
        --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed" \
        2>"$work/munge/out" &
    daemons+=($!)
    cat >"$work/slurm.conf" <<CONF
ClusterName=hipmap
SlurmctldHost=$(hostname)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CryptoType=crypto/munge
SlurmctldPort=26817
SlurmdPort=26818
StateSaveLocation=$work/ctld
SlurmdSpoolDir=$work/slurmd
SlurmctldPidFile=$work/ctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/ctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SchedulerParameters=sched_interval=2,batch_sched_delay=0,bf_interval=2
MinJobAge=300
NodeName=$(hostname) CPUs=4 State=UNKNOWN
PartitionName=all Nodes=$(hostname) Default=YES MaxTime=60 State=UP
CONF
    export SLURM_CONF=$work/slurm.conf
    slurmctld -D 2>"$work/ctld.out" &
    daemons+=($!)
    slurmd -D 2>"$work/slurmd.out" &
    daemons+=($!)
    for _ in $(seq 60); do
        sinfo --noheader --format=%t 2>/dev/null | grep -q idle && return 0
        sleep 0.5
    done
    echo "error: the node did not come up; see $work/*.log"
    return 1
}

# Waits until no job is left; each second it runs the rest of its arguments.
wait_for_jobs() {
    local deadline=$((SECONDS + $1))
    shift
    while [[ -n $(squeue --noheader --states=all --format=%T | grep -v -E 'COMPLETED|FAILED|CANCELLED|TIMEOUT' || true) ]]; do
        [[ $SECONDS -lt $deadline ]] || { squeue --states=all && return 1; }
        "$@"
        sleep 0.3
    done
}

state_of() { squeue --noheader --array --states=all --format='%K %T' | awk -v n="$1" '$1 == n { print $2 }' | tail -1; }

# Kills task 7 by Slurm once it runs, and a render of two others directly.
killed=() slurm_killed=
kill_some() {
    local n pid
    if [[ -z $slurm_killed && $(state_of 7) == RUNNING ]]; then
        scancel --signal=KILL "${job}_7" && slurm_killed=yes
        echo "scancel --signal=KILL ${job}_7"
    fi
    for n in 3 12; do
        [[ " ${killed[*]-} " == *" $n "* ]] && continue
        pid=$(pgrep -f -- "--state $to/states/$n.state" | tail -1 || true)
        [[ -z $pid ]] || { kill -KILL "$pid" 2>/dev/null && killed+=("$n") && echo "SIGKILL to the render of task $n"; }
    done
}

same() { cmp "$1" "$2" && echo "same bits: $(basename "$2")"; }

submit() { # FOLDER, options...
    to=$work/$1
    shift
    job=$(RENDER="$tools/render" "$here/hipmap.sbatch" "$scene" "$work/scene.hpm" --to "$to" \
        --sbatch=--cpus-per-task=1 -o "$to.pfm" "$@" | tee >(cat >&2) | awk '{ print $2 + 0 }')
}

start_cluster
sinfo --version
scene=$here/../assets/cornell.glb
options=(--size 64x48 --photons 20000 --threads 1)
"$tools/preprocess" "$scene" -o "$work/scene.hpm" 2>/dev/null
"$tools/render" "$scene" "$work/scene.hpm" "${options[@]}" --passes 160 -o "$work/whole.pfm" 2>/dev/null

echo "== an array of 20 tasks, three of them killed"
submit many --passes 160 --chunk 8 -- "${options[@]}"
wait_for_jobs 600 kill_some
[[ -n $slurm_killed ]] || { echo "error: task 7 was never seen running" && exit 1; }
grep -h -E "queued again|render ended|resuming|Killed" "$to"/logs/task-{3,7,12}.log || true
tail -n 4 "$to/logs/merge.log"
same "$work/whole.pfm" "$to.pfm"

echo "== tiles"
"$tools/render" "$scene" "$work/scene.hpm" "${options[@]}" --passes 6 -o "$work/few.pfm" 2>/dev/null
submit tiles --passes 6 --chunk 4 --tiles 3x2 -- "${options[@]}"
wait_for_jobs 300 true
same "$work/few.pfm" "$to.pfm"

echo "== stops at an error"
submit error --passes 400 --chunk 4 --error 4% -- "${options[@]}"
wait_for_jobs 600 true
echo "$(grep -l "not rendered" "$to"/logs/task-*.log | wc -l) of 100 tasks were not needed"
grep -h -E "passes from|accuracy" "$to/logs/merge.log"
[[ -e $to/states/enough && $(find "$to/states" -name '*.done' | wc -l) -lt 100 ]]

echo "== bad input"
submit bad --passes 4 -- --size 64x48 --clamp -1
wait_for_jobs 200 true
grep -h "error:" "$to/logs/task-0.log"
[[ $(grep -c "^error:" "$to/logs/task-0.log") -eq 1 ]]

echo "all as expected"
