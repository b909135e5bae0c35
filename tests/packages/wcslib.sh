# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# WCSLIB (coordinates of astronomical images): what needs no scanner made by flex, with its own tests of
# table look-up, linear, logarithmic, spherical and spectral coordinates and map projections.
source_package=wcslib
build_rounds=1
wcslib_tests="ttab1 tlin tlog tsph tspx tprj1"
build() { make_all wcslib_programs; }
wcslib_programs() {
  local flags="-DHAVE_WCSCONFIG_H -I. -I.." test
  cat >wcsconfig.h <<'CONFIG'
#define WCSLIB_VERSION "Debian's"
#define WCSLIB_INT64 long long int
CONFIG
  cp wcsconfig.h wcsconfig_tests.h && cd C || return
  compile {cel,dis,lin,log,prj,spc,sph,spx,tab,wcserr,wcsprintf,wcstrig,wcsutil}.c || return
  for test in $wcslib_tests; do "$CC" -O2 $flags test/$test.c ./*.o -lm -o $test || return; done
}
check() {
  local test
  cd C || return
  for test in $wcslib_tests; do echo "$test" && ./$test || return; done
}
work() { cd C && for _ in 1 2 3; do ./ttab1 && ./tprj1; done; }
