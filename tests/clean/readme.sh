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
#include <math.h>
#include <stdio.h>
/* A cloth of ROWS x ROWS points; springs to the neighbours right, below, and across. */
enum { ROWS = 200, POINTS = ROWS * ROWS, STEPS = 400 };
static int end[4 * POINTS][2];
static double rest[4 * POINTS], x[POINTS][3], v[POINTS][3], force[POINTS][3];
static int connect(int springs, int row, int column, int down, int right) {
    if (row + down >= ROWS || column + right < 0 || column + right >= ROWS)
        return springs;
    end[springs][0] = row * ROWS + column;
    end[springs][1] = (row + down) * ROWS + column + right;
    rest[springs] = 0.01 * sqrt(down + right * right);
    return springs + 1;
}
static void pull(int springs) {
    for (int t = 0; t < springs; t++) {
        int i = end[t][0], j = end[t][1];
        double dx = x[j][0] - x[i][0], dy = x[j][1] - x[i][1], dz = x[j][2] - x[i][2];
        double length = sqrt(dx * dx + dy * dy + dz * dz);
        double k = 0.05 * (exp(4 * (length / rest[t] - 1)) - 1) / length; /* stiffens as skin does: Fung's law */
        force[i][0] += k * dx, force[i][1] += k * dy, force[i][2] += k * dz;
        force[j][0] -= k * dx, force[j][1] -= k * dy, force[j][2] -= k * dz;
    }
}
int main(void) {
    int springs = 0;
    for (int row = 0; row < ROWS; row++)
        for (int column = 0; column < ROWS; column++) {
            double *p = x[row * ROWS + column];
            p[0] = 0.01 * column, p[1] = 0.01 * row, p[2] = 0.001 * sin(0.1 * column * row);
            springs = connect(springs, row, column, 0, 1);
            springs = connect(springs, row, column, 1, 0);
            springs = connect(springs, row, column, 1, 1);
            springs = connect(springs, row, column, 1, -1);
        }
    for (int step = 0; step < STEPS; step++) {
        for (int p = 0; p < POINTS; p++)
            force[p][0] = 0, force[p][1] = 1e-5, force[p][2] = 0;
        pull(springs);
        for (int p = ROWS; p < POINTS; p++)
            for (int c = 0; c < 3; c++) {
                v[p][c] = 0.999 * v[p][c] + 0.01 * force[p][c];
                x[p][c] += v[p][c];
            }
    }
    double sum = 0;
    for (int p = 0; p < POINTS; p++)
        sum = 0.5 * sum + x[p][1];
    printf("%a\n", sum);
    return 0;
}
END
printf 'CFLAGS = -O2\nprogram: program.c\n\t$(CC) $(CFLAGS) program.c -o program -lm\n' >Makefile
make -s && ./program >expected && mv program sequential
make -s CC=redcc-cc && OMP_NUM_THREADS=2 ./program | cmp - expected || fail "make CC=redcc-cc"
redcc program.c -o out.c 2>remarks
# shellcheck disable=SC2046
cc -O2 out.c $(pkg-config --cflags --libs redcc) -lm && OMP_NUM_THREADS=2 ./a.out | cmp - expected || fail "by pkg-config"

echo "readme: a reason understood"
printf 'void f(int n, const int *s, int *h, int *out) {\n  for (int t = 0; t < n; t++) out[t] = h[s[t]]++;\n}\n' >used.c
redcc --analyze used.c 2>remarks || fail "redcc --analyze"
reason=$(grep -oE 'R[0-9]{3}' remarks | head -n 1)
redcc --explain "$reason" | grep -q 'What to change' || fail "redcc --explain $reason"

echo "readme: a gain measured"
export OMP_NUM_THREADS=2
REDCC_REPORT=- ./program 2>report >/dev/null
cat report
grep -q 'program.c:' report || fail "no report of the run: $(cat report)"
milliseconds() { # COMMAND: of its quickest run of three
  local least=999999 begun took
  for _ in 1 2 3; do
    begun=$(date +%s%N)
    "$@" >/dev/null
    took=$((($(date +%s%N) - begun) / 1000000))
    [ $took -ge $least ] || least=$took
  done
  echo $least
}
alone=$(milliseconds ./sequential) together=$(milliseconds ./program)
speed=$((100 * alone / together))
echo "readme: by gcc $alone ms, by redcc-cc with 2 threads $together ms: $speed % of the speed"
running=$(sed 's|.* \([0-9]*\)/.*|\1|' /proc/loadavg) # this one among them
if [ $speed -lt 110 ]; then
  [ "$running" -gt 2 ] || [ "$(nproc)" -lt 2 ] || fail "no gain, on a machine with nothing else to do"
  echo "readme: no gain is asked for where others want the processors ($running processes are running)"
fi
spent=$((SECONDS - start))
[ $spent -lt 600 ] || [ "$running" -gt 2 ] || fail "$spent seconds, on a machine with nothing else to do"
echo "readme: passed, all in $spent s"
