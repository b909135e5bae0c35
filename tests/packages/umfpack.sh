# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# UMFPACK (libumfpack5) for double and int, with its own loops in place of a BLAS: its demonstration,
# and umf4 on the matrices that come with it. What they print of time and memory is left out.
source_package=suitesparse
build_rounds=1
build() {
  local quiet=(CC="$CC" CFLAGS=-O2 OPTIMIZATION= CFOPENMP=)
  make_all make -C SuiteSparse_config -j "$jobs" "${quiet[@]}" static &&
    make_all make -C AMD/Lib -j "$jobs" "${quiet[@]}" static &&
    make_all make -C UMFPACK/Lib -j "$jobs" "${quiet[@]}" UMFPACK_CONFIG="-DNCHOLMOD -DNBLAS" DL= ZI= ZL= LL= static &&
    make_all umfpack_programs
}
umfpack_programs() {
  local program
  cd UMFPACK/Demo || return
  for program in umfpack_di_demo umf4; do
    "$CC" -O2 -DNCHOLMOD -I../Include -I../../AMD/Include -I../../SuiteSparse_config $program.c -o $program \
      ../Lib/libumfpack.a ../../AMD/Lib/libamd.a ../../SuiteSparse_config/libsuitesparseconfig.a -lm || return
  done
}
# umf4 reads tmp/A (row, column, value, from 1) and tmp/Asize (rows, columns, entries, real).
umf4_on() {
  awk '{print $1 + 1, $2 + 1, (NF > 2 ? $3 : 1)}' "../../CSparse/Matrix/$1" >tmp/A
  awk '{r = $1 > r ? $1 : r; c = $2 > c ? $2 : c} END {print r, c, NR, 1}' tmp/A >tmp/Asize
  ./umf4 "${@:2}"
}
check() {
  local matrix strategy
  cd UMFPACK/Demo || return
  ./umfpack_di_demo >demo.txt || return
  for matrix in west0067 fs_183_1 bcsstk01 bcsstk16; do
    for strategy in a u s; do umf4_on $matrix $strategy || return; done
    cksum tmp/x
  done >>demo.txt
  umf4_on bcsstk16 a 1e-6 >>demo.txt || return
  grep -viE 'time|seconds|mflops|wallclock|memory|cpu' demo.txt
}
work() { cd UMFPACK/Demo && for _ in 1 2 3; do umf4_on bcsstk16 u; done; }
