#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Effects that are there but do not act cost at most 1 % of the instructions of a build without them.
# Arguments: WITH WITHOUT SHEET, two builds of effect_cost and what they are to run.
set -euo pipefail
count() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" "$2" 2>&1 |
    awk '/Collected/ {print $4}'
}
with=$(count "$1" "$3")
without=$(count "$2" "$3")
echo "instructions: $with with the effects, $without without"
awk -v a="$with" -v b="$without" 'BEGIN {exit !(b > 1e6 && a <= 1.01 * b)}'
