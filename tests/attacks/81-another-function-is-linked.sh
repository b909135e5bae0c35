#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Attack 81: a loop was translated by what one file says of a function, and the program is linked with
# another: changed since, of another archive, preloaded, interposed, wrapped, exchanged below a function
# that was seen. What is linked remembers its last value, so that a parallel run would show. Neighbours:
# the function that was seen, from an object, an archive, a shared object; that one runs in parallel.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "81: $*" >&2; exit 1; }
mkdir other parallel
touch Makefile
cat >value.h <<'C'
double value(const double *v, int i);
double inner(double v);
void run(int n, const int *s, const double *x, double *y);
C
cat >value.c <<'C'
#include "value.h"
double value(const double *v, int i) { return v[i] * 0.5 + inner(v[i]); }
C
cat >inner.c <<'C'
#include "value.h"
double inner(double v) { return v * v; }
C
cat >user.c <<'C'
#include "value.h"
void run(int n, const int *s, const double *x, double *y)
{
    for (int t = 0; t < n; t++)
        y[s[t]] += value(x, t);
}
C
cat >main.c <<'C'
#include <stdio.h>
#include "value.h"
enum { N = 30000, BINS = 400 };
static double x[N], y[BINS];
static int s[N];
int main(void)
{
    for (int t = 0; t < N; t++) { s[t] = t * 7 % BINS; x[t] = t * 0.37; }
    for (int round = 0; round < 3; round++) run(N, s, x, y);
    double sum = 0;
    for (int i = 0; i < BINS; i++) sum = sum * 0.99 + y[i];
    printf("%a\n", sum);
    return 0;
}
C
# remembers: as long as it is called in the order of the sequential loop
remembers='static double last; last = last * 0.5 + v'
sed "s/{ return.*/{ $remembers[i]; return last; }/" value.c >other/value.c
sed "s/{ return.*/{ $remembers; return last; }/" inner.c >other/inner.c
flags="-w -I. -O2 -ffp-contract=off"
translate() { # FILE FLAGS
    "$ATTACK_REDCC" --files=project "$1.c" -o "parallel/$1.c" -- "${@:2}" 2>>remarks
}
object() { # NAME OUTPUT FLAGS: a translated file's object
    translate "$1" "${@:3}"
    gcc $flags -iquote . -idirafter "$ATTACK_INCLUDE" -c "${@:3}" "parallel/$1.c" -o "$2"
}
check() { # WHAT yes|no: ./found against ./wanted; was the loop done in parallel?
    ${wanted_by:-} ./wanted >expected
    for threads in 2 3 7; do
        rm -f report
        env ${found_by:-} REDCC_METHOD=localwrite OMP_NUM_THREADS=$threads REDCC_REPORT=report ./found >out
        cmp -s expected out || fail "$1: another program at $threads threads"
        unlinked=$(jq '[.loops[].fallbacks[] | select(.slug == "unlinked").count] | add // 0' report)
        built=$(jq '[.loops[].plans_built] | add' report)
        if [ "$2" = yes ]; then
            [ "$built" -gt 0 ] || fail "$1: not in parallel"
        else
            [ "$built" -eq 0 ] && [ "$unlinked" -eq 3 ] || fail "$1: $built plans, $unlinked calls told why not"
        fi
    done
}
link() { gcc $flags -Wl,-u,redcc_run "$@" "$ATTACK_LIBRARY" -o found -lm 2>link.messages || { cat link.messages; fail "does not link: $*"; }; }

for name in user value inner; do object $name $name.o; done
gcc -I. $flags -c other/value.c -o other_value_plain.o
gcc -I. $flags -c other/inner.c -o other_inner_plain.o
cp value.c kept.c
gcc $flags main.c user.c value.c inner.c -o wanted
link main.c user.o value.o inner.o
check "the function that was seen" yes
ar rcs lib.a value.o inner.o
link main.c user.o lib.a
check "from an archive" yes
link -no-pie main.c user.o lib.a
check "at fixed addresses" yes
link -Wl,--gc-sections main.c user.o lib.a
check "without what is not used" yes
link -static main.c user.o lib.a
check "in a static program" yes

