# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# CSparse's demonstrations on its own matrices (of what they print the seconds alone differ), and
# cs_gaxpy on matrices of four shapes, with vectors that lie apart or overlap (bench/gaxpy.c).
source_package=suitesparse
gaxpy_program=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../bench" && pwd)/gaxpy.c
build() {
  make_all make -C CSparse/Lib -j "$jobs" CC="$CC" CFLAGS=-O2 static && make_all csparse_demos || return
  "$CC" -O2 -ICSparse/Include "$gaxpy_program" CSparse/Lib/libcsparse.a -o gaxpy
}
csparse_demos() {
  (cd CSparse/Demo && make -j "$jobs" CC="$CC" CFLAGS=-O2 cs_demo1 cs_demo2 cs_demo3 -o lib)
}
check() {
  local matrix shape shift
  for shape in banded mesh shuffled random; do
    for shift in 4900 4899 1 0; do echo "$shape $shift $(./gaxpy $shape 70 2 $shift | cut -d ' ' -f 3)"; done
  done
  cd CSparse/Demo || return
  ./cs_demo1 <../Matrix/t1 || return
  for matrix in t1 ash219 bcsstk01 fs_183_1 mbeacxc west0067 lp_afiro bcsstk16; do
    ./cs_demo2 <../Matrix/$matrix || return
  done >out
  for matrix in bcsstk01 bcsstk16; do ./cs_demo3 <../Matrix/$matrix || return; done >>out
  sed -E 's/time:? +[0-9.]+//' out
}
work() { cd CSparse/Demo && ./cs_demo2 <../Matrix/bcsstk16; }
