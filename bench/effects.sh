# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The cost of each effect of the cloth simulator, in instructions per step: effects are added one after the other.
# Instructions are counted by valgrind's callgrind, so other programs do not disturb the figures.
#   STEPS=4
. bench/common.sh
command -v valgrind >/dev/null || { echo "effects: valgrind is not installed: nothing measured"; exit 0; }
export FABRIC_SCENES=$PWD/examples/fabric/scenes
serial=${SERIAL:-$build/examples/fabric/fabric-serial}
steps=${STEPS:-4}
csv=$results/effects.csv
echo "added,blocks,iterations,forces,collisions,solve,update,product" >"$csv"

# The first run has a sheet of 900 particles on which nothing acts, with a corner above the ball. The preconditioner
# is block-Jacobi, because each iteration with it is one product with the matrix.
none=(--set colliders='[]' --set self_collision.gap=0 --set mesh.origin='[0.2, 0, 0.715]'
  --set surroundings.gravity='[0, 0, 0]' --set surroundings.drag=0
  --set material.stretch=0 --set material.shear=0 --set material.bend=0
  --set material.stretch_damping=0 --set material.shear_damping=0 --set material.bend_damping=0
  --set mesh.normal='[0.3, 0, 1]' --set solution.preconditioner=block-jacobi)
ball='{kind: sphere, position: [0, 0, 0.4], radius: 0.3, friction: 0.3, gap: 0.01}'
far='{kind: sphere, position: [90, 0, 0.4], radius: 0.3, friction: 0.3, gap: 0.01}'

# instructions FUNCTION FILE: prints the instructions in the function, including called functions; 0 if not called
instructions() {
  callgrind_annotate --inclusive=yes --threshold=100 "$2" 2>/dev/null | tr -d , |
    awk -v f=":$1 " 'index($0, f) {print $1; found = 1; exit} END {if (!found) print 0}'
}

# measure NAME OPTION... : prints one line of the table
measure() {
  local name=$1 file=$work/callgrind blocks iterations part values=()
  shift
  valgrind --tool=callgrind --callgrind-out-file="$file" "$serial" run ball --steps "$steps" \
    --frames 0 --progress none -o "$work/run" "${none[@]}" "$@" >/dev/null 2>"$work/log" ||
    { cat "$work/log"; exit 1; }
  blocks=$(jq .matrix_blocks "$work/run/summary.json")
  iterations=$(jq ".cg_iterations / $steps" "$work/run/summary.json")
  for part in evaluateForces collisionDetection solveSystem updateSystem half_product; do
    values+=("$(instructions "$part" "$file")")
  done
  printf '%-18s %8s %8.0f' "$name" "$blocks" "$iterations"
  for part in 0 1 2 3; do
    printf ' %10.3f' "$(awk -v v="${values[part]}" -v n="$steps" 'BEGIN {print v / n / 1e6}')"
  done
  printf ' %10.4f\n' "$(awk -v v="${values[4]}" -v n="$iterations" -v s="$steps" \
    'BEGIN {print (n > 0 ? v / (n * s) / 1e6 : 0)}')"
  (IFS=,; echo "$name,$blocks,$iterations,${values[*]}") >>"$csv"
}

printf '%-18s %8s %8s %10s %10s %10s %10s %10s\n' "millions a step" blocks CG forces collisions \
  solve update product
all=()
step() {
  all+=("${@:2}")
  measure "$1" "${all[@]}"
}
step nothing
step gravity --set surroundings.gravity='[0, 0, -9.81]'
step stretch --set material.stretch=400
step shear --set material.shear=80
step damping --set material.stretch_damping=0.5 --set material.shear_damping=0.1
step bend --set material.bend=1e-4 --set material.bend_damping=1e-6
step drag --set surroundings.drag=0.2
step wind --set surroundings.wind='[1, 0, 0]'
step pins --set pins='[{low: [-0.61, -0.61], high: [-0.59, -0.4]}]'
measure "... but no bend" "${all[@]}" --set material.bend=0 --set material.bend_damping=0
measure "... no shear" "${all[@]}" --set material.shear=0 --set material.shear_damping=0
measure "... no monitor" "${all[@]}" --set monitor.watch=off
step "strain limit" --set material.strain_limit=0.02
step "far collider" --set colliders="[$far]"
step "near collider" --set colliders="[$far, $ball]"
step self-collision --set self_collision.gap=0.008
