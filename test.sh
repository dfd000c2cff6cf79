#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: ./test.sh [--sanitize] [-- CTEST_ARGUMENT...]

Installs the packages that are missing (as root or with sudo), builds hipmap and its tests, and
runs them all.  Arguments after -- go to ctest, such as -R partition.

  --sanitize   build and run with AddressSanitizer and UndefinedBehaviorSanitizer
  --help       print this text
TEXT
}

preset=release
while [[ $# -gt 0 ]]; do
    case $1 in
    --sanitize) preset=sanitize ;;
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
"$root/.ci/setup.sh" "$preset" all
ctest --test-dir "$root/build/$preset" --output-on-failure --no-tests=error \
    --parallel "$(nproc)" "$@"
