# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times the loops of examples/by-hand: sequential, by hand for redcc's runtime, and with OpenMP's `reduction` and
# `atomic`. Prints milliseconds per execution: medians, 10th and 90th percentiles of interleaved rounds. There are two
# programs. In the one with OpenMP regions, OpenMP's threads also execute redcc's loops. In the other, the runtime's
# own threads execute them.
#   SIDE=400 ROUNDS=15 THREADS=2
. bench/common.sh
SIDE=${SIDE:-400} ROUNDS=${ROUNDS:-15} THREADS=${THREADS:-2}
csv=$results/by-hand.csv
load_note
cmake --build --preset release --target by-hand by-hand-openmp >/dev/null
echo "program,loop,version,ms,ms_10,ms_90" >"$csv"
export OMP_NUM_THREADS=$THREADS OMP_STACKSIZE=512M
for loop in springs product histogram assemble; do
  for program in by-hand by-hand-openmp; do
    (ulimit -s unlimited && "$build/examples/by-hand/$program" time "$loop" "$SIDE" "$ROUNDS") |
      sed "s/^/$program,/" >>"$csv"
  done
done
column -s, -t "$csv"
echo "kept: $csv"
