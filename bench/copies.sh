# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Runs many copies of a program at once, and one copy while other processes compute. Prints the seconds of the
# sequential program divided by those of the parallel one, in the default environment. springs is bench/neighbours.c,
# which has only redcc's parallel loops; fabric also has OpenMP regions of its own. Rounds are interleaved.
#   ROUNDS=5 COPIES=8 SPINNING=3 STEPS=152 EXECUTIONS=300
. bench/common.sh
csv=$results/copies.csv
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
gcc -O2 -ffp-contract=off bench/neighbours.c -lm -o "$work/springs-serial"
"$prefix/bin/redcc-cc" -O2 -ffp-contract=off bench/neighbours.c -lm -o "$work/springs"
load_note
unset OMP_WAIT_POLICY GOMP_SPINCOUNT

busy=()
stop() {
  [ ${#busy[@]} -eq 0 ] || { kill "${busy[@]}" && wait "${busy[@]}" 2>/dev/null; } || true
  busy=()
}
trap 'stop; rm -rf "$work"' EXIT

run() { # PROGRAM SUFFIX COPY
  case $1 in
    springs) "$work/springs$2" 1000000 "${EXECUTIONS:-300}" ;;
    fabric) "$prefix/bin/fabric$2" run examples/fabric/scenes/tablecloth.yaml --steps "${STEPS:-152}" --frames 0 \
      --progress none -o "$work/run$2-$3" ;;
  esac >/dev/null
}
seconds() { # COPIES PROGRAM SUFFIX
  local began started=() copy
  began=$(date +%s.%N)
  for ((copy = 0; copy < $1; copy++)); do
    run "$2" "$3" "$copy" &
    started+=($!)
  done
  wait "${started[@]}"
  awk -v began="$began" -v now="$(date +%s.%N)" 'BEGIN { printf "%.3f", now - began }'
}

raw=$work/raw
for ((round = 0; round < ${ROUNDS:-5}; round++)); do
  for program in springs fabric; do
    for beside in 0 "${SPINNING:-3}"; do
      copies=${COPIES:-8}
      [ "$beside" -eq 0 ] || copies=1
      for ((i = 0; i < beside; i++)); do
        sh -c 'while :; do :; done' &
        busy+=($!)
      done
      serial=$(seconds "$copies" "$program" -serial)
      parallel=$(seconds "$copies" "$program" "")
      stop
      echo "$program $copies $beside $(ratio "$serial" "$parallel")" >>"$raw"
    done
  done
done
echo "program,copies,spinning,ratio,low,high" | tee "$csv"
sort -k1,3 -k4,4n "$raw" | awk '
  function finish() { if (n) print group "," v[int((n + 1) / 2)] "," v[1] "," v[n] }
  { key = $1 "," $2 "," $3; if (key != group) { finish(); group = key; n = 0 } v[++n] = $4 }
  END { finish() }' | tee -a "$csv"
echo "kept: $csv"
