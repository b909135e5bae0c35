# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# FastTree without its own threads: trees of the sequences in Debian's tests, several models.
source_package=fasttree
build_rounds=1
build() { make_all make CC="$CC" CFLAGS=-O2 fasttree; }
check() {
  local options
  head -n 120 debian/tests/test.fasta >few
  for options in "" "-lg -gamma" "-nome -noml" "-pseudo -spr 4 -wag" "-slow -nosupport"; do
    # shellcheck disable=SC2086
    echo "$options" && ./fasttree $options few 2>/dev/null || return
  done
  echo nucleotides && sequences 40 | ./fasttree -nt -gtr 2>/dev/null
}
sequences() { # COUNT: each a copy of an earlier one, with changes
  awk -v n="$1" 'BEGIN {
    s = 4711
    for (i = 0; i < n; i++) {
      printf ">s%d\n", i
      s = (s * 16807) % 2147483647
      from = i ? s % i : 0
      for (k = 0; k < 400; k++) {
        s = (s * 16807) % 2147483647
        if (!i || s % 100 < 6) base[i, k] = substr("ACGT", int(s / 128) % 4 + 1, 1)
        else base[i, k] = base[from, k]
        printf "%s", base[i, k]
      }
      print ""
    }
  }'
}
work() { sequences 80 | ./fasttree -nt -gtr; }
