#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What `fabric plan` says that a run takes is within a tenth of what it takes, and a command that
# simulates nothing loads little. Argument: FABRIC.
set -euo pipefail
fabric=$1
export OMP_NUM_THREADS=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# expect STEPS SCENE OPTION...: by the end of so many steps. The system counts a process's pages by
# processor, and is now and then some megabytes behind: what one of three runs takes will do.
expect() {
  local steps=$1 said taken run
  shift
  said=$("$fabric" plan "$@" | sed -n 's/^memory: //p')
  for run in 1 2 3; do
    rm -rf "$work/run"
    "$fabric" run "$@" --steps "$steps" --frames 0 --progress none -o "$work/run" >/dev/null
    taken=$(jq '.most_memory_bytes / 1048576' "$work/run/summary.json")
    echo "$*: $said; taken $taken"
    awk -v said="$said" -v taken="$taken" 'BEGIN {
      match(said, /a run [0-9.]+/); a = substr(said, RSTART + 6, RLENGTH - 6) + 0
      exit !(taken > 1 && a > 0.9 * taken && a < 1.1 * taken)}' && return
  done
  return 1
}
many=(--set mesh.vertices=6000 --set mesh.boundary=300)
expect 1 patch
expect 2 tablecloth
expect 2 curtain
expect 2 scarf
expect 2 patch --set solution.method=direct
expect 1 ball "${many[@]}" --set self_collision.gap=0.003
expect 1 flag "${many[@]}" --set self_collision.gap=0 --set material.bend=0 --set material.bend_damping=0
expect 1 hanging "${many[@]}" --set monitor.watch=off
expect 1 hanging "${many[@]}" --set solution.method=direct
expect 1 flap "${many[@]}" --set solution.method=direct
expect 1 flap "${many[@]}" --set solution.preconditioner=jacobi --set time.integrator=midpoint
expect 1 flap "${many[@]}" --set solution.preconditioner=incomplete-cholesky
if command -v valgrind >/dev/null; then
  count=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$fabric" --version 2>&1 |
    awk '/Collected/ {print $4}')
  echo "--version: $count instructions"
  ((count > 1000000 && count < 5000000))
fi
