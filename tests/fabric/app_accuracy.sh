#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Every experiment on a tiny sheet, and advice.
# Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"
small=(--quick --most-steps 16 --set mesh.boundary=16 --set mesh.vertices=60)

for name in dt cg newton preconditioner precision mesh sum integrator; do
  expect 0 "tables and plots are in $name" "$program" accuracy $name -o $name "${small[@]}"
  holds "$name leaves its script" test -s $name/$name.gnuplot
done
for name in dt cg newton preconditioner precision mesh sum; do
  holds "$name leaves a table" test -s $name/$name.csv
done
holds "energy and robustness have a table each" test -s integrator/energy.csv -a -s integrator/robustness.csv

# number FILE VARIANT STEPS COLUMN: one number of a table
number() { awk -F, -v v="$2" -v s="$3" -v c="$4" '$4 == v && $7 == s {print $c; exit}' "$1"; }
less() { awk -v a="$1" -v b="$2" 'BEGIN {exit !(a != "" && b != "" && a + 0 < b + 0)}'; }
holds "four integrators at three steps" test "$(wc -l <dt/dt.csv)" -eq 13
for integrator in linear-euler euler bdf2 midpoint; do
  holds "$integrator: a smaller step, a smaller error" \
    less "$(number dt/dt.csv $integrator 16 12)" "$(number dt/dt.csv $integrator 8 12)"
done
holds "the midpoint is more exact than backward Euler" \
  less "$(number dt/dt.csv midpoint 16 12)" "$(number dt/dt.csv euler 16 12)"
holds "the runs in other orders are the same cloth" \
  awk -F, 'NR > 1 && $7 > 1e-6 {bad = 1} END {exit bad || NR != 19}' sum/sum.csv

expect 2 "--error is '1parsec'" "$program" accuracy advise flap --error 1parsec
expect 2 "--error is '-1'" "$program" accuracy advise flap --error -1
expect 2 "advise needs --error and a scene" "$program" accuracy advise flap
expect 2 "which experiment?" "$program" accuracy
expect 2 "the experiment is 'dd', expected one of 'dt'" "$program" accuracy dd

# What is advised can be run as it is printed; what cannot be had is refused (app_advise.c has ten
# scenes). Differences of a cloth that lands go on growing: there is no millimetre after 2 s.
tiny=(--set mesh.boundary=16 --set mesh.vertices=60)
settings=$("$program" accuracy advise --error 5mm flap "${tiny[@]}" | tail -n 1)
# shellcheck disable=SC2086
expect 0 "" "$program" run flap "${tiny[@]}" $settings --frames 0 --progress none -o advised
expect 1 "tablecloth: no advice for 0.0001 m" "$program" accuracy advise --error 100um tablecloth "${tiny[@]}" \
  --most-steps 152
# A reference that two methods do not agree on is not shown errors by.
expect 1 "the reference is not to be relied on" "$program" accuracy dt --scene tablecloth "${tiny[@]}" \
  --set time.steps=30 --most-steps 8 -o doubted
finish
