#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What `fabric plan` says that a run takes is within a tenth of what it takes. Argument: FABRIC.
set -euo pipefail
fabric=$1
export OMP_NUM_THREADS=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# expect SCENE OPTION... The system counts a process's pages by processor, and is now and then some
# megabytes behind: what one of three runs takes will do.
expect() {
  local said taken run
  said=$("$fabric" plan "$@" | sed -n 's/^memory: .*a run \([0-9.]*\) MiB$/\1/p')
  for run in 1 2 3; do
    rm -rf "$work/run"
    "$fabric" run "$@" --steps 1 --frames 0 --progress none -o "$work/run" >/dev/null
    taken=$(jq '.most_memory_bytes / 1048576' "$work/run/summary.json")
    echo "$*: said $said MiB, taken $taken MiB"
    awk -v a="$said" -v b="$taken" 'BEGIN {exit !(b > 1 && a > 0.9 * b && a < 1.1 * b)}' && return
  done
  return 1
}
many=(--set mesh.vertices=6000 --set mesh.boundary=300)
expect patch
expect ball "${many[@]}" --set self_collision.gap=0.003
expect flag "${many[@]}" --set self_collision.gap=0 --set material.bend=0 --set material.bend_damping=0
expect hanging "${many[@]}" --set monitor.watch=off
