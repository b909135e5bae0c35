#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A library and a program that were both built by redcc-cc: each has a runtime of its own, which
# nobody else can take, and the two share one report. BUILD is the build folder.
. "$(dirname "$0")/library.sh"
export REDCC_ROOT=$BUILD OMP_NUM_THREADS=3 OMP_WAIT_POLICY=passive
redcc_cc=$REDCC_CC_PROGRAM

write_sources() {
  cat >fill.c <<'END'
void fill(int n, const int *k, double *h);
void fill(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++)
        h[k[t]] += 1.0 / (1 + t);
}
END
  cat >main.c <<'END'
#include <stdio.h>
enum { N = 100000, K = 1000 };
static int k[N];
static double h[K], g[K];
void fill(int n, const int *k, double *h);
int main(void) {
    double sum = 0;
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    fill(N, k, h);
    for (int t = 0; t < N; t++)
        g[k[t]] += 0.1 * t;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i] + g[i];
    printf("%a\n", sum);
    return 0;
}
END
  gcc -O1 -ffp-contract=off main.c fill.c -o plain && ./plain >expected
  "$redcc_cc" gcc -O1 -fPIC -shared fill.c -o libfill.so || fail "the library"
  "$redcc_cc" gcc -O1 main.c -L. -lfill -Wl,-rpath,"$PWD" -o program || fail "the program"
}
run_program() { "$@" ./program >actual 2>messages || fail "$case_name: $*: $(cat messages)"; expect_same expected actual; }

begin "nobody can take the runtime from a library, nor from a program"
write_sources
for file in libfill.so program; do
  nm -D --defined-only "$file" | grep -v " redcc_record_" >exported # records of functions are for others
  expect_no_match exported ' redcc_'
  nm -D --undefined-only "$file" | grep -v " redcc_record_" >needed
  expect_no_match needed ' redcc_'
done
run_program env REDCC_METHOD=localwrite
gcc -O1 -fPIC -shared -ffp-contract=off fill.c -o libfill.so
run_program env REDCC_METHOD=localwrite
"$redcc_cc" gcc -O1 main.c -L. -lfill -Wl,-rpath,"$PWD" -rdynamic -o program || fail "-rdynamic"
nm -D --defined-only program | grep -v " redcc_record_" >exported
expect_no_match exported ' redcc_'
end

begin "a program without loops takes nothing"
write_sources
sed 's/^ *g\[k\[t\]\].*/;/' main.c >idle.c
"$redcc_cc" gcc -O1 idle.c -L. -lfill -Wl,-rpath,"$PWD" -o idle || fail "$case_name"
nm idle >symbols
expect_no_match symbols ' redcc_'
end

# Two runtimes: two reports, of which the second must not be the only one left.
expect_both() { # FILE
  jq -e '[.loops[] | "\(.file):\(.line) \(.method)"] | sort == ["fill.c:3 localwrite", "main.c:11 localwrite"]' \
    "$1" >/dev/null || fail "$case_name: $(cat "$1")"
}
begin "one report of two runtimes"
write_sources
run_program env REDCC_METHOD=localwrite REDCC_REPORT=run.json
expect_both run.json
run_program env REDCC_METHOD=localwrite REDCC_REPORT=run.json # of another process: replaced
expect_both run.json
echo old >target
ln -s target link
run_program env REDCC_METHOD=localwrite REDCC_REPORT=link
expect_both target
[ -L link ] || fail "$case_name: the link is replaced"
mkfifo pipe
timeout 60 cat pipe >from_pipe &
exec 3>pipe # the reader stays for both
run_program env REDCC_METHOD=localwrite REDCC_REPORT=pipe
exec 3>&-
wait
jq -s '{loops: map(.loops[])}' from_pipe >joined
expect_both joined
run_program env REDCC_METHOD=localwrite REDCC_REPORT=-
expect_match messages 'localwrite, built, named; main.c:11'
expect_match messages 'localwrite, built, named; fill.c:3'
end

begin "a report of nobody else is added to"
for head in '{"process": 1, "started": 1, "loops": []}' '{"loops": [' 'no report]}'; do
  printf '%s\n' "$head" >run.json
  write_sources
  run_program env REDCC_METHOD=localwrite REDCC_REPORT=run.json
  expect_both run.json
done
end

begin "validation of two runtimes"
write_sources
run_program env REDCC_VALIDATE=1
expect_equal "$case_name" 2 "$(grep -c 'validated: 1 of 1 loops ran in parallel' messages)"
end
finish
