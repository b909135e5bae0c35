# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Cost and gain of redcc from the first execution on: the total time of N executions of typical loops
# (bench/choice.c), most of which are not worth running in parallel. Each loop is run by `auto`, by each named method,
# and sequentially. The programs take turns in each round; the sequential one is first in every other round and last
# in the rest. Each ratio is of two runs of the same round; the table has the ratios' medians, minima and maxima.
# Results are compared bit for bit. The loops named -short take 0.1 to 0.3 ms and are parts of other loops; they need
# CALLS="400 4000 20000". force and springs resemble the heavy and the light loop of `script/bench methods`; the
# matrix of force has one block per node. NEIGHBOURS: number of compute-bound processes that run all the time, also
# beside the sequential program.
#   ROUNDS=5 CALLS="1 3 10 40 400" LOOPS="count pairs ..." METHODS="auto localwrite ..."
#   NEIGHBOURS=0
. bench/common.sh
rounds=${ROUNDS:-5}
read -r -a calls <<<"${CALLS:-1 3 10 40 400}"
read -r -a loops <<<"${LOOPS:-count pairs weights charge columns force-sorted force-shuffled springs-sorted springs-shuffled force-short springs-short columns-short gaxpy-sorted gaxpy-shuffled}"
read -r -a methods <<<"${METHODS:-auto localwrite graph-localwrite wavefront}"
neighbours=${NEIGHBOURS:-0}
csv=$results/choice.csv
[ "$neighbours" -eq 0 ] || csv=$results/choice-beside-$neighbours.csv
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
flags=(-O2 -ffp-contract=off)
gcc "${flags[@]}" bench/choice.c -lm -o "$work/sequential"
"$prefix/bin/redcc-cc" "${flags[@]}" bench/choice.c -lm -o "$work/redcc"
load_note
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-$(nproc)}

busy=()
for ((i = 0; i < neighbours; i++)); do
  sh -c 'while :; do :; done' &
  busy+=($!)
done
trap '[ ${#busy[@]} -eq 0 ] || kill "${busy[@]}" 2>/dev/null; rm -rf "$work"' EXIT

raw=$work/raw # columns: loop, method, calls, ratio, seconds of the sequential program and of redcc's
sequentially() { "$work/sequential" "$loop" "${calls[@]}" >"$work/expected"; }
by() { # METHOD
  local chosen=(REDCC_METHOD="$1")
  [ "$1" != auto ] || chosen=(-u REDCC_METHOD) # unset, as in the default environment
  env "${chosen[@]}" "$work/redcc" "$loop" "${calls[@]}" >"$work/given-$1"
}
compare() { # METHOD
  paste -d' ' "$work/expected" "$work/given-$1" |
    awk -v loop="$loop" -v method="$1" '
      $3 != $6 {print "choice: " loop " by " method ": other bits" >"/dev/stderr"; bad = 1}
      {print loop, method, $1, $2 / $5, $2, $5}
      END {exit bad}' >>"$raw"
}
for round in $(seq "$rounds"); do
  for loop in "${loops[@]}"; do
    ((round % 2 == 0)) || sequentially
    for method in "${methods[@]}"; do by "$method"; done
    ((round % 2)) || sequentially
    for method in "${methods[@]}"; do compare "$method"; done
  done
  echo "round $round of $rounds"
done
echo "loop,method,calls,speed_up,lowest,highest,sequential_seconds,seconds" >"$csv"
column() { awk -v l="$1" -v m="$2" -v c="$3" -v f="$4" '$1 == l && $2 == m && $3 == c {print $f}' "$raw"; }
for loop in "${loops[@]}"; do
  for method in "${methods[@]}"; do
    for count in "${calls[@]}"; do
      ratios=$(column "$loop" "$method" "$count" 4)
      printf '%s,%s,%s,%.3f,%.3f,%.3f,%s,%s\n' "$loop" "$method" "$count" "$(median <<<"$ratios")" \
        "$(minimum <<<"$ratios")" "$(maximum <<<"$ratios")" \
        "$(column "$loop" "$method" "$count" 5 | median)" "$(column "$loop" "$method" "$count" 6 | median)"
    done
  done
done | tee -a "$csv"
echo "kept: $csv"
