# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
source_package=bzip2
build() { make_all make -j "$jobs" CC="$CC" CFLAGS="-O2 -D_FILE_OFFSET_BITS=64" libbz2.a bzip2 bzip2recover; }
check() {
  make CC=false test || return # nothing is left to compile
  cat ./*.c ./*.html | ./bzip2 -9 | tee sample.bz2 | cksum
  ./bzip2 -d <sample.bz2 | cksum
}
work() { for _ in 1 2 3 4; do cat ./*.c ./*.html ./*.bz2; done | ./bzip2 -9; }
