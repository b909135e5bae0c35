# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Prefetches in the executors of LOCALWRITE: the untouched loops (bench/lanes_kernels.c) against the
# translated ones without and with prefetches, at -O2 and at -O3 -march=native; bits compared in
# every round.
#   ROUNDS=15 THREADS="2 1" CC=gcc
. bench/common.sh
compiler=${CC:-gcc}
csv=$results/lanes.csv
export REDCC_METHOD=localwrite OMP_WAIT_POLICY=passive
load_note
head=kernel,order,threads,serial_seconds,plain,plain_low,plain_high,prefetch,prefetch_low,prefetch_high,gain
echo "flags,$head" >"$csv"
echo "flags,$head"
"$build/tool/redcc" --require bench/lanes_kernels.c -o "$work/translated.c" -Ibench 2>/dev/null
runtime=$(find "$build" -name libredcc_rt.a)
while read -r flags; do
  # shellcheck disable=SC2086
  "$compiler" $flags -ffp-contract=off -Ibench -c bench/lanes_kernels.c -o "$work/serial.o"
  objcopy --redefine-sym membrane=serial_membrane --redefine-sym contacts=serial_contacts \
    --redefine-sym springs=serial_springs "$work/serial.o"
  # shellcheck disable=SC2086
  "$compiler" $flags -fopenmp -Ibench -Iruntime/include -c "$work/translated.c" -o "$work/translated.o"
  # shellcheck disable=SC2086
  "$compiler" -O2 -fopenmp -Ibench -Iruntime/include -Iruntime/src bench/lanes.c \
    "$work/serial.o" "$work/translated.o" "$runtime" -lm -o "$work/lanes"
  for threads in ${THREADS:-$(nproc)}; do
    OMP_NUM_THREADS=$threads "$work/lanes" "${ROUNDS:-15}" | sed "s/^/$flags,/" | tee -a "$csv"
  done
done <<<"${FLAGS:--O2
-O3 -march=native}"
echo "kept: $csv"
