# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# Cliquer's test cases, and the largest cliques of a random graph.
source_package=cliquer
build() { make_all make -j "$jobs" CC="$CC" CFLAGS=-O2 testcases && make_all "$CC" -O2 cl.c cliquer.o graph.o reorder.o -o cl; }
random_graph() { # NODES PER_CENT: in the form of DIMACS
  awk -v n="$1" -v p="$2" 'BEGIN {
    s = 12345
    print "p edge", n, int(n * n * p / 200)
    for (i = 2; i <= n; i++) for (j = 1; j < i; j++) {
      s = (s * 16807) % 2147483647
      if (s % 100 < p) print "e", i, j
    }
  }'
}
check() {
  ./testcases || return
  random_graph 150 50 >graph && ./cl -a -q graph && ./cl -u -s graph 2>/dev/null
}
work() { random_graph 130 60 >graph && ./cl -q graph; }
