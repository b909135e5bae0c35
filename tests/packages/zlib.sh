# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
source_package=zlib
build() { CFLAGS=-O2 ./configure && make_all make -j "$jobs"; }
check() {
  make test || return
  cat doc/*.txt ./*.c ./*.c | tee sample | ./minigzip -9 >sample.gz && ./minigzip -d <sample.gz | cmp - sample || return
  cksum <sample.gz
}
work() { for _ in 1 2 3 4 5 6; do cat ./*.c ./*.h doc/*; done | ./minigzip -9; }
