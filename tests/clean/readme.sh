#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What README.md alone gives a newcomer, timed: in a bare Debian 12 with a clone in /source/redcc, as
# root, the commands of "Install and use" as they are written, a first program, a reason understood, a
# gain looked up. Run by script/clean-system.
set -euo pipefail
fail() { echo "FAIL: $*" >&2; exit 1; }
cd /source/redcc
export LC_ALL=C OMP_WAIT_POLICY=passive
mkdir -p /tmp/newcomer
echo 'APT::Get::Assume-Yes "true";' >/etc/apt/apt.conf.d/yes # who types it answers Y
block() { # NUMBER: of the blocks without a language in README.md's section
  awk -v wanted="$1" '/^## / {section = $0 ~ /^## Install and use/} section && /^```/ {
    inside = !inside; number += inside; next } section && inside && number == wanted' README.md
}
start=$SECONDS
block 1 >/tmp/newcomer/install
[ "$(wc -l </tmp/newcomer/install)" -ge 3 ] || fail "README.md has no commands that install"
while IFS= read -r line; do
  echo "readme: $line"
  bash -euc "$line" >/tmp/newcomer/log 2>&1 </dev/null || fail "$line: $(tail -n 20 /tmp/newcomer/log)"
done </tmp/newcomer/install
echo "readme: installed after $((SECONDS - start)) s"

P=$PWD/P
export PATH="$P/bin:$PATH" PKG_CONFIG_PATH="$P/lib/pkgconfig"
awk '/^```c$/ {inside = 1; next} /^```$/ {if (inside) exit} inside' README.md >/tmp/newcomer/springs.c
remark=$(grep '^springs.c:.*remark:' README.md)
cd /tmp/newcomer
redcc springs.c -o springs-parallel.c 2>remarks || fail "redcc: $(cat remarks)"
grep -qxF "$remark" remarks || fail "README's remark is not what redcc says: $(cat remarks)"

echo "readme: a first program"
cat >program.c <<'END'
#include <stdio.h>
enum { N = 4000000, K = 100000 };
static int s[N];
static double b[K];
int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = (int)(t * 7919LL % K);
    for (int round = 0; round < 20; round++)
        for (int t = 0; t < N; t++)
            b[s[t]] += 1.0 / (1 + t);
    double sum = 0;
    for (int e = 0; e < K; e++)
        sum = 0.5 * sum + b[e];
    printf("%a\n", sum);
    return 0;
}
END
printf 'CFLAGS = -O2\nprogram: program.c\n\t$(CC) $(CFLAGS) program.c -o program\n' >Makefile
make -s && ./program >expected && rm program
make -s CC=redcc-cc && OMP_NUM_THREADS=2 ./program | cmp - expected || fail "make CC=redcc-cc"
redcc program.c -o out.c 2>remarks
# shellcheck disable=SC2046
cc -O2 -fopenmp out.c $(pkg-config --cflags --libs redcc) && OMP_NUM_THREADS=2 ./a.out | cmp - expected || fail "by pkg-config"

echo "readme: a reason understood"
printf 'void f(int n, const int *s, int *h, int *out) {\n  for (int t = 0; t < n; t++) out[t] = h[s[t]]++;\n}\n' >used.c
redcc --analyze used.c 2>remarks || fail "redcc --analyze"
reason=$(grep -oE 'R[0-9]{3}' remarks | head -n 1)
redcc --explain "$reason" | grep -q 'What to change' || fail "redcc --explain $reason"

echo "readme: a gain measured"
OMP_NUM_THREADS=2 REDCC_REPORT=- ./program 2>report >/dev/null
cat report
grep -q 'program.c:' report || fail "no report of the run: $(cat report)"
spent=$((SECONDS - start))
[ $spent -lt 600 ] || fail "$spent seconds"
echo "readme: passed, all in $spent s"
