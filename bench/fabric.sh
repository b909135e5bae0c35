# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Compares the cloth simulator with its serial build (same sources, same optimisation): the force loops of the large
# mesh, and whole runs of the paper's scenes. The programs take turns in each round; each ratio is of two runs of the
# same round.
#   ROUNDS=5 STEPS=30   (steps of the large mesh; in the second and fourth, `auto` times parts of the loops)
# The scenes, of a second each, have three times as many rounds.
. bench/common.sh
rounds=${ROUNDS:-5}
steps=${STEPS:-30}
export FABRIC_SCENES=$PWD/examples/fabric/scenes
threads=$(nproc)
serial=$build/examples/fabric/fabric-serial
parallel=$build/examples/fabric/fabric
csv=$results/fabric.csv
echo "experiment,variant,round,seconds" >"$csv"
load_note

force_seconds='[.effects[] | select(.name == "stretch" or .name == "shear" or .name == "bend" or .name == "drag") | .seconds] | add'

# run EXPERIMENT VARIANT ROUND JQ-FILTER COMMAND... : makes a run and adds one line to the table
run() {
  local experiment=$1 variant=$2 round=$3 filter=$4
  shift 4
  "$@" -o "$work/$variant" --progress none >/dev/null
  echo "$experiment,$variant,$round,$(jq "$filter" "$work/$variant/summary.json")" >>"$csv"
}

# ratios EXPERIMENT VARIANT: prints the seconds of the serial build divided by the variant's, round by round
ratios() {
  awk -F, -v e="$1" -v v="$2" '$1 == e && $2 == "serial" {s[$3] = $4} $1 == e && $2 == v {p[$3] = $4}
    END {for (r in p) if (p[r] > 0) print s[r] / p[r]}' "$csv"
}
seconds() { awk -F, -v e="$1" -v v="$2" '$1 == e && $2 == v {print $4}' "$csv"; }
line() {
  printf '%-34s %-12s %9.4f s   ratio %.3f  (%.3f to %.3f)\n' "$1" "$2" "$(seconds "$1" "$2" | median)" \
    "$(ratios "$1" "$2" | median)" "$(ratios "$1" "$2" | minimum)" "$(ratios "$1" "$2" | maximum)"
}

# An upper bound of the speed-up: the sequential program runs on every core at once, each copy with a separate mesh.
# Memory and other users of the machine slow the copies down, and no parallel program can avoid that.
run_crowd() { # EXPERIMENT ROUND ARGUMENTS...: adds the slowest program's seconds divided by the number of programs
  local experiment=$1 round=$2 core slowest
  shift 2
  for core in $(seq "$threads"); do
    "$serial" "$@" -o "$work/crowd-$core" --progress none >/dev/null &
  done
  wait
  slowest=$(jq -s "map($force_seconds) | max" "$work"/crowd-*/summary.json)
  echo "$experiment,crowd,$round,$(jq -n "$slowest / $threads")" >>"$csv"
}

# Only the force loops are timed. A short time step shortens the rest of the run, which is mostly conjugate gradients.
large=(run sheet218k --steps "$steps" --set time.step=0.0002)
for round in $(seq "$rounds"); do
  run forces-218k serial "$round" "$force_seconds" "$serial" "${large[@]}"
  run forces-218k threads-1 "$round" "$force_seconds" env OMP_NUM_THREADS=1 "$parallel" "${large[@]}"
  run forces-218k "threads-$threads" "$round" "$force_seconds" \
    env OMP_NUM_THREADS="$threads" "$parallel" "${large[@]}"
  run_crowd forces-218k "$round" "${large[@]}"
done
# A run of one step inspects each loop once; it is compared with one sequential execution of the loop.
one=(run sheet218k --steps 1 --set time.step=0.0002)
for round in 1 2 3; do
  run one-step serial "$round" "$force_seconds" "$serial" "${one[@]}"
  REDCC_REPORT=$work/report.json run one-step "threads-$threads" "$round" "$force_seconds" \
    env OMP_NUM_THREADS="$threads" "$parallel" "${one[@]}"
  jq -rn --arg r "$round" --slurpfile report "$work/report.json" --slurpfile s "$work/serial/summary.json" '
    ($s[0].effects | map({(.name): .seconds}) | add) as $e
    | {"triangle_forces": ($e.stretch + $e.shear), "hinge_forces": $e.bend, "drag_forces": $e.drag} as $of
    | $report[0].loops[] | select($of[.function])
    | "inspector,\(.function),\($r),\(.inspect_seconds / $of[.function])"' >>"$csv"
done
for scene in tablecloth hanging; do
  for round in $(seq $((3 * rounds))); do
    run "$scene" serial "$round" .step_seconds "$serial" run "$scene"
    run "$scene" threads-1 "$round" .step_seconds env OMP_NUM_THREADS=1 "$parallel" run "$scene"
    run "$scene" "threads-$threads" "$round" .step_seconds env OMP_NUM_THREADS="$threads" "$parallel" run "$scene"
  done
done
for round in $(seq "$rounds"); do
  run tablecloth-1e-2 serial "$round" .step_seconds "$serial" run tablecloth --set solution.tolerance=1e-2
done

echo "seconds (median) and serial over variant, round by round (median, least to greatest)"
for experiment in forces-218k tablecloth hanging; do
  for variant in serial threads-1 "threads-$threads"; do line "$experiment" "$variant"; done
  [ "$experiment" != forces-218k ] || line "$experiment" crowd
done
echo "one inspection, as a share of one sequential execution of its loop:"
awk -F, '$1 == "inspector" {print $2}' "$csv" | sort -u | while read -r loop; do
  printf '  %-32s %.4f\n' "$loop" "$(seconds inspector "$loop" | median)"
done
printf 'tablecloth at tolerance 1e-2, one core: %.3f s (Blender 3.4, a simpler model: 0.95 s)\n' \
  "$(seconds tablecloth-1e-2 serial | median)"
echo "kept: $csv"
