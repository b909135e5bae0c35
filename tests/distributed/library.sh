# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What the tests of fabric-mpi share. Given by ctest: SERIAL and RANKED, fabric-serial and fabric-mpi,
# and MPIEXEC, which starts ranks.
set -u
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_WAIT_POLICY=passive
unset PETSC_OPTIONS FABRIC_SCENES
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0
fail() {
  echo "FAIL: $*" >&2
  failed=1
}
finish() {
  [ $failed -eq 0 ] && echo "all passed"
  exit $failed
}

common=(--frames 0 --progress none)
jacobi=(--set solution.preconditioner=block-jacobi)

serial() { "$SERIAL" "$@" "${common[@]}" >>log 2>&1 || fail "fabric-serial $*: $(tail -n 3 log)"; }
# ranks RANKS THREADS ARGUMENTS...: fabric-mpi; what it says is in `said`
ranks() {
  local count=$1 threads=$2
  shift 2
  "$MPIEXEC" --oversubscribe --bind-to none -n "$count" -x "OMP_NUM_THREADS=$threads" "$RANKED" "$@" \
    >said 2>&1
}
# same WHAT FOLDER FOLDER: every bit of positions and velocities
same() {
  "$SERIAL" compare "$2/final.state" "$3/final.state" >compared 2>&1 &&
    [ "$(grep -c 'equal, every bit' compared)" = 2 ] || fail "$1: $(cat compared)"
}
