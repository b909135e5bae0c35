#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Every experiment on a tiny sheet, and advice from curves made up for it.
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

# Curves with slope 1 and 2: error = step, time = 1 / step; error = step^2, time = 10 / step.
head -n 1 dt/dt.csv >curves.csv
for steps in 10 100; do
  step=$(awk -v n=$steps 'BEGIN {print 0.25 / n}')
  awk -v n=$steps -v h="$step" 'BEGIN {
    printf "dt,flap,300,linear-euler,%g,1e-05,%d,0,1,0,%g,%g,1,,1,0.5,81.5,0,0\n", h, n, 1 / h, h
    printf "dt,flap,300,midpoint,%g,1e-06,%d,0,1,1,%g,%g,1,,1,0.5,81.5,0,0\n", h, n, 10 / h, h * h
    printf "dt,mat,300,midpoint,%g,1e-06,%d,0,1,1,%g,%g,1,,1,0.5,81.5,1,0\n", h, n, 10 / h, h * h}'
done >>curves.csv
advise=("$program" accuracy advise --curves curves.csv flap)
expect 0 "integrator      linear-euler (order 1.00 there)" "${advise[@]}" --error 1cm
expect 0 "step            0.01 s: 25 steps" "${advise[@]}" --error 1cm
expect 0 "time            100 s" "${advise[@]}" --error 0.01
expect 0 "measured on this scene on both sides" "${advise[@]}" --error 10mm
expect 0 "integrator      midpoint (order 2.00 there)" "${advise[@]}" --error 100um
expect 0 "continued past what was measured" "${advise[@]}" --error 1um
# The nearest scene is the one with contact where there is a collider, a sheet twice as long may be
# off by twice as much, and what it takes grows as vertices^1.5.
expect 0 "carried over from 'flap', the nearest that was measured, 2.0 unlike" "${advise[@]}" \
  --error 1mm --set mesh.vertices=1200
expect 0 "time            800 s" "${advise[@]}" --error 1cm --set mesh.vertices=1200
expect 0 "carried over from 'mat', the nearest that was measured, 5.0 unlike" "${advise[@]}" \
  --error 1mm --set mesh.vertices=1200 --set colliders='[{kind: plane, normal: [0, 0, 1]}]'
expect 0 "step            0.01 s: 25 steps" "${advise[@]}" --error 2cm --set mesh.side=1 \
  --set mesh.vertices=301 --set material.stretch=200
expect 2 "--error is '1parsec'" "$program" accuracy advise flap --error 1parsec
expect 2 "--error is '-1'" "$program" accuracy advise flap --error -1
expect 2 "advise needs --error and a scene" "$program" accuracy advise flap
expect 2 "which experiment?" "$program" accuracy
expect 2 "the experiment is 'dd', expected one of 'dt'" "$program" accuracy dd
expect 1 "none.csv: cannot be read" "$program" accuracy advise flap --error 1mm --curves none.csv
head -n 1 curves.csv >empty.csv
expect 1 "no curve of any integrator" "$program" accuracy advise flap --error 1mm --curves empty.csv

# What is advised can be run as it is printed, and the curves that are installed serve.
settings=$("$program" accuracy advise --error 1mm flap | tail -n 1)
# shellcheck disable=SC2086
expect 0 "" "$program" run flap $settings --frames 0 --progress none -o advised
finish
