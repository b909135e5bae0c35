# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# KLU (libklu1) for double and complex, with BTF, AMD, COLAMD and what reads matrices in CHOLMOD: its
# demonstrations on its own matrices and CSparse's.
source_package=suitesparse
build_rounds=1
build() {
  local folder options=(CC="$CC" CFLAGS=-O2 OPTIMIZATION= CFOPENMP= KLU_L= KLU_ZL=)
  for folder in SuiteSparse_config AMD/Lib BTF/Lib COLAMD/Lib KLU/Lib; do
    make_all make -C $folder -j "$jobs" "${options[@]}" static || return
  done
  make_all klu_programs
}
klu_programs() {
  local flags="-DNPARTITION -DNCHOLESKY -DNSUPERNODAL -DNMODIFY -DNMATRIXOPS" folder
  for folder in SuiteSparse_config AMD BTF COLAMD KLU CHOLMOD; do flags+=" -I../../$folder/Include"; done
  flags=${flags/SuiteSparse_config\/Include/SuiteSparse_config}
  cd KLU/Demo && compile klu_simple.c kludemo.c ../../CHOLMOD/Core/cholmod_*.c ../../CHOLMOD/Check/cholmod_*.c || return
  set -- ../Lib/libklu.a ../../{BTF/Lib/libbtf,AMD/Lib/libamd,COLAMD/Lib/libcolamd}.a ../../SuiteSparse_config/*.a -lm
  "$CC" -O2 klu_simple.o -o klu_simple "$@" && "$CC" -O2 kludemo.o cholmod_*.o -o kludemo "$@"
}
matrix_market() { # a matrix of CSparse's in the form that CHOLMOD reads
  awk '
    { line[NR] = $1 + 1 " " $2 + 1 " " (NF > 2 ? $3 : 1); r = $1 >= r ? $1 + 1 : r; c = $2 >= c ? $2 + 1 : c }
    END { print "%%MatrixMarket matrix coordinate real general\n" r, c, NR; for (k = 1; k <= NR; k++) print line[k] }
  ' "../../CSparse/Matrix/$1"
}
check() {
  local matrix
  cd KLU/Demo && ./klu_simple || return
  for matrix in ../Matrix/*.mtx; do ./kludemo <"$matrix" || return; done
  for matrix in west0067 fs_183_1 bcsstk01 bcsstk16; do
    matrix_market $matrix >$matrix.mtx && ./kludemo <$matrix.mtx || return
  done
}
work() { cd KLU/Demo && ./kludemo <bcsstk16.mtx; }
