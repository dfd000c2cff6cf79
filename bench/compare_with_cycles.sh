#!/usr/bin/env bash
# Compares the bundled scene with Blender's Cycles: as glTF means matt surfaces, as Blender does, and
# with rough metal and glass in it; or, with scenes named, .glb files with --look auto (same_light.py).
# Needs blender on the PATH and both tools built (./pipeline.sh).
#
#   bench/compare_with_cycles.sh [OUTDIR [SAMPLES [SCENE.glb...]]]
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-out/cycles}
samples=${2:-256}
bin=$root/build/release/bin
scene=$root/assets/cornell.glb

command -v blender > /dev/null || {
    echo "error: blender is not installed; apt-get install blender" >&2
    exit 2
}
mkdir -p "$out"
cmake --build "$root/build/release" --target preprocess render compare_images > /dev/null
if [ $# -gt 2 ]; then
    exec /usr/bin/python3 -B "$root/bench/same_light.py" "$bin" "$out" "${@:3}" --samples "$samples"
fi
for model in lambert burley glossy; do
    [ "$model" = glossy ] && scene=$out/glossy.glb
    # Debian's Blender takes the first python3 on the PATH, which must be Debian's too.
    PATH=/usr/bin:$PATH blender -b --factory-startup --python "$root/bench/cycles_reference.py" \
        -- "$model" "$out/cycles_$model.exr" "$samples" "$out/glossy.glb" > "$out/blender_$model.log"
    look=gltf
    [ "$model" = burley ] && look=blender3
    "$bin/preprocess" "$scene" -o "$out/$model.hpm" 2> /dev/null
    "$bin/render" "$scene" "$out/$model.hpm" -o "$out/hipmap_$model.exr" --size 256 \
        --look "$look" 2> /dev/null
    printf '\n%s: A is hipmap, B is Cycles\n' "$model"
    "$bin/compare_images" "$out/hipmap_$model.exr" "$out/cycles_$model.exr" \
        --side-by-side "$out/side_by_side_$model.png"
done
