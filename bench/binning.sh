# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Compares in-order binning with the sequential loop and with LOCALWRITE, which must inspect each time, on loops with
# new subscripts in each execution (bench/binning.c). The bits of the results are compared in every round.
#   ROUNDS=13 KERNELS="doubles-16M ..."   (default: all kernels)
. bench/common.sh
read -r -a kernels <<<"${KERNELS:-}"
cmake --build --preset release --target bench_binning >/dev/null
program=$(find "$build" -name bench_binning -type f)
csv=$results/binning.csv
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-$(nproc)} OMP_WAIT_POLICY=passive
load_note
echo "kernel,method,threads,serial_seconds,seconds,speed_up,lowest,highest,best,cpu,extra_percent" >"$csv"
"$program" "${ROUNDS:-13}" "${kernels[@]}" | tee -a "$csv"
echo "kept: $csv"
