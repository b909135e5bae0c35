#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The paper's scenes, parallel against serial: not a bit differs, at 1, 2, 3 and 8 threads, by every
# method that promises the serial order. Arguments: SERIAL PARALLEL SCENES FOLDER. STEPS=76 for the
# whole scenes (the default, 26, is past the first contact).
export OMP_WAIT_POLICY=passive # a thread that waits does not take the core of one that works
serial=$1 parallel=$2
shift
source "$(dirname "$0")/app_common.sh"

for scene in tablecloth hanging; do
  run=(run $scene --steps "${STEPS:-26}" --frames 0 --progress none)
  expect 0 "" "$serial" "${run[@]}" -o serial-$scene
  for method in auto localwrite localwrite-steal graph-localwrite graph-localwrite-steal wavefront; do
    for threads in 1 2 3 8; do
      export REDCC_METHOD=$method
      same_bits serial-$scene "$parallel" "${run[@]}" --threads $threads
    done
  done
  # By as many threads as pay, which may be others in each step.
  export REDCC_METHOD=auto
  for threads in 2 7; do
    OMP_NUM_THREADS=$threads same_bits serial-$scene "$parallel" "${run[@]}"
  done
done
finish
