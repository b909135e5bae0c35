# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times loops whose iterations update common elements (bench/meet/*.c): compiled unchanged by redcc-cc, with two
# threads and with one, and parallelised by hand with two, against the serial build. Measures the total time of N
# calls from the first one on. The programs of a round run one after the other, in the reverse order in every other
# round. Each ratio is of two runs of the same round; the table has the ratios' medians, minima and maxima. of_hand is
# the time of the loop by hand divided by redcc's. Results are compared bit for bit.
#   ROUNDS=5 CALLS="1 3 10 20" KINDS="pairs pairs-1000 ..." THREADS=2
. bench/common.sh
rounds=${ROUNDS:-5}
read -r -a calls <<<"${CALLS:-1 3 10 20}"
read -r -a kinds <<<"${KINDS:-pairs pairs-1000 energy cells bonds windows kmeans push halflist distances}"
threads=${THREADS:-2}
csv=$results/meet.csv
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
for kind in "${kinds[@]}"; do
  points=()
  [ "${kind%-*}" = "$kind" ] || points=("-DPOINTS=${kind#*-}")
  sources=("bench/meet/${kind%-*}.c" bench/meet/main.c)
  gcc -O3 "${points[@]}" "${sources[@]}" -lm -o "$work/$kind-serial"
  gcc -O3 -fopenmp -DBY_HAND "${points[@]}" "${sources[@]}" -lm -o "$work/$kind-hand"
  "$prefix/bin/redcc-cc" -O3 "${points[@]}" "${sources[@]}" -lm -o "$work/$kind-redcc"
done
unset REDCC_METHOD
load_note

status=0
raw=$work/raw # columns: kind, variant, calls, serial_seconds, seconds, hand_seconds
by() { # VARIANT THREADS PROGRAM
  OMP_NUM_THREADS=$2 "$work/$kind-$3" "${calls[@]}" >"$work/$1"
}
compare() { # VARIANT
  paste -d' ' "$work/serial" "$work/$1" "$work/hand" |
    awk -v kind="$kind" -v variant="$1" '
      $3 != $6 {print "meet: " kind " by " variant ": other bits" >"/dev/stderr"; bad = 1}
      {print kind, variant, $1, $2, $5, $8}
      END {exit bad}' >>"$raw"
}
for round in $(seq "$rounds"); do
  for kind in "${kinds[@]}"; do
    order=("serial 1 serial" "redcc $threads redcc" "hand $threads hand" "redcc-1 1 redcc")
    ((round % 2)) || order=("${order[3]}" "${order[2]}" "${order[1]}" "${order[0]}")
    # shellcheck disable=SC2086
    for one in "${order[@]}"; do by $one; done
    for variant in redcc redcc-1 hand; do compare "$variant" || status=1; done
  done
done
# values VARIANT EXPRESSION: prints the expression's value for each round of $kind and $count
values() { awk -v k="$kind" -v v="$1" -v c="$count" "\$1 == k && \$2 == v && \$3 == c {print $2}" "$raw"; }
spread() { # VARIANT EXPRESSION
  local all
  all=$(values "$@")
  printf ',%.3f,%.3f,%.3f' "$(median <<<"$all")" "$(minimum <<<"$all")" "$(maximum <<<"$all")"
}
head=kind,calls,serial_ms
for name in redcc one_thread by_hand of_hand; do head+=,$name,low,high; done
echo "$head" >"$csv"
for kind in "${kinds[@]}"; do
  for count in "${calls[@]}"; do
    printf '%s,%s,%.2f' "$kind" "$count" "$(values redcc '1e3 * $4' | median)"
    for variant in redcc redcc-1 hand; do spread "$variant" '$4 / $5'; done
    spread redcc '$6 / $5'
    echo
  done
done >>"$csv"
column -s, -t "$csv"
echo "kept: $csv"
exit $status
