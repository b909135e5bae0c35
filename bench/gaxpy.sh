# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times CSparse's unchanged cs_gaxpy, y = A*x + y, compiled by gcc and by redcc-cc. The matrix has a million rows and
# ten million entries, in four shapes (bench/gaxpy.c). The programs take turns in each round; each ratio is of two runs
# of the same round. The source comes from Debian (build/packages; the first time by network). By default, from the 14th
# call on, the runtime learns of changed subscripts by write protection of their pages and no longer reads them
# (docs/decisions/0007); the median of 41 calls includes that. REDCC_WATCH=off is measured for comparison.
#   ROUNDS=5 CALLS=41 SIDE=1000 SHAPES="banded mesh shuffled random"
. bench/common.sh
rounds=${ROUNDS:-5}
calls=${CALLS:-41}
side=${SIDE:-1000}
read -r -a shapes <<<"${SHAPES:-banded mesh shuffled random}"
csv=$results/gaxpy.csv
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
packages=${PACKAGES_FOLDER:-$PWD/build/packages}
(
  source_package=suitesparse PACKAGES_FOLDER=$packages
  . tests/packages/library.sh
  fetch
) || { echo "gaxpy: no source of CSparse, nothing is measured"; exit 0; }
csparse=$packages/sources/suitesparse/CSparse
load_note

# build_gaxpy NAME COMPILER: builds the benchmark; COMPILER compiles cs_gaxpy.c, gcc all other files
flags=(-O2 -I"$csparse/Include")
build_gaxpy() {
  "$2" "${flags[@]}" -c "$csparse/Source/cs_gaxpy.c" -o "$work/gaxpy-$1.o"
  "$2" "$work/gaxpy-$1.o" "$work/main.o" "$work/util.o" "$work/malloc.o" -o "$work/$1"
}
gcc "${flags[@]}" -c bench/gaxpy.c -o "$work/main.o"
gcc "${flags[@]}" -c "$csparse/Source/cs_util.c" -o "$work/util.o"
gcc "${flags[@]}" -c "$csparse/Source/cs_malloc.c" -o "$work/malloc.o"
build_gaxpy plain gcc
build_gaxpy redcc "$prefix/bin/redcc-cc"

# run SHAPE VARIANT ROUND COMMAND...: adds one line to the table
run() {
  local shape=$1 variant=$2 round=$3 median first bits method=-
  shift 3
  rm -f "$work/report"
  read -r median first bits < <(REDCC_REPORT=$work/report "$@" "$shape" "$side" "$calls")
  [ ! -s "$work/report" ] || method=$(jq -r '.loops[0].method' "$work/report")
  echo "$shape,$variant,$round,$median,$first,$bits,$method" >>"$csv"
}
# An upper bound of the speed-up: gcc's program runs on every core at once, each copy with a separate matrix, and the
# slowest copy counts.
run_crowd() { # run_crowd SHAPE ROUND
  local core
  for core in $(seq "$(nproc)"); do
    "$work/plain" "$1" "$side" "$calls" >"$work/crowd-$core" &
  done
  wait
  sort -g "$work"/crowd-* | tail -n 1 | awk -v s="$1" -v r="$2" -v n="$(nproc)" \
    '{print s ",crowd," r "," $1 / n "," $2 / n "," $3 ",-"}' >>"$csv"
}
echo "shape,variant,round,seconds,seconds_first,bits,method" >"$csv"
for shape in "${shapes[@]}"; do
  for round in $(seq "$rounds"); do
    run "$shape" plain "$round" "$work/plain"
    for threads in 1 2; do
      run "$shape" "threads-$threads" "$round" env OMP_NUM_THREADS=$threads "$work/redcc"
    done
    run "$shape" compared-2 "$round" env OMP_NUM_THREADS=2 REDCC_WATCH=off "$work/redcc"
    run_crowd "$shape" "$round"
  done
done

column() { awk -F, -v s="$1" -v v="$2" -v c="$3" '$1 == s && $2 == v {print $c}' "$csv"; }
ratios() {
  awk -F, -v s="$1" -v v="$2" '$1 == s && $2 == "plain" {p[$3] = $4} $1 == s && $2 == v {r[$3] = $4}
    END {for (i in r) if (r[i] > 0) print p[i] / r[i]}' "$csv"
}
echo "seconds of a call (median), plain over variant round by round (median, least to greatest), first call"
for shape in "${shapes[@]}"; do
  for variant in plain threads-1 threads-2 compared-2 crowd; do
    printf '%-9s %-10s %9.4f s   ratio %.3f  (%.3f to %.3f)   first %9.4f s   %s\n' "$shape" "$variant" \
      "$(column "$shape" $variant 4 | median)" "$(ratios "$shape" $variant | median)" \
      "$(ratios "$shape" $variant | minimum)" "$(ratios "$shape" $variant | maximum)" \
      "$(column "$shape" $variant 5 | median)" "$(column "$shape" $variant 7 | sort | uniq -c | sort -nr | awk 'NR == 1 {print $2}')"
  done
  [ "$(awk -F, -v s="$shape" '$1 == s {print $6}' "$csv" | sort -u | wc -l)" = 1 ] ||
    { echo "$shape: THE BITS DIFFER"; exit 1; }
done
echo "kept: $csv"
