# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The cost of serial bits (the bits of the sequential program) over MPI ranks. Compares fabric-mpi with --bits=serial,
# with --bits=any (solved by PETSc) and fabric-serial, in the same rounds, on the large mesh to the same tolerance. The
# preconditioner block-jacobi is the same in both programs. gauss-seidel is compared with PETSc's sor within each rank,
# and with PETSc's gamg (algebraic multigrid).
#   ROUNDS=3 STEPS=3 TOLERANCE=1e-6 SCENE=sheet218k RANKS="1 2"
#   MORE=1 adds the rounds to those in distributed.csv
# Seconds are wall time of the steps. On a busy machine they say little about runs over several ranks, which wait for
# each other. The table has the median, minimum and maximum of the rounds. distributed.csv has one line per run: solver,
# ranks (0: fabric-serial, without MPI), round, seconds, iterations, and the largest distance between a vertex and the
# same vertex of fabric-serial, in metres. Runs with --bits=serial must have the bits of fabric-serial.
. bench/common.sh
if ! command -v mpirun.openmpi >"$work/found" || ! pkg-config --exists PETSc; then
  echo "distributed: not measured: it needs Open MPI and PETSc, which script/distributed installs"
  exit 0
fi
rounds=${ROUNDS:-3} steps=${STEPS:-3} tolerance=${TOLERANCE:-1e-6} scene=${SCENE:-sheet218k}
read -r -a rank_counts <<<"${RANKS:-1 2}"
build=$PWD/build/distributed
cmake --preset release -B "$build" -DREDCC_MPI=ON >"$work/log"
cmake --build "$build" -j "$(nproc)" --target fabric-mpi fabric-serial >>"$work/log"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_WAIT_POLICY=passive OMP_NUM_THREADS=1
export FABRIC_SCENES=$PWD/examples/fabric/scenes
serial=$build/examples/fabric/fabric-serial ranked=$build/examples/fabric-mpi/fabric-mpi
csv=$results/distributed.csv
load_note

# start PROGRAM PRECONDITIONER PETSC_OPTIONS COMMAND...: runs the scene in $work/run
start() {
  local program=$1 kind=$2 chosen=$3
  shift 3
  PETSC_OPTIONS=$chosen "$@" "$program" run "$scene" --steps "$steps" --frames 0 --progress none \
    --set mesh.order=hilbert --set solution.tolerance="$tolerance" --set solution.preconditioner="$kind" \
    ${bits:+--bits=$bits} -o "$work/run" >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
}
launch() { echo "mpirun.openmpi --oversubscribe --bind-to none -n $1 -x PETSC_OPTIONS"; }

# measure ROUND VARIANT RANKS KIND OPTIONS: adds one line to distributed.csv; RANKS 0 is fabric-serial
measure() {
  local round=$1 variant=$2 ranks=$3 kind=$4 chosen=$5 program=$serial command=() distance=0
  if [ "$ranks" -gt 0 ]; then
    program=$ranked
    read -r -a command <<<"$(launch "$ranks")"
  fi
  start "$program" "$kind" "$chosen" "${command[@]}"
  if [ "$ranks" -eq 0 ]; then
    rm -rf "${work:?}/of-$kind"
    cp -r "$work/run" "$work/of-$kind"
  else
    "$serial" compare "$work/of-$kind/final.state" "$work/run/final.state" >"$work/compared" 2>&1 || true
    distance=$(awk '$1 == "positions:" {sub(/.* differ, by /, ""); print /equal/ ? 0 : $1 + 0}' "$work/compared")
    if [ "$bits" = serial ] && [ "$(grep -c 'equal, every bit' "$work/compared")" != 2 ]; then
      echo "distributed: $variant at $ranks ranks: other bits: $(cat "$work/compared")" >&2
      exit 1
    fi
  fi
  echo "$variant,$ranks,$round,$(jq -r '[.step_seconds, .cg_iterations] | join(",")' \
    "$work/run/summary.json"),$distance" >>"$csv"
}

[ -n "${MORE:-}" ] && [ -s "$csv" ] || echo "solution,ranks,round,seconds,iterations,distance_m" >"$csv"
done_before=$(awk -F, 'NR > 1 && $3 > most {most = $3} END {print most + 0}' "$csv")
for round in $(seq $((done_before + 1)) $((done_before + rounds))); do
  for kind in block-jacobi gauss-seidel; do
    bits="" measure "$round" "fabric-serial $kind" 0 $kind ""
    for ranks in "${rank_counts[@]}"; do
      bits=serial measure "$round" "serial $kind" "$ranks" $kind ""
      if [ $kind = block-jacobi ]; then
        bits=any measure "$round" "any pbjacobi" "$ranks" $kind ""
      else
        bits=any measure "$round" "any sor" "$ranks" $kind ""
        bits=any measure "$round" "any gamg" "$ranks" $kind "-pc_type gamg"
      fi
    done
  done
done

# column_of VARIANT RANKS NUMBER: prints column NUMBER of all rounds
column_of() { awk -F, -v v="$1" -v r="$2" -v c="$3" '$1 == v && $2 == r {print $c}' "$csv"; }
# against VARIANT RANKS VARIANT RANKS COLUMN: prints the ratio of the first to the second for each round that has both
against() {
  awk -F, -v v="$1" -v r="$2" -v w="$3" -v q="$4" -v c="$5" '$1 == v && $2 == r {one[$3] = $c}
    $1 == w && $2 == q {other[$3] = $c} END {for (n in one) if (n in other) print one[n] / other[n]}' "$csv"
}
spread() { sort -g | awk '{v[NR] = $1} END {printf "%.3g (%.3g to %.3g)", NR % 2 ? v[(NR+1)/2] : (v[NR/2]+v[NR/2+1])/2, v[1], v[NR]}'; }
echo "solution|ranks|seconds|iterations|farthest from fabric-serial"
cut -d, -f1,2 "$csv" | sed 1d | sort -u | while IFS=, read -r variant ranks; do
  echo "$variant|$ranks|$(column_of "$variant" "$ranks" 4 | spread)|$(
    column_of "$variant" "$ranks" 5 | median)|$(column_of "$variant" "$ranks" 6 | maximum) m"
done | sed 's/|0|/|-|/' >"$work/table"
column -t -s '|' "$work/table"
for kind in block-jacobi gauss-seidel; do
  echo "$kind: 1 rank over fabric-serial: $(against "serial $kind" 1 "fabric-serial $kind" 0 4 | spread)"
  for ranks in "${rank_counts[@]}"; do
    [ "$ranks" -eq 1 ] || echo "$kind: $ranks ranks, times as fast as 1: $(against "serial $kind" 1 "serial $kind" "$ranks" 4 | spread)"
    others=pbjacobi
    [ $kind = block-jacobi ] || others="sor gamg"
    for other in $others; do
      echo "$kind, $ranks ranks: the bits over any's $other: $(against "serial $kind" "$ranks" "any $other" "$ranks" 4 | spread)"
    done
  done
done
echo "kept: $csv"
