#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Loops in the headers of a project of several sources: each source's report lists them, and what is
# said of the whole build counts them once. Headers that can stand in the text do, with the same
# messages, dependencies and bits. BUILD is the build folder.
. "$(dirname "$0")/library.sh"
export REDCC_ROOT=$BUILD OMP_WAIT_POLICY=passive
redcc_cc=$REDCC_CC_PROGRAM
redcc=$BUILD/tool/redcc

make_sources() {
  mkdir -p src include vendor
  cat >include/kernel.h <<'END_OF_FILE'
#ifndef KERNEL_H
#define KERNEL_H
#include <assert.h>
static inline void deposit(int n, const int *s, const double *e, double *h)
{
    int unused_here;
    assert(n >= 0);
    for (int t = 0; t < n; t++)
        h[s[t]] += e[t];
}
static inline void not_used_here(int n, const int *s, double *h)
{
    for (int t = 0; t < n; t++)
        h[s[t]] *= 2;
}
#endif
END_OF_FILE
  cat >include/stays.h <<'END_OF_FILE'
static inline void stays(int n, const int *s, const double *e, double *h)
{
    for (int t = 0; t < n; t++)
        h[s[t]] += e[t] * (__FILE__[0] == 'x');
}
static inline void not_used(int n, const int *s, double *h)
{
    for (int t = 0; t < n; t++)
        h[s[t]] += 2;
}
END_OF_FILE
  cat >vendor/vendor.h <<'END_OF_FILE'
static inline void of_others(int n, const int *s, double *h)
{
    for (int t = 0; t < n; t++)
        h[s[t]] += 3;
}
END_OF_FILE
  for name in a b c; do
    cat >src/$name.c <<END_OF_FILE
#include "../include/kernel.h"
#include "../include/stays.h"
#include <vendor.h>
void $name(int n, const int *s, const double *e, double *h)
{
    deposit(n, s, e, h);
    stays(n, s, e, h);
    of_others(n, s, h);
    for (int t = 0; t < n; t++)
        h[s[t]] -= e[t] * 0.5;
}
END_OF_FILE
  done
  cat >src/main.c <<'END_OF_FILE'
#include <stdio.h>
enum { N = 100000, M = 700 };
void a(int n, const int *s, const double *e, double *h);
void b(int n, const int *s, const double *e, double *h);
void c(int n, const int *s, const double *e, double *h);
static int s[N];
static double e[N], h[M];
int main(void)
{
    for (int t = 0; t < N; t++) {
        s[t] = (int)(t * 7919LL % M);
        e[t] = 1.0 / (t + 1);
    }
    for (int round = 0; round < 4; round++) {
        a(N, s, e, h);
        b(N, s, e, h);
        c(N, s, e, h);
    }
    for (int k = 0; k < M; k++)
        printf("%a\n", h[k]);
    return 0;
}
END_OF_FILE
}
build() { # COMPILER FOLDER
  mkdir -p "$2"
  for name in a b c main; do
    "$1" -O2 -ffp-contract=off -Wall -MD -MF "$2/$name.d" -MT x -isystem vendor -c src/$name.c -o "$2/$name.o" 2>>"$2/messages" ||
      fail "$case_name: $1 $name.c"
  done
  "$1" "$2"/*.o -o "$2/program" && OMP_NUM_THREADS=3 REDCC_METHOD=localwrite "$2/program" >"$2/output" || fail "$case_name: $1"
}
in_headers='.loops[] | select(.file != null) | [(.file | sub(".*/"; "")), .line, .function, .verdict, .reason.slug]'

begin "a project"
make_sources
build gcc plain
REDCC_BUILD_REPORT=$PWD/report build "$redcc_cc" parallel
expect_same plain/output parallel/output
expect_same plain/messages parallel/messages
expect_match plain/messages '^src/../include/kernel.h:6:9: warning: unused variable'
for name in a b c main; do expect_same plain/$name.d parallel/$name.d; done
expect_equal "$case_name: each source lists it" 3 \
  "$(jq -c "$in_headers" report | grep -cx '\["stays.h",3,"stays","refused","in-header"\]')"
expect_equal "$case_name: each source has it in place" 3 \
  "$(jq -c "$in_headers" report | grep -cx '\["kernel.h",8,"deposit","transformed",null\]')"
expect_equal "$case_name: and no other" 6 "$(jq -c "$in_headers" report | wc -l)"
expect_equal "$case_name: nothing is left alone" 0 "$(jq -c 'select(.left_alone)' report | wc -l)"
"$redcc_cc" --redcc-summary report >summary || fail "$case_name: no summary"
expect_match summary 'irregular reductions: 4 parallel, 1 refused'
expect_match summary 'refused: R518 in-header: 1$'
"$redcc_cc" --redcc-html pages report || fail "$case_name: no pages"
expect_equal "$case_name: pages" 5 "$(ls pages/*.c.html pages/*.h.html | wc -l)"
expect_match pages/*stays.h.html 'which is included'
expect_match pages/*stays.h.html 'h\[s\[t\]\] \+= 2'
end

begin "a header changes, and the translations are cached"
make_sources
export REDCC_CACHE=$PWD/cache
for factor in 1 3 3; do
  sed -i "s/+= .*e\[t\];/+= $factor * e[t];/" include/kernel.h
  rm -rf plain parallel
  build gcc plain
  build "$redcc_cc" parallel
  expect_same plain/output parallel/output
done
export REDCC_CACHE=off
end

begin "a header with headers of its own in another folder stays; redcc by itself puts none in place"
make_sources
echo '#define TWICE 2' >include/twice.h
sed -i '3a #include "twice.h"' include/kernel.h
REDCC_BUILD_REPORT=$PWD/report build "$redcc_cc" parallel
expect_equal "$case_name" 3 "$(jq -c "$in_headers" report | grep -c '"kernel.h".*"refused","in-header"')"
make_sources
"$redcc" src/a.c -o a.c -- -isystem vendor 2>remarks || fail "$case_name: redcc"
expect_match a.c '^#include "../include/kernel.h"'
expect_match remarks 'kernel\.h:8:5: remark: loop in .deposit. stays sequential: R518'
end

begin "the advice is followed: the function moves to a source"
make_sources
{ echo '#include "../include/stays.h"'; sed -n '/void stays/,/^}/p' include/stays.h; } |
  sed 's/static inline //' >src/stays.c
sed -i '/void stays/,/^}/d; 1i void stays(int n, const int *s, const double *e, double *h);' include/stays.h
"$redcc" --analyze --report=json src/stays.c >moved || fail "$case_name"
expect_equal "$case_name" '["stays","transformed"]' "$(jq -c '.loops[] | [.function, .verdict]' moved)"
end

begin "a folder of commands"
make_sources
for name in a b c; do
  jq -n --arg d "$PWD" --arg f src/$name.c \
    '{directory: $d, file: $f, arguments: ["cc", "-isystem", "vendor", "-c", $f, "-o", ($f + ".o")]}'
done | jq -s . >compile_commands.json
"$redcc" --analyze -p . --report=sarif >log 2>counts || fail "$case_name: redcc"
expect_match counts '^ +in-header +1$'
expect_match counts '^  transformed +4$'
expect_equal "$case_name: results" 1 "$(jq '[.runs[0].results[] | select(.ruleId == "R518")] | length' log)"
"$redcc" --analyze -p . >/dev/null 2>remarks || fail "$case_name: redcc"
expect_match remarks 'stays\.h:3:5: remark: loop in .stays. stays sequential: R518'
expect_match remarks 'stays\.h:3:5: note: move the function to a source file'
expect_no_match remarks 'vendor\.h'
end

finish
