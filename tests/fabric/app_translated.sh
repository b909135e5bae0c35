#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# redcc transforms each force loop and the sparse product, without annotation or --pure; what it
# writes draws no warning. Arguments: REDCC RUNTIME-INCLUDE SOURCES.
set -euo pipefail
redcc=$1 include=$2 sources=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for name in effects/triangle effects/hinge effects/drag effects/strain_limit effects/damping system/sparse_product; do
  file=$sources/$name.c
  "$redcc" "$file" -o "$work/out.c" --require --report=json --report-file="$work/report.json" -- \
    -I"$sources"
  jq -e '[.loops[].verdict] | length > 0 and all(. == "transformed")' "$work/report.json" >/dev/null ||
    { echo "$name: not all loops are transformed"; jq -c '.loops[]' "$work/report.json"; exit 1; }
  for compiler in gcc clang clang-19; do
    "$compiler" -std=gnu17 -O3 -Wall -Wextra -Werror -I"$include" -I"$sources" \
      -I"$(dirname "$file")" -c "$work/out.c" -o "$work/out.o"
  done
done
