# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# lp_solve, with the COLAMD in its source: Debian's source has no tests, so it solves programs written
# here (a transport, a knapsack, a cover), with several pricings, factorisations and scalings.
source_package=lp-solve
build_rounds=1
build() { make_all lpsolve_program; }
lpsolve_program() {
  local flags="-DYY_NEVER_INTERACTIVE -DPARSER_LP -DINVERSE_ACTIVE=INVERSE_LUSOL -DRoleIsExternalInvEngine -w" folder
  for folder in . shared bfp bfp/bfp_LUSOL bfp/bfp_LUSOL/LUSOL colamd; do flags+=" -I$folder"; done
  compile lp_{MDO,rlp,crash,Hash,lib,wlp,matrix,mipbb,MPS,params,presolve,price,pricePSE,report,scale,simplex,SOS,utils}.c \
    yacc_read.c ini.c shared/{commonlib,mmio,myblas}.c bfp/bfp_LUSOL/lp_LUSOL.c bfp/bfp_LUSOL/LUSOL/lusol.c \
    colamd/colamd.c lp_solve/lp_solve.c || return
  "$CC" ./*.o -lm -ldl -o solve
}
transport() { # SOURCES SINKS
  awk -v m="$1" -v n="$2" 'BEGIN {
    s = 99
    printf "min: "
    for (i = 0; i < m; i++) for (j = 0; j < n; j++) { s = (s * 16807) % 2147483647; printf "+%d x%d_%d\n", s % 90 + 10, i, j }
    print ";"
    for (i = 0; i < m; i++) { for (j = 0; j < n; j++) printf "+x%d_%d ", i, j; print "<= " 40 + i % 7 * 5 ";" }
    for (j = 0; j < n; j++) { for (i = 0; i < m; i++) printf "+x%d_%d ", i, j; print ">= " int(30 * m / n) + j % 5 ";" }
  }'
}
knapsack() { # ROWS COLUMNS
  awk -v m="$1" -v n="$2" 'BEGIN {
    s = 7
    printf "max: "
    for (j = 0; j < n; j++) { s = (s * 16807) % 2147483647; printf "+%d y%d ", s % 50 + 5, j }
    print ";"
    for (i = 0; i < m; i++) { for (j = 0; j < n; j++) { s = (s * 16807) % 2147483647; if (s % 3) printf "+%d y%d ", s % 40 + 1, j } print "<= " 9 * n ";" }
    for (j = 0; j < n; j++) print "y" j "<= 1;"
    printf "int "
    for (j = 0; j < n; j++) printf "%sy%d", j ? "," : "", j
    print ";"
  }'
}
check() {
  local options
  transport 12 16 >transport.lp
  knapsack 3 16 >knapsack.lp
  for options in "" "-piv0" "-piv1" "-piv3" "-s4" "-BB" "-simplexdd"; do
    echo "$options"
    # shellcheck disable=SC2086
    ./solve -S3 $options transport.lp && ./solve -S3 $options knapsack.lp || return
  done | grep -viE 'time|parse called|seconds'
  ./solve -S1 transport.lp -wlp written.lp && ./solve -S1 knapsack.lp -wfmps written.mps && cat written.lp written.mps
}
work() { transport 20 40 >large.lp && ./solve -S1 large.lp; }
