# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times whole programs (bench/real): each is built, with its libraries, by gcc -O2 and by redcc-cc -O2, and run on
# input of real size. Measures wall time from start to end of gcc's program and of redcc-cc's with 1 and 2 threads, in
# turn; each ratio is of two runs of the same round. All runs must print the same bytes. Sources of SuiteSparse come
# from Debian (build/packages; the first time by network). perf, if it is installed, measures the fraction of a run
# that the loops take.
#   ROUNDS=5 PROGRAMS="molecules bricks jelly euler fairing transport plate" SMALL=   (SMALL=1: the tests' sizes)
. bench/common.sh
. bench/real/library.sh
rounds=${ROUNDS:-5}
read -r -a programs <<<"${PROGRAMS:-${real_programs[*]}}"
if [ -n "${SMALL:-}" ]; then
  for name in "${real_programs[@]}"; do real_size[$name]=${test_size[$name]}; done
fi
export PACKAGES_FOLDER=${PACKAGES_FOLDER:-$PWD/build/packages} OMP_WAIT_POLICY=passive
csv=$results/real.csv
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
load_note

# build_all NAME: builds with both compilers, and again with gcc for the profile. Status 1: the source is unavailable.
build_all() {
  (fetch_real "$1") || return 1
  {
    build_real "$1" gcc "$work/plain/$1" && build_real "$1" "$prefix/bin/redcc-cc" "$work/redcc/$1" &&
      build_real "$1" gcc "$work/profile/$1" -g -no-pie
  } >"$work/log" 2>&1 || { echo "real: $1 does not build: $(tail -n 3 "$work/log")" >&2; exit 1; }
}

# run NAME VARIANT ROUND COMMAND...: adds one line to the table, and compares the output with that of the first run
run() {
  local name=$1 variant=$2 round=$3 start end seconds method=-
  shift 3
  rm -f "$work/report"
  start=$(date +%s%N)
  # shellcheck disable=SC2086
  REDCC_REPORT=$work/report "$@" ${real_size[$name]} >"$work/out"
  end=$(date +%s%N)
  seconds=$(awk -v n=$((end - start)) 'BEGIN {printf "%.4f", n / 1e9}')
  [ -f "$work/$name.expected" ] || cp "$work/out" "$work/$name.expected"
  cmp "$work/out" "$work/$name.expected" || { echo "$name, $variant: THE OUTPUT DIFFERS"; exit 1; }
  [ ! -s "$work/report" ] ||
    method=$(jq -r '[.loops[] | select(.calls > 1) | .method] | unique | join(" ")' "$work/report")
  echo "$name,$variant,$round,$seconds,$share,$method" >>"$csv"
}

column() { awk -F, -v s="$1" -v v="$2" -v c="$3" '$1 == s && $2 == v {print $c}' "$csv"; }
ratios() {
  awk -F, -v s="$1" -v v="$2" '$1 == s && $2 == "plain" {p[$3] = $4} $1 == s && $2 == v {r[$3] = $4}
    END {for (i in r) if (r[i] > 0) print p[i] / r[i]}' "$csv"
}
table() { # NAME
  local variant
  printf '%s: %s %% of the run in the loops; the output is the same in all runs\n' "$1" "$share"
  for variant in plain threads-1 threads-2; do
    printf '  %-10s %8.3f s (%.3f to %.3f)   gcc over it %.3f (%.3f to %.3f)   %s\n' $variant \
      "$(column "$1" $variant 4 | median)" "$(column "$1" $variant 4 | minimum)" "$(column "$1" $variant 4 | maximum)" \
      "$(ratios "$1" $variant | median)" "$(ratios "$1" $variant | minimum)" "$(ratios "$1" $variant | maximum)" \
      "$(column "$1" $variant 6 | sort | uniq -c | sort -nr | awk 'NR == 1 {$1 = ""; print}')"
  done
}

echo "program,variant,round,seconds,share_percent,method" >"$csv"
for name in "${programs[@]}"; do
  [ -n "${real_size[$name]:-}" ] || { echo "real: no program '$name'; there are: ${real_programs[*]}" >&2; exit 2; }
  build_all "$name" || continue
  # shellcheck disable=SC2086
  share=$(loop_share "$work/profile/$name/$name" "${real_loops[$name]}" ${real_size[$name]})
  for round in $(seq "$rounds"); do
    run "$name" plain "$round" "$work/plain/$name/$name"
    for threads in 1 2; do
      run "$name" "threads-$threads" "$round" env OMP_NUM_THREADS=$threads "$work/redcc/$name/$name"
    done
  done
  table "$name"
  rm -f "$work/$name.expected"
done
echo "kept: $csv"
