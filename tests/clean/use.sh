#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# use.sh alone|project: the installed packages, used by an ordinary user. Run by packages.sh.
. "$(dirname "$0")/../driver/library.sh"
begin "$1"

if [ "$1" = alone ]; then
  # no headers of the C library, no linker script of its: a translation needs neither
  cat >loop.c <<'END'
void count(int n, const int *restrict s, double *restrict b) {
    for (int t = 0; t < n; t++)
        b[s[t]] += 1.0 / (1 + t);
}
END
  redcc loop.c -o out.c 2>remarks || fail "redcc: $(cat remarks)"
  expect_match remarks 'remark: loop in .count. runs in parallel'
  expect_match out.c 'redcc/.*\.h'
  redcc-cc -O2 -c loop.c 2>messages || fail "redcc-cc"
  expect_empty messages
  echo '#include <stdio.h>' >header.c
  gcc -c header.c 2>expected
  redcc-cc -c header.c 2>messages && fail "a header that is not there"
  expect_same expected messages
  end
  finish
fi

write_histogram count.c
gcc -O2 -ffp-contract=off count.c -o serial && ./serial >expected || fail gcc
redcc count.c -o out.c 2>remarks || fail redcc
expect_match remarks 'runs in parallel'
same_bits() { # PROGRAM
  local threads
  for threads in 1 2 3; do OMP_NUM_THREADS=$threads "$1" | expect_same expected /dev/stdin; done
  { nm -D "$1" && nm "$1"; } 2>/dev/null | grep -q redcc_run || fail "$1: not parallel"
}
eval "gcc -O2 -ffp-contract=off out.c $(pkg-config --cflags --libs redcc) -o by-hand" || fail pkg-config
same_bits ./by-hand
cat >Makefile <<'END'
CFLAGS = -O2 -Wall -Werror
count: count.o
END
for compiler in gcc clang-19; do
  export REDCC_CC=$compiler
  CC=redcc-cc make -s count 2>messages || fail "make with $compiler: $(cat messages)"
  expect_empty messages
  same_bits ./count
  rm count count.o
done
unset REDCC_CC
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.23)
project(count C)
find_package(redcc 0.1 REQUIRED)
add_executable(count count.c)
redcc_target(count)
END
{ cmake -S . -B build -DCMAKE_BUILD_TYPE=Release && cmake --build build; } >log 2>&1 || fail "cmake: $(tail -n 5 log)"
same_bits build/count

# what a report links to is there, as it is named
printf 'void f(int n, const int *s, int *h, int *out) {\n  for (int t = 0; t < n; t++) out[t] = h[s[t]]++;\n}\n' >used.c
redcc --analyze --report=sarif used.c >sarif || fail "redcc --report=sarif"
link=$(jq -r '.runs[0].tool.driver.rules[0].helpUri' sarif)
page=${link%#*}
[ -s "${page#file://}" ] || fail "no page behind '$link'"

for page in redcc redcc-cc fabric fabric-serial; do
  man "$page" >page 2>messages || fail "man $page"
  expect_empty messages
  expect_match page '^SYNOPSIS'
  expect_no_match page '@[A-Z_]+@'
done
for command in redcc redcc-cc fabric; do
  bash -c '. /usr/share/bash-completion/bash_completion && _completion_loader "$1"; complete -p "$1"' - $command |
    grep -q "_${command/-/_} $command" || fail "completion of $command"
done
fabric-serial run hanging --steps 2 -o serial-run --progress none >/dev/null &&
  fabric run hanging --steps 2 -o run --progress none >/dev/null &&
  fabric compare serial-run/final.state run/final.state >comparison || fail fabric
expect_match comparison 'every bit'
end
finish
