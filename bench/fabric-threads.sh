# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Speed-up of whole runs of the cloth simulator by number of threads, for the paper's scenes, the large mesh and scenes
# of the gallery. Compares the seconds of all steps with those of the sequential program in the same round. The last
# state of each run must have the bits of the sequential program.
#   ROUNDS=3 THREADS="1 2 4 8 16" SCENES="tablecloth hanging sheet218k ball curtain scarf" STEPS=N
# THREADS: by default powers of two up to the number of cores. STEPS: steps of each scene (default: all; sheet218k:
# 5).
. bench/common.sh
rounds=${ROUNDS:-3}
threads=${THREADS:-$(for ((t = 1; t <= $(nproc); t *= 2)); do echo "$t"; done)}
scenes=${SCENES:-tablecloth hanging sheet218k ball curtain scarf}
serial=$build/examples/fabric/fabric-serial
parallel=$build/examples/fabric/fabric
csv=$results/fabric-threads.csv
load_note

# run VARIANT PROGRAM SCENE: prints the seconds of its steps
run() {
  local steps=()
  [ "$3" != sheet218k ] || steps=(--steps "${STEPS:-5}")
  [ -z "${STEPS:-}" ] || steps=(--steps "$STEPS")
  "$2" run "$3" -o "$work/$1" --progress none "${steps[@]}" >/dev/null
  jq .step_seconds "$work/$1/summary.json"
}

echo "scene,threads,round,serial_seconds,seconds,speed_up" >"$csv"
for round in $(seq "$rounds"); do
  for scene in $scenes; do
    expected=$(run serial "$serial" "$scene")
    for t in $threads; do
      given=$(OMP_NUM_THREADS=$t run parallel "$parallel" "$scene")
      "$serial" compare "$work/serial/final.state" "$work/parallel/final.state" >"$work/compared" ||
        { cat "$work/compared" >&2; echo "fabric-threads: $scene at $t threads: other bits" >&2; exit 1; }
      echo "$scene,$t,$round,$expected,$given,$(ratio "$expected" "$given")" >>"$csv"
    done
  done
done
for scene in $scenes; do
  for t in $threads; do
    ratios=$(awk -F, -v s="$scene" -v t="$t" '$1 == s && $2 == t {print $6}' "$csv")
    printf '%-12s %2d threads: %.2f (%.2f to %.2f) times the sequential program\n' "$scene" "$t" \
      "$(median <<<"$ratios")" "$(minimum <<<"$ratios")" "$(maximum <<<"$ratios")"
  done
done
echo "kept: $csv"
