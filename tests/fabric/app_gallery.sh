#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Every scene that comes with the program, made small: every bit is the serial program's at 1, 2, 3, 8
# and 16 threads. Arguments: SERIAL PARALLEL SCENES FOLDER.
export OMP_WAIT_POLICY=passive # a thread that waits does not take the core of one that works
serial=$1 parallel=$2
shift
source "$(dirname "$0")/app_common.sh"

for scene in tablecloth hanging flag ball curtain ring scarf flap patch poles sheet218k; do
  run=(run $scene --steps 8 --frames 0 --progress none --set mesh.boundary=40
    --set mesh.vertices=150)
  case $scene in
    flag) run+=(--set surroundings.wind_from=0.1) ;;
    tablecloth) run+=(--set mesh.origin="[0, 0, 0.9]") ;; # contact from the start
    ball) run+=(--set mesh.origin="[0, 0, 0.75]") ;;
    ring) run+=(--set mesh.origin="[0, 0, 0.6]") ;;
    poles) run+=(--set mesh.origin="[0.05, 0.02, 0.71]") ;;
    # A mesh from a file is as large as it is.
    scarf) run=(run scarf --steps 24 --frames 0 --progress none) ;;
    curtain) run+=(--set pins.1.move_from=0) ;;
  esac
  expect 0 "" "$serial" "${run[@]}" -o serial-$scene
  for threads in 1 2 3 8 16; do
    same_bits serial-$scene "$parallel" "${run[@]}" --threads $threads
  done
done
holds "no scene is left out" test "$(ls -d serial-* | wc -l)" = "$(ls "$scenes"/*.yaml | wc -l)"
holds "the ball is met" jq -e '[.effects[] | select(.name == "contact")][0].visited > 0' \
  serial-ball/summary.json >/dev/null
holds "the poles are met" jq -e '[.effects[] | select(.name == "contact")][0].visited > 0' \
  serial-poles/summary.json >/dev/null
holds "the flag is blown" jq -e '[.effects[] | select(.name == "wind")][0].visited > 0' \
  serial-flag/summary.json >/dev/null
holds "the scarf is looked through" \
  jq -e '[.effects[] | select(.name == "self-collision")][0].visited > 0' \
  serial-scarf/summary.json >/dev/null
holds "the curtain is looked through" \
  jq -e '[.effects[] | select(.name == "self-collision")][0].visited > 0' \
  serial-curtain/summary.json >/dev/null
finish
