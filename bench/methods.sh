# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The runtime's methods on a heavy and a light loop over a mesh of the paper's size (bench/loops.c),
# against the sequential loop of the same run.
. bench/common.sh
threads=$(nproc)
cmake --build --preset release --target bench_loops >/dev/null
loops=$(find "$build" -name bench_loops -type f)
csv=$results/methods.csv
echo "loop,mesh,method,threads,serial_seconds,planned_seconds,speed_up,inspection_of_serial" >"$csv"
load_note
for loop in heavy light; do
  for mesh in sorted shuffled; do
    for method in auto atomic localwrite expansion:a expansion:b pseudo-expansion dwa-lip pe-dwa-lip:2 dwa-lip-fixed \
      expansion-fixed; do
      line=$(REDCC_METHOD=$method OMP_NUM_THREADS=$threads "$loops" "$loop" "$mesh")
      echo "$line"
      echo "$loop,$mesh,$method,$threads,$(sed -E \
        's/.*serial ([0-9.]+) s, planned ([0-9.]+) s, speed-up ([0-9.]+), inspection ([-0-9.]+).*/\1,\2,\3,\4/' \
        <<<"$line")" >>"$csv"
    done
  done
done
echo "kept: $csv"
