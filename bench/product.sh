# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Compares products with half of the cloth's symmetric matrix, as fabric stores it, and with the whole matrix: blocks,
# megabytes and the time of one product on one core, for the paper's two meshes. First checks that both products agree.
#   MESHES="2602,220,1001 218272,1713,31"   vertices, those on the border, repetitions
. bench/common.sh
MESHES=${MESHES:-2602,220,1001 218272,1713,31}
csv=$results/product.csv
load_note
libraries=()
for part in physics scene mesh; do libraries+=("$build/examples/fabric/libfabric_$part.a"); done
mapfile -t optional < <(for name in cholmod metis; do ldconfig -p | grep -q "lib$name\.so " && echo "-l$name"; done)
cc -O3 -ffp-contract=off -Iexamples/fabric bench/product.c "${libraries[@]}" -lqhull_r -lyaml "${optional[@]}" -lm \
  -o "$work/product"
read -r -a meshes <<<"${MESHES//,/ }"
"$work/product" "${meshes[@]}" | tee "$work/table"
[ "${PIPESTATUS[0]}" -eq 0 ] || exit 1
awk -v OFS=, 'NR == 1 {print "vertices,bending,half_blocks,half_mb,half_us,full_blocks,full_mb,full_us,gain"; next}
  {$1 = $1; print}' "$work/table" >"$csv"
echo "kept: $csv"
