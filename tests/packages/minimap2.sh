# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# The sequences of its test folder, mapped with several presets, bases aligned.
source_package=minimap2
build_rounds=1
build() {
  local patch
  for patch in reenable-simde.patch simde; do # Debian's vectors come from a package of their own
    patch -R -s -p1 <debian/patches/$patch || return
  done
  make_all make -j "$jobs" CC="$CC" CFLAGS=-O2 minimap2 sdust
}
check() {
  local preset
  cd test || return
  for preset in map-ont asm20 sr splice ava-ont; do
    echo $preset
    ../minimap2 -t 1 -a -x $preset MT-human.fa MT-orang.fa | grep -v '^@PG' || return
    ../minimap2 -t 1 -c --cs -x $preset t2.fa q2.fa || return
    ../minimap2 -t 1 -c -x $preset t-inv.fa q-inv.fa || return
  done
  ../sdust MT-human.fa
}
work() { cd test && for _ in 1 2 3 4 5; do ../minimap2 -t 1 -a MT-human.fa MT-orang.fa; done; }
