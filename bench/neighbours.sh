# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The effect of busy neighbours on a loop that gains by running in parallel (bench/neighbours.c), for several settings
# of how OpenMP's threads wait between regions. The neighbours are zero, one or two compute-bound processes. Each ratio
# is of a sequential run and the parallel run directly after it, with the same neighbours; rounds are interleaved. The
# last column is how often per second a thread lost its core.
#   ROUNDS=9 NEIGHBOURS="0 1 2" METHODS="auto localwrite-steal" WAITS="default passive ..."
. bench/common.sh
rounds=${ROUNDS:-9}
read -r -a neighbours <<<"${NEIGHBOURS:-0 1 2}"
read -r -a methods <<<"${METHODS:-auto localwrite-steal}"
read -r -a waits <<<"${WAITS:-default active passive spin-1000 spin-10000}"
sizes=("100000 200" "1000000 20") # iterations and executions; an execution takes 0.5 or 5 ms
csv=$results/neighbours.csv
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
gcc -O2 -ffp-contract=off bench/neighbours.c -lm -o "$work/sequential"
"$prefix/bin/redcc-cc" -O2 -ffp-contract=off bench/neighbours.c -lm -o "$work/parallel"
load_note
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-$(nproc)}

busy=()
start_neighbours() { # COUNT
  for ((i = 0; i < $1; i++)); do
    sh -c 'while :; do :; done' &
    busy+=($!)
  done
}
stop_neighbours() {
  [ ${#busy[@]} -eq 0 ] || { kill "${busy[@]}" && wait "${busy[@]}" 2>/dev/null; } || true
  busy=()
}
trap 'stop_neighbours; rm -rf "$work"' EXIT

run_parallel() { # WAIT METHOD ITERATIONS EXECUTIONS
  local settings=(REDCC_METHOD="$2")
  case $1 in
    default) ;;
    spin-*) settings+=(GOMP_SPINCOUNT="${1#spin-}") ;;
    *) settings+=(OMP_WAIT_POLICY="$1") ;;
  esac
  env -u OMP_WAIT_POLICY -u GOMP_SPINCOUNT "${settings[@]}" "$work/parallel" "$3" "$4"
}

raw=$work/raw # columns: neighbours, iterations, wait, method, ratio, losses
for round in $(seq "$rounds"); do
  for count in "${neighbours[@]}"; do
    start_neighbours "$count"
    for size in "${sizes[@]}"; do
      read -r iterations executions <<<"$size"
      for wait in "${waits[@]}"; do
        for method in "${methods[@]}"; do
          read -r seconds bits _ < <("$work/sequential" "$iterations" "$executions")
          read -r given given_bits losses < <(run_parallel "$wait" "$method" "$iterations" "$executions")
          [ "$bits" = "$given_bits" ] || { echo "neighbours: $method, $wait: other bits" >&2; exit 1; }
          echo "$count $iterations $wait $method $(ratio "$seconds" "$given") $losses" >>"$raw"
        done
      done
    done
    stop_neighbours
  done
  echo "round $round of $rounds"
done
echo "neighbours,iterations,wait,method,speed_up,lowest,highest,cores_lost_a_second" >"$csv"
column() { awk -v n="$1" -v s="$2" -v w="$3" -v m="$4" -v f="$5" '$1 == n && $2 == s && $3 == w && $4 == m {print $f}' "$raw"; }
for count in "${neighbours[@]}"; do
  for size in "${sizes[@]}"; do
    for wait in "${waits[@]}"; do
      for method in "${methods[@]}"; do
        ratios=$(column "$count" "${size% *}" "$wait" "$method" 5)
        printf '%s,%s,%s,%s,%.3f,%.3f,%.3f,%.0f\n' "$count" "${size% *}" "$wait" "$method" \
          "$(median <<<"$ratios")" "$(minimum <<<"$ratios")" "$(maximum <<<"$ratios")" \
          "$(column "$count" "${size% *}" "$wait" "$method" 6 | median)"
      done
    done
  done
done | tee -a "$csv"
echo "kept: $csv"