# compiled by another compiler than redcc-cc: nothing is said of it
gcc $flags main.c user.c other/value.c inner.c -o wanted
link main.c user.o other_value_plain.o inner.o
check "another object" no
ar rcs first.a other_value_plain.o
link main.c user.o first.a lib.a
check "another archive" no
link -Wl,-z,muldefs main.c user.o other_value_plain.o value.o inner.o
check "the first of two" no
# translated as well, and changed after its user was compiled
cp other/value.c value.c
object value changed.o
link main.c user.o changed.o inner.o
check "changed since" no
cp kept.c value.c
# below a function that was seen
gcc $flags main.c user.c value.c other/inner.c -o wanted
link main.c user.o value.o other_inner_plain.o
check "another callee" no
# by the linker
sed 's/value(/__wrap_value(/' other/value.c >wrap.c
gcc $flags -c wrap.c
gcc $flags -Wl,--wrap=value main.c user.c value.c inner.c wrap.o -o wanted
link -Wl,--wrap=value main.c user.o value.o inner.o wrap.o
check "wrapped" no
objcopy --redefine-sym value=old_value value.o renamed.o
gcc $flags main.c user.c other/value.c inner.c -o wanted
link main.c user.o renamed.o other_value_plain.o inner.o
check "renamed in its object" no

# shared objects: what they export may be replaced, and is asked for where it is called
for name in user value inner; do object $name pic_$name.o -fPIC; done
gcc -shared pic_value.o pic_inner.o -o libvalue.so
gcc $flags main.c user.c value.c inner.c -o wanted
link main.c user.o libvalue.so -Wl,-rpath,.
check "from a shared object" yes
gcc -shared -Wl,-u,redcc_run pic_user.o pic_value.o pic_inner.o "$ATTACK_LIBRARY" -o liball.so
link main.c liball.so -Wl,-rpath,.
check "inside of a shared object" yes
gcc $flags main.c user.c other/value.c inner.c -o wanted
link main.c other_value_plain.o liball.so -Wl,-rpath,.
check "replaced by the program" no
gcc $flags -shared -fPIC other/value.c -o preload.so
gcc $flags main.c user.c value.c inner.c -o wanted
cp wanted wanted_alone
gcc $flags main.c user.c other/value.c inner.c -o wanted
link main.c user.o libvalue.so -Wl,-rpath,.
found_by="LD_PRELOAD=./preload.so" check "preloaded" no
gcc $flags -shared -fPIC other/inner.c -o preload.so
gcc $flags main.c user.c value.c other/inner.c -o wanted
found_by="LD_PRELOAD=./preload.so" check "a callee preloaded" no

# of what another loop of the file calls, this one asks nothing
unset found_by
cat >noise.c <<'C'
double noise(double v) { return v * 0.5; }
C
cat >>user.c <<'C'
double noise(double v);
void settle(int n, double *a)
{
    for (int i = 0; i < n; i++)
        a[0] = noise(a[0]);
}
C
object user both.o
grep -q 'noise' parallel/user.c || fail "no loop calls noise"
echo 'double noise(double v) { return v * 0.25; }' >other/noise.c
gcc $flags -c other/noise.c -o other_noise.o
gcc $flags main.c user.c value.c inner.c other/noise.c -o wanted
link main.c both.o value.o inner.o other_noise.o
check "another function, of another loop" yes

# a message that is never printed, by the constant that the function returned when it was seen
cat >>value.h <<'C'
int status(int i);
C
cat >status.c <<'C'
int status(int i) { return i < 0 ? 1 : 1; }
C
cat >user.c <<'C'
#include <stdio.h>
#include "value.h"
void run(int n, const int *s, const double *x, double *y)
{
    for (int t = 0; t < n; t++) {
        int ok = status(t);
        if (!ok)
            printf("problems in %d: %a\n", t, y[s[t]]);
        y[s[t]] += x[t];
    }
}
C
sed 's/1 : 1/1 : i % 5000 != 7/' status.c >other/status.c
for name in user status; do object $name $name.o; done
gcc $flags -c other/status.c -o other_status.o
gcc $flags main.c user.c status.c -o wanted
link main.c user.o status.o
check "a function that always succeeds" yes
gcc $flags main.c user.c other/status.c -o wanted
link main.c user.o other_status.o
check "one that fails" no
