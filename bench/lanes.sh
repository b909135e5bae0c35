# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times lanes (loops by SIMD vectors) and prefetches in LOCALWRITE's parallel form of loops: the original loops
# (bench/lanes_kernels.c) against the translated ones with neither, with each, with both, and with the runtime's choice.
# They are compiled for this machine, and for any with -O2 alone. Bits are compared in every round. Below the table are
# the loops without lanes, and the reasons.
#   ROUNDS=15 SIDE=467 THREADS="1 2" CC=gcc KERNEL=membrane ARCH=native LANES=4 (auto: of heavy loops alone)
# For another machine: `PROGRAMS=folder ARCH=x86-64-v4 script/bench lanes` only builds the programs, in that folder.
# They need only the C library and libgomp. Run each there by
#   OMP_NUM_THREADS=2 OMP_WAIT_POLICY=passive folder/lanes-O2 ROUNDS SIDE KERNEL
# All arguments are optional: the defaults are 15 rounds, a mesh of 467 x 467 and all kernels.
. bench/common.sh
compiler=${CC:-gcc}
csv=$results/lanes.csv
programs=${PROGRAMS:-$work}
mkdir -p "$programs"
export OMP_WAIT_POLICY=passive
"$build/tool/redcc" --require "--lanes=${LANES:-4}" bench/lanes_kernels.c -o "$work/translated.c" -Ibench 2>/dev/null
runtime=$(find "$build" -name libredcc_rt.a)
make_program() { # NAME FLAGS...
  local name=$1 kernel
  shift
  local renamed=()
  for kernel in cloth membrane float_membrane contacts touching lennard_jones springs tetrahedra half_product; do
    renamed+=(--redefine-sym "$kernel=serial_$kernel")
  done
  "$compiler" "$@" -ffp-contract=off -Ibench -c bench/lanes_kernels.c -o "$work/serial.o"
  objcopy "${renamed[@]}" "$work/serial.o"
  "$compiler" "$@" -Ibench -Iruntime/include -c "$work/translated.c" -o "$work/translated.o"
  "$compiler" -O2 -Wl,-u,redcc_run -Ibench -Iruntime/include -Iruntime/src bench/lanes.c bench/lanes_data.c \
    "$work/serial.o" "$work/translated.o" "$runtime" -lgomp -lm -o "$programs/$name"
}
make_program lanes-native -O3 "-march=${ARCH:-native}"
make_program lanes-O2 -O2
if [ -n "${PROGRAMS:-}" ]; then
  echo "made: $programs/lanes-native $programs/lanes-O2"
  exit 0
fi
load_note
head=build,kernel,order,threads,serial_seconds
for variant in plain prefetch lanes both auto; do head+=,$variant,${variant}_low,${variant}_high; done
echo "$head" | tee "$csv"
for threads in ${THREADS:-1 2}; do
  for name in lanes-native lanes-O2; do
    # shellcheck disable=SC2086
    OMP_NUM_THREADS=$threads "$programs/$name" "${ROUNDS:-15}" "${SIDE:-467}" ${KERNEL:-} |
      sed "s/^/${name#lanes-},/" | tee -a "$csv"
  done
done
sed '/one iteration at a time/ {/\*\/$/! {N; s/\n */ /}}' "$work/translated.c" | awk '/^void / {name = $2; sub(/\(.*/, "", name)}
  sub(/.*redcc: one iteration at a time: /, "") {sub(/ \*\/$/, ""); print name ": not for vectors: " $0}'
echo "kept: $csv"
