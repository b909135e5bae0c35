#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Programs with MPI behind redcc-cc: docs/mpi.md by Open MPI, its example once more by MPICH.
# BUILD, BLOCKS and DOCUMENT as document.sh has them; skipped where neither is there.
for tool in mpicc.openmpi mpirun.openmpi jq cmake; do
  command -v $tool >/dev/null || { echo "SKIPPED: needs $tool"; exit 77; }
done
. "$(dirname "$0")/library.sh"
PREFIX=$(mktemp -d)
trap 'rm -rf "$work" "$PREFIX"' EXIT
install_tree "$BUILD" "$PREFIX"
export PREFIX OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_WAIT_POLICY=passive
"$(dirname "$0")/document.sh" || fail "$DOCUMENT"

command -v mpicc.mpich >/dev/null && command -v mpiexec.mpich >/dev/null ||
  { echo "not tried: MPICH"; finish; }
begin MPICH
export PATH="$PREFIX/bin:$PATH"
awk '/^```$/ { on = 0 } on { print } $0 == "```c histogram.c" { on = 1 }' "$DOCUMENT" >histogram.c
MPICH_CC=gcc mpicc.mpich -O2 histogram.c -o plain || fail "mpicc.mpich"
MPICH_CC=redcc-cc mpicc.mpich -O2 histogram.c -o parallel || fail "mpicc.mpich behind redcc-cc"
for ranks in 1 2; do
  mpiexec.mpich -n $ranks ./plain >expected || fail "plain, $ranks ranks"
  for threads in 1 2; do
    mpiexec.mpich -n $ranks -genv OMP_NUM_THREADS $threads -genv REDCC_REPORT "$PWD/report-%p.json" \
      ./parallel >out || fail "$ranks ranks, $threads threads"
    expect_same expected out
    expect_equal "reports of $ranks ranks" $ranks "$(cat report-*.json | grep -c '"function": "fill"')"
    rm report-*.json
  done
done
end
finish
