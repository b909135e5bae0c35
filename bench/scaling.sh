# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Speed-up of the two loops of bench/loops.c by number of threads. `auto` is timed with 1, 2, 4, ... threads up to the
# number of cores. Beyond that, the speed-up is computed from the schedules of methods with serial order
# (runtime/src/plan/length.h), without the effects of memory and barriers.
#   WARM=15 MODELLED="2 8 16 33 64"   seconds of executions before `auto` is timed; thread counts, or none
. bench/common.sh
cores=$(nproc)
cmake --build --preset release --target bench_loops >/dev/null
loops=$(find "$build" -name bench_loops -type f)
csv=$results/scaling.csv
echo "kind,loop,mesh,method,threads,order,serial_seconds,seconds,speed_up,lowest,highest,inspection_of_serial,extra_percent,replication,modelled" >"$csv"
load_note
run() { # kind, threads, WARM
  for loop in heavy light; do
    for mesh in sorted shuffled; do
      OMP_NUM_THREADS=$2 "$loops" "$loop" "$mesh" "$3" | sed "s/^/$1,/" | tee -a "$csv"
    done
  done
}
for ((threads = 1; threads <= cores; threads *= 2)); do
  run measured "$threads" "${WARM:-15}"
done
for method in localwrite localwrite-steal graph-localwrite wavefront; do
  for threads in ${MODELLED-2 8 16 33 64}; do
    OMP_WAIT_POLICY=passive REDCC_METHOD=$method run modelled "$threads" 0
  done
done
echo "kept: $csv"
