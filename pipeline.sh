#!/usr/bin/env bash
# From a scene to an image and a report: installs what is missing, builds, and runs command/hipmap.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

usage() {
    cat <<'TEXT'
usage: ./pipeline.sh [SCENE [FOLDER [FRAMES]]] [-- OPTION...]

Installs the packages that are missing (as root or with sudo), builds both tools, and runs them on
SCENE (.glb, .gltf or .obj).  The results go to FOLDER; report.html there shows them all on one page.
The same command resumes a render that was stopped.

  SCENE    default: the bundled scene, assets/cornell.glb
  FOLDER   default: out/NAME, NAME being the name of SCENE without its suffix
  FRAMES   of the scene's animation at 24 a second, as 1:24: rendered to FOLDER/frames as well,
           and made into a video if ffmpeg is installed
  OPTION   of render or preprocess: ./pipeline.sh desk.glb -- --size 1280 --error 5%
           docs/options.md lists all of them
TEXT
}

fail_usage() {
    echo "error: $1" >&2
    exit 2
}

places=()
while [[ $# -gt 0 && $1 != -- ]]; do
    case $1 in
    --help | -h)
        usage
        exit 0
        ;;
    -*) fail_usage "unknown option $1; see ./pipeline.sh --help" ;;
    esac
    places+=("$1")
    shift
done
[[ ${#places[@]} -le 3 ]] || fail_usage "more than three arguments; see ./pipeline.sh --help"

scene=${places[0]:-$root/assets/cornell.glb}
[[ -f $scene ]] || fail_usage "$scene: no such file; give a .glb, .gltf or .obj file"

"$root/.ci/setup.sh" release preprocess render

arguments=("$scene")
if [[ -n ${places[1]:-} ]]; then arguments+=(-o "${places[1]}"); fi
if [[ -n ${places[2]:-} ]]; then arguments+=(--frames "${places[2]}"); fi
exec python3 -B "$root/command/hipmap" "${arguments[@]}" "$@"
