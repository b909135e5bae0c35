# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
source_package=libpng1.6
build() { ./configure -q CFLAGS=-O2 --disable-shared && make_all make -j "$jobs" check TESTS=; }
check() {
  make -k check -j "$jobs" >check.txt 2>&1 || { tail -n 30 check.txt >&2; return 1; }
  grep -E '^# (TOTAL|PASS|SKIP|XFAIL|FAIL|XPASS|ERROR):' check.txt
  ./pngtest pngtest.png pngout.png && cksum <pngout.png
}
work() { ./pngvalid --standard; }
