#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Every experiment on a tiny sheet, and advice.
# Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"
view=${program%/*}/fabric-view
small=(--quick --most-steps 16 --set mesh.boundary=16 --set mesh.vertices=60)

for name in dt cg newton preconditioner precision solver mesh sum horizon integrator; do
  expect 0 "tables are in $name" "$program" accuracy $name -o $name "${small[@]}"
  ! command -v gnuplot >/dev/null || expect 0 "drawn in $name" "$view" plot $name
done
for name in dt cg newton preconditioner precision solver mesh sum horizon; do
  holds "$name leaves a table" test -s $name/$name.csv
done
expect 1 "no table of 'fabric accuracy' in it" "$view" plot "$scenes"
holds "energy and robustness have a table each" test -s integrator/energy.csv -a -s integrator/robustness.csv

# number FILE VARIANT STEPS COLUMN: one number of a table
number() { awk -F, -v v="$2" -v s="$3" -v c="$4" '$4 == v && $7 == s {print $c; exit}' "$1"; }
less() { awk -v a="$1" -v b="$2" 'BEGIN {exit !(a != "" && b != "" && a + 0 < b + 0)}'; }
holds "the scene as it is, and four integrators at three steps" test "$(wc -l <dt/dt.csv)" -eq 14
holds "the scene as it is has its own steps" test "$(awk -F, '$4 == "default" {print $7}' dt/dt.csv)" -ge 25
for integrator in linear-euler euler bdf2 midpoint; do
  holds "$integrator: a smaller step, a smaller error" \
    less "$(number dt/dt.csv $integrator 16 12)" "$(number dt/dt.csv $integrator 8 12)"
done
holds "the midpoint is more exact than backward Euler" \
  less "$(number dt/dt.csv midpoint 16 12)" "$(number dt/dt.csv euler 16 12)"
holds "so do its energy and its strain" awk -F, '$4 == "midpoint" && !($20 > 0 && $20 < 0.1 && $21 > 0 && $21 < 0.1) {bad = 1}
  END {exit bad}' dt/dt.csv
holds "nothing goes into bodies where there are none" awk -F, 'NR > 1 && $22 != 0 {bad = 1} END {exit bad}' dt/dt.csv
holds "direct and iterative at two steps, the direct one without iterations of its own" \
  awk -F, 'NR > 1 {rows[$4]++} $4 == "direct" && $9 > $7 {bad = 1}
    END {exit bad || rows["direct"] != 2 || rows["gauss-seidel to 1e-2"] != 2}' solver/solver.csv
holds "17 runs whose starts are 1e-9 m apart, and that part no further here" \
  awk -F, 'NR > 1 && $2 > 0 && !($3 > 0 && $3 < 1e-7) || $2 == 0 && $3 != 0 {bad = 1}
    END {exit bad || (NR - 1) % 17 != 0 || NR < 18}' horizon/horizon.csv
holds "the runs in other orders are the same cloth" \
  awk -F, 'NR > 1 && $7 > 1e-6 {bad = 1} END {exit bad || NR != 19}' sum/sum.csv

expect 2 "--error is '1parsec'" "$program" accuracy advise flap --error 1parsec
expect 2 "--error is '-1'" "$program" accuracy advise flap --error -1
expect 2 "advise needs --error and a scene" "$program" accuracy advise flap
expect 2 "which experiment?" "$program" accuracy
expect 2 "the experiment is 'dd', expected one of 'dt'" "$program" accuracy dd

# What is advised can be run as it is printed; what cannot be had is refused (app_advise.c has ten
# scenes).
tiny=(--set mesh.boundary=16 --set mesh.vertices=60)
settings=$("$program" accuracy advise --error 5mm flap "${tiny[@]}" | tail -n 1)
# shellcheck disable=SC2086
expect 0 "" "$program" run flap "${tiny[@]}" $settings --frames 0 --progress none -o advised
expect 1 "flap: no advice for 1e-06 m" "$program" accuracy advise --error 1um flap "${tiny[@]}" --most-steps 20
# A reference that two methods do not agree on is not shown errors by: swings of 3 s in coarse steps.
tiny=(--set mesh.boundary=8 --set mesh.vertices=20)
expect 1 "the reference is not to be relied on" "$program" accuracy dt "${tiny[@]}" \
  --set time.steps=300 --set surroundings.drag=0.01 --most-steps 8 -o doubted
# Nor by one that did not come to its end.
expect 1 "there is no reference" "$program" accuracy dt "${tiny[@]}" --set time.steps=3 --set time.step=1e5 \
  --most-steps 8 -o none
finish
