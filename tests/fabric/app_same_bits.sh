#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The parallel program gives the very bits of the serial one, at any thread count, in every order of
# the mesh. Arguments: SERIAL PARALLEL SCENES FOLDER.
export OMP_WAIT_POLICY=passive # a thread that waits does not take the core of one that works
export TSAN_OPTIONS=ignore_noninstrumented_modules=1 # the OpenMP runtime is one
serial=$1 parallel=$2
shift
source "$(dirname "$0")/app_common.sh"

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
finish
