#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The parallel program gives the very bits of the serial one, at any thread count, in every order of
# the mesh. Arguments: SERIAL PARALLEL SCENES FOLDER.
export OMP_WAIT_POLICY=passive # a thread that waits does not take the core of one that works
export TSAN_OPTIONS=ignore_noninstrumented_modules=1 # the OpenMP runtime is one
serial=$1 parallel=$2
shift
source "$(dirname "$0")/app_common.sh"

# Threads that wait sleep soon, unless the user has said how they wait.
expect 0 "GOMP_SPINCOUNT = '1000'" env -u OMP_WAIT_POLICY -u GOMP_SPINCOUNT OMP_DISPLAY_ENV=verbose \
  "$parallel" run patch --steps 1 --frames 0 --progress none -o waiting
expect 0 "GOMP_SPINCOUNT = '77'" env -u OMP_WAIT_POLICY GOMP_SPINCOUNT=77 OMP_DISPLAY_ENV=verbose \
  "$parallel" run patch --steps 1 --frames 0 --progress none -o waiting

for order in sorted shuffled; do
  run=(run patch --steps 12 --frames 0 --progress none --set mesh.order=$order)
  expect 0 "" "$serial" "${run[@]}" -o serial-$order
  for threads in 1 2 3 7; do
    expect 0 "" "$parallel" "${run[@]}" -o $order-$threads --threads $threads
    holds "threads are counted" \
      jq -e ".threads == $threads and .program == \"$(basename "$parallel")\"" \
      $order-$threads/summary.json >/dev/null
    expect 0 "positions: equal, every bit" \
      "$serial" compare serial-$order/final.state $order-$threads/final.state
  done
done

# And whatever integrates in time and solves the system.
for setting in time.integrator=euler time.integrator=bdf2 time.integrator=midpoint \
  solution.preconditioner=block-jacobi solution.preconditioner=incomplete-cholesky \
  solution.precision=mixed; do
  run=(run patch --steps 12 --frames 0 --progress none --set $setting)
  expect 0 "" "$serial" "${run[@]}" -o serial
  for threads in 1 3; do
    same_bits serial "$parallel" "${run[@]}" --threads $threads
  done
done

# And a body that starts, turns and stops.
body='{kind: box, position: [0, 0, 0.45], half_edges: [0.2, 0.05, 0.05], turn_axis: [1, 0, 2],
  motion: [{time: 0.05}, {time: 0.2, move: [0, 0.02, 0.1], angle: 200}]}'
run=(run patch --steps 16 --frames 4 --progress none --set "colliders=[$body]")
expect 0 "" "$serial" "${run[@]}" -o serial
for threads in 1 3; do
  same_bits serial "$parallel" "${run[@]}" --threads $threads
done
# What a run leaves has its keyframes: from there to the same bits.
expect 0 "" "$serial" run serial/scene.yaml --progress none -o again
expect 0 "positions: equal, every bit" "$serial" compare serial/final.state again/final.state
expect 1 "'colliders.0.motion.1.time' is 0.2, expected a time after the one before, 0.3" \
  "$serial" plan serial/scene.yaml --set colliders.0.motion.0.time=0.3
if command -v jq >/dev/null; then # the body turns in what other programs read
  expect 0 "" "${serial%/*}/fabric-view" gltf serial -o serial/cloth.gltf
  find serial -name '*.gltf' | while read -r file; do
    jq -e '[.animations[0].channels[].target.path] == ["weights", "translation", "rotation"] and
      ([.accessors[] | select(.type == "VEC4") | .count] == [.accessors[] | select(.max and .type == "SCALAR") | .count])
      and (.nodes[1].rotation | length == 4)' "$file" >found.log || { echo "FAILED: $file"; exit 1; }
  done || failures=$((failures + 1))
fi
finish
