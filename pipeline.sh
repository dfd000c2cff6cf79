#!/usr/bin/env bash
# From a scene to a picture and a report: installs what is missing, builds, partitions, renders.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

usage() {
    cat <<'TEXT'
usage: ./pipeline.sh [SCENE [OUTDIR [FRAMES]]]

Installs the packages that are missing (as root or with sudo), builds both tools, and runs them on
SCENE (.glb, .gltf or .obj).  The results go to OUTDIR; report.html there shows them all on one page.

  SCENE    default: the bundled scene, assets/cornell.glb
  OUTDIR   default: out/NAME, NAME being the name of SCENE without its suffix
  FRAMES   of the scene's animation at 24 a second, as 1:24: rendered to OUTDIR/frames besides,
           and made into a video where ffmpeg is installed
TEXT
}

fail_usage() {
    echo "error: $1" >&2
    exit 2
}

case ${1:-} in
--help | -h)
    usage
    exit 0
    ;;
-*) fail_usage "unknown option $1; see ./pipeline.sh --help" ;;
esac
[[ $# -le 3 ]] || fail_usage "more than three arguments; see ./pipeline.sh --help"

scene=${1:-$root/assets/cornell.glb}
[[ -f $scene ]] || fail_usage "$scene: no such file; give a .glb, .gltf or .obj file"
name=$(basename "$scene")
name=${name%.*}
out=${2:-out/$name}
frames=${3:-}
[[ $frames =~ ^([0-9]+(:[0-9]+)?)?$ ]] ||
    fail_usage "$frames: not a range of frames; write FIRST:LAST, such as 1:24"

"$root/.ci/setup.sh" release preprocess render

mkdir -p "$out"
bin=$root/build/release/bin
partition=$out/$name.hpm
"$bin/preprocess" "$scene" -o "$partition" --images "$out" --json "$out/partition.json"
"$bin/render" "$scene" "$partition" -o "$out/$name.png" -o "$out/$name.exr" \
    --error-image "$out/error.png" --stats "$out/stats.json"
python3 -B "$root/report/make_report.py" "$out"

# All exposed as the picture is, half a frame's time of motion in each, as in Blender.
make_frames() {
    local exposure first=$((10#${frames%%:*}))
    local print_exposure='import json, sys; print(json.load(sys.stdin)["image"]["exposure_ev"])'
    exposure=$(python3 -c "$print_exposure" < "$out/stats.json")
    mkdir -p "$out/frames"
    "$bin/preprocess" "$scene" -o "$out/frames/$name.hpm" --frames "$frames"
    "$bin/render" "$scene" "$out/frames/$name.hpm" -o "$out/frames/$name.png" --frames "$frames" \
        --shutter 0.5 --exposure "$exposure"
    if command -v ffmpeg > /dev/null; then
        # Most players want 4:2:0, which has whole pairs of pixels.
        ffmpeg -loglevel error -y -framerate 24 -start_number "$first" \
            -i "$out/frames/$name.%04d.png" -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' \
            -pix_fmt yuv420p "$out/$name.mp4"
    fi
}
if [[ -n $frames ]]; then make_frames; fi

describe() { printf '  %-20s %s\n' "$1" "$2"; }

printf '\n%s/\n' "$out"
describe report.html "all of this on one page, to open in a browser"
describe "$name.png" "the picture, exposed for a screen"
describe "$name.exr" "the same in absolute radiance, linear"
describe error.png "how far each pixel may be off"
describe shared_maps.png "which faces share photons, a colour for each map"
describe edges.png "edges by class"
describe candidates.png "faces that may get a map of their own"
describe groups.png "patches of faces that may get a map together"
describe "$name.hpm" "the partition that render reads"
describe partition.json "what preprocess found"
describe stats.json "what render did, and how long it took"
if [[ -n $frames ]]; then describe frames/ "frames $frames of the animation"; fi
if [[ -f $out/$name.mp4 ]]; then describe "$name.mp4" "the same as a video"; fi
