# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# The folders whose tests are run, and what these are linked to.
source_package=gsl
build_rounds=1
gsl_tested="spmatrix spblas histogram statistics sort"
gsl_needed="gsl err sys utils test block vector matrix complex cblas blas permutation rng ieee-utils bst"
build() {
  # prototypes of Debian's own patches are newer than its generated files: leave autotools alone
  find . -name '*.in' -o -name configure -o -name aclocal.m4 | xargs touch
  ./configure -q CFLAGS=-O2 --disable-shared && make_all gsl_folders
}
gsl_folders() {
  local folder
  for folder in $gsl_needed $gsl_tested; do make -C "$folder" -j "$jobs" || return; done
  for folder in $gsl_tested; do make -C "$folder" -j "$jobs" check TESTS= || return; done
}
check() {
  local folder
  for folder in $gsl_tested; do
    (cd "$folder" && echo "$folder" && GSL_TEST_VERBOSE=1 ./test) || return
  done
}
work() { ./spblas/test && ./spmatrix/test && ./histogram/test && ./sort/test; }
