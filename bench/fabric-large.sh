# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Runs the paper's large mesh (218272 vertices) on one core with each preconditioner, for several step lengths and two
# tolerances, and once with the direct solver. Columns: seconds per step (without making the mesh), iterations per step,
# number of steps repeated at half the length, and peak memory. A run that takes longer than LIMIT seconds is stopped,
# and its line has no figures. The direct solver runs one step of the first length, with OpenBLAS if it is installed.
#   STEPS=2 LIMIT=400 STEP_LENGTHS="0.001 0.01 0.033" TOLERANCES="1e-2 1e-6"
. bench/common.sh
steps=${STEPS:-2}
limit=${LIMIT:-400}
read -r -a lengths <<<"${STEP_LENGTHS:-0.001 0.01 0.033}"
read -r -a tolerances <<<"${TOLERANCES:-1e-2 1e-6}"
export FABRIC_SCENES=$PWD/examples/fabric/scenes
csv=$results/fabric-large.csv
load_note
use_openblas

# run LENGTH TOLERANCE NAME SETTING...: adds one line to the table
run() {
  local length=$1 tolerance=$2 name=$3 figures=',,,'
  shift 3
  if timeout "$limit" "$build/examples/fabric/fabric-serial" run sheet218k --steps "$steps" \
    --set time.step="$length" --set solution.tolerance="$tolerance" "$@" \
    -o "$work/run" --frames 0 --progress none >"$work/log" 2>&1; then
    figures=$(jq -r '.steps as $s | [.step_seconds / $s.taken, .cg_iterations / $s.taken, $s.rejected,
      (.most_memory_bytes / 1048576 | floor)] | join(",")' "$work/run/summary.json")
  fi
  echo "$length,$tolerance,$name,$figures" >>"$csv"
}

echo "step,tolerance,solution,seconds_a_step,iterations_a_step,rejected,most_memory_MiB" >"$csv"
for length in "${lengths[@]}"; do
  for tolerance in "${tolerances[@]}"; do
    for name in none jacobi block-jacobi gauss-seidel incomplete-cholesky; do
      run "$length" "$tolerance" "$name" --set solution.preconditioner=$name
    done
  done
done
# A direct solution is one factorisation per step, whatever the step's length, so one step suffices.
steps=1
run "${lengths[0]}" "${tolerances[0]}" direct --set solution.method=direct
sed 's/,,/, ,/g; s/,,/, ,/g' "$csv" | column -s, -t
echo "kept: $csv"
