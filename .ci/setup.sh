#!/usr/bin/env bash
# What pipeline.sh and test.sh begin with: installs the Debian packages of .ci/packages.txt that are
# missing, configures a preset and builds targets.  What stands is neither installed nor built again.
#
#   .ci/setup.sh PRESET TARGET...
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The packages that are not installed, one a line.
missing_packages() {
    local installed
    # dpkg-query fails if it has never heard of one of them.
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
        sed -n 's/^installed //p' || true)
    printf '%s\n' "$@" | grep -vxF -f <(echo "$installed") || true # grep fails if none is missing
}

install_packages() {
    local as_root=()
    if [[ $EUID -ne 0 ]]; then
        if ! command -v sudo >/dev/null; then
            echo "error: packages are missing and neither root nor sudo is at hand;" \
                "as root run: apt-get install $*" >&2
            exit 1
        fi
        as_root=(sudo)
    fi
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y
        -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
    echo "installing $*"
    "${apt[@]}" update
    "${apt[@]}" install --no-install-recommends "$@"
}

# The packages without a mark, and those with the mark given.
packages() {
    sed -nE "s/^([a-z0-9][^ ]*)( # $1)?\$/\1/p" "$root/.ci/packages.txt"
}

install_missing() {
    if ! command -v dpkg-query >/dev/null; then
        echo "not Debian: the libraries of .ci/packages.txt are expected to be there"
        return
    fi
    local mark=none wanted missing
    case " $* " in
    *" all "*) mark=test ;;
    " fuzz "*) mark=fuzz ;;
    esac
    mapfile -t wanted < <(packages $mark)
    mapfile -t missing < <(missing_packages "${wanted[@]}")
    if [[ ${#missing[@]} -gt 0 ]]; then
        install_packages "${missing[@]}"
    fi
}

# Warnings are errors in CI, but not with sanitizers, under which GCC warns of what is not there.
build() {
    local preset=$1 werror=OFF
    shift
    if [[ -n ${CI:-} && $preset == release ]]; then
        werror=ON
    fi
    cd "$root"
    cmake --preset "$preset" -DHIPMAP_WERROR=$werror --log-level=WARNING
    cmake --build "build/$preset" --parallel "$(nproc)" --target "$@"
}

install_missing "$@"
build "$@"
