# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times the runtime's methods on a heavy and a light loop over a mesh of the paper's size (bench/loops.c), against the
# sequential loop of the same run, and with hand-written alternatives; then `auto` with order any. WARM: seconds of
# executions before `auto` is timed. `auto` needs some seconds until the time that it has saved so far covers the cost
# of partitioning the heavy loop's access graph.
. bench/common.sh
threads=$(nproc)
warm=${WARM:-15}
cmake --build --preset release --target bench_loops >/dev/null
loops=$(find "$build" -name bench_loops -type f)
csv=$results/methods.csv
echo "loop,mesh,method,threads,order,serial_seconds,seconds,speed_up,lowest,highest,inspection_of_serial,extra_percent,replication,modelled" >"$csv"
load_note
# OpenMP's reductions put copies of the arrays on the stacks.
ulimit -s unlimited 2>/dev/null || echo "note: the stack is limited; omp-sections may fail"
export OMP_NUM_THREADS=$threads OMP_STACKSIZE=512M
cells() { # ARGUMENT...: those of bench/loops after the mesh
  for loop in heavy light; do
    for mesh in sorted shuffled; do
      "$loops" "$loop" "$mesh" "$@" | tee -a "$csv"
    done
  done
}
cells "$warm" others
REDCC_ORDER=any cells "$warm"
for method in atomic localwrite localwrite-steal graph-localwrite wavefront expansion:a expansion:b pseudo-expansion dwa-lip \
  pe-dwa-lip:2 dwa-lip-fixed expansion-fixed; do
  REDCC_METHOD=$method cells 1
done
echo "kept: $csv"
