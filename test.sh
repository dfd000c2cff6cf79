#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: ./test.sh [--sanitize] [-- CTEST_ARGUMENT...]
       ./test.sh --fuzz SECONDS

Installs the packages that are missing (as root or with sudo), builds hipmap and its tests, and
runs them all.  Arguments after -- go to ctest, such as -R partition.

  --sanitize   build and run with AddressSanitizer and UndefinedBehaviorSanitizer
  --fuzz       run the fuzz targets of the glTF, OBJ, IES, partition and state readers instead, each
               for so long, with both sanitizers (clang); what they find stays in build/fuzz/corpus
  --help       print this text
TEXT
}

preset=release
fuzz_seconds=
while [[ $# -gt 0 ]]; do
    case $1 in
    --sanitize) preset=sanitize ;;
    --fuzz)
        fuzz_seconds=${2:-}
        if [[ ! $fuzz_seconds =~ ^[1-9][0-9]*$ ]]; then
            echo "error: --fuzz needs a number of seconds" >&2
            exit 2
        fi
        shift
        ;;
    --help | -h)
        usage
        exit 0
        ;;
    --)
        shift
        break
        ;;
    *)
        echo "error: unknown argument $1" >&2
        usage >&2
        exit 2
        ;;
    esac
    shift
done

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# One target: its seeds are in tests/fuzz/corpus, what it learns is kept from run to run.
fuzz() {
    local target=$1 build=$root/build/fuzz
    local corpus=$build/corpus/$target seeds=$root/tests/fuzz/corpus/$target
    mkdir -p "$corpus"
    if [[ $target == partition ]]; then
        "$build/bin/preprocess" "$root/tests/fuzz/corpus/gltf/quad.gltf" -o "$corpus/quad.hpm" \
            2> /dev/null
        seeds=
    fi
    if [[ $target == state ]]; then
        "$build/bin/preprocess" "$root/tests/fuzz/corpus/gltf/quad.gltf" -o "$build/quad.hpm" \
            2> /dev/null
        "$build/bin/render" "$root/tests/fuzz/corpus/gltf/quad.gltf" "$build/quad.hpm" --size 2x2 \
            --passes 9 -o "$build/quad.pfm" --state "$corpus/quad.state" 2> /dev/null
        "$build/bin/render" "$root/tests/fuzz/corpus/gltf/quad.gltf" "$build/quad.hpm" --size 3x3 \
            --tile 4/3x3 --passes 2 --state "$corpus/tile.state" 2> /dev/null
        "$build/bin/render" merge "$corpus/tile.state" -o "$build/quad.pfm" \
            --state "$corpus/parts.state" 2> /dev/null
        seeds=
    fi
    echo "fuzzing the $target reader for $fuzz_seconds s"
    "$build/bin/fuzz_$target" -max_total_time="$fuzz_seconds" -timeout=10 -rss_limit_mb=2048 \
        -malloc_limit_mb=1024 -max_len=65536 -print_final_stats=1 -verbosity=0 \
        -artifact_prefix="$build/found_$target-" "$corpus" ${seeds:+"$seeds"}
}

if [[ -n $fuzz_seconds ]]; then
    "$root/.ci/setup.sh" fuzz preprocess render fuzz_gltf fuzz_obj fuzz_ies fuzz_partition \
        fuzz_state
    for target in gltf obj ies partition state; do
        fuzz "$target"
    done
    exit
fi

"$root/.ci/setup.sh" "$preset" all
ctest --test-dir "$root/build/$preset" --output-on-failure --no-tests=error \
    --parallel "$(nproc)" "$@"
