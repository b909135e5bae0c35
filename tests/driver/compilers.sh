#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The real translator behind each real compiler: standards from c89 to gnu17, options that change what
# a program means, and sources that ask which compiler they are compiled by.
. "$(dirname "$0")/library.sh"
export REDCC_ROOT=$BUILD OMP_NUM_THREADS=2
redcc_cc=$REDCC_CC_PROGRAM
compilers=gcc
command -v clang-19 >/dev/null && compilers+=" clang-19"

# A program of C89: $1 is put before it, $2 is the loop's subscript.
write_program() {
  printf '%s\n' "$1"
  cat <<END2
#include <stdio.h>
#ifndef AT
#define AT(t) (t)
#endif
static double b[64];
static int s[20000], other[20000];
int main(void)
{
    int t;
    for (t = 0; t < 20000; t++) {
        s[t] = t % 64;
        other[t] = t / 3;
    }
    for (t = 0; t < 20000; t++)
        b[s[AT(t)]] += 1.0 / (1 + t);
    for (t = 0; t < 64; t++)
        printf("%.17g\n", b[t]);
    return 0;
}
END2
}
build_both() { # COMPILER OPTIONS...: p1 by the compiler, p2 by redcc-cc; messages; verdict in report
  local compiler=$1
  shift
  rm -f report p1 p2
  $compiler -O1 -ffp-contract=off "$@" x.c -o p1 && REDCC_BUILD_REPORT=$PWD/report "$redcc_cc" "$compiler" -O1 "$@" x.c -o p2 2>messages ||
    fail "$case_name: $compiler $*: $(cat messages)"
  ./p1 >expected && ./p2 >actual && expect_same expected actual
}

begin "standards"
write_program "" >x.c
gcc -O1 x.c -o p1 && ./p1 >expected
try_standard() { # COMPILER OPTIONS...
  rm -f report
  REDCC_BUILD_REPORT=$PWD/report "$redcc_cc" "$@" -pedantic-errors -Wall -Wextra -Wdeclaration-after-statement -Werror \
    -O1 x.c -o p2 2>messages || fail "$case_name: $*"
  expect_empty messages
  expect_match report '"verdict":"transformed"'
  ./p2 | expect_same expected /dev/stdin
}
for standard in c89 iso9899:199409 gnu89 c99 gnu99 c11 gnu11 c17 gnu17; do try_standard gcc -std=$standard; done
try_standard gcc -ansi
[ "$compilers" = gcc ] || for standard in c89 c99 gnu17; do try_standard clang-19 -std=$standard; done
end

begin "options that change what a program means reach the translator, or turn it off"
cat >x.c <<'END2'
void f(int n, const long *s, const double *x, double *y) {
    for (int t = 0; t < n; t++)
        y[s[t]] += x[t];
}
END2
guards() { rm -f report; REDCC_BUILD_REPORT=$PWD/report "$redcc_cc" "$@" -c x.c && jq -rs '[.[].loops[].guards[]] | join(" ")' report; }
expect_equal "$case_name" "no-overlap(y, x)" "$(guards -O2)"
expect_equal "$case_name" "no-overlap(y, s) no-overlap(y, x)" "$(guards -O2 -fno-strict-aliasing)"
expect_equal "$case_name" "no-overlap(y, x)" "$(guards -fno-strict-aliasing -fstrict-aliasing)"
for option in -fno-strict-overflow -frounding-math -funsigned-bitfields -fpack-struct -undef -finput-charset=UTF-8 \
  -ftrapv -fno-signed-bitfields -fsingle-precision-constant -finstrument-functions -fsanitize=undefined,thread; do
  rm -f report
  REDCC_BUILD_REPORT=$PWD/report "$redcc_cc" gcc -v $option -c x.c 2>messages || fail "$case_name: $option"
  expect_match messages 'an option that redcc cannot follow'
  expect_match report '"loops":\[\],"left_alone":"an option that redcc cannot follow: -'
done
rm -f report
REDCC_BUILD_REPORT=$PWD/report "$redcc_cc" gcc -Ofast -mfpmath=387 -c x.c 2>messages || fail "$case_name"
expect_match report '"slug":"inexact-option"'
expect_empty messages
end

begin "a translated file is compiled without the liberties of -ffast-math and its kin; a file that is not keeps them"
strict_bits() { # COMPILER OPTION: the program by redcc-cc prints what it prints when compiled without the option
  rm -f report
  $1 -O3 -ffp-contract=off x.c -o p1 && REDCC_BUILD_REPORT=$PWD/report "$redcc_cc" "$1" -O3 $2 x.c -o p2 2>messages ||
    fail "$case_name: $1 $2: $(cat messages)"
  expect_match report '"verdict":"transformed"'
  expect_match messages "note: x.c: has parallel loops and is compiled without $2's freedom"
  ./p1 >expected
  for threads in 1 2 7; do OMP_NUM_THREADS=$threads ./p2 | expect_same expected /dev/stdin; done
}
# The product over t, which a compiler may associate otherwise, and a macro that tells -ffast-math.
write_program $'static double product = 1;\n#ifdef __FAST_MATH__\n#error\n#endif' |
  sed 's|b\[s\[AT(t)\]\] += .*|b[s[AT(t)]] += 1.0 / (1 + t) / 3.0 * 0.1 + 0.3 - 0.2;|; s|printf("%.17g\\n", b\[t\])|product *= 1 + b[t] / 7, printf("%.17g %.17g\\n", b[t], product)|' >x.c
for compiler in $compilers; do
  for option in -ffast-math -Ofast "-funsafe-math-optimizations"; do strict_bits $compiler $option; done
done
strict_bits gcc -fassociative-math
strict_bits gcc -mrecip
expect_equal "$case_name: the link keeps it" 1 "$("$redcc_cc" --redcc-show gcc -Ofast x.c -o p2 | tail -n 1 | grep -c -e -Ofast)"
# A file without parallel loops, or whose bits are given up, is compiled as it says.
write_program "" | sed 's/+= 1.0/= 1.0/' >x.c
"$redcc_cc" gcc -Ofast x.c -o p2 2>messages && expect_empty messages
printf 'double half(double x) { return x / 2; }\n' >x.c # a function that other files might call
"$redcc_cc" gcc -Ofast -c x.c -o p2 2>messages && expect_empty messages
"$redcc_cc" gcc -Ofast -S x.c -o p1 && gcc -Ofast -S x.c -o p2 && expect_same p1 p2
write_program $'#ifndef __FAST_MATH__\n#error\n#endif' >x.c
REDCC_OPTS=--order=any "$redcc_cc" gcc -Ofast x.c -o p2 2>messages || fail "$case_name: $(cat messages)"
expect_empty messages
end

begin "a source that asks for threads: OpenMP, with gcc, says yes where -pthread was not given"
write_program $'#ifdef _REENTRANT\n#define AT(t) other[t]\n#endif' >x.c
for option in -O1 -pthread -D_REENTRANT "-D_REENTRANT -U_REENTRANT" -fopenmp -ftree-parallelize-loops=1; do
  for compiler in $compilers; do
    case $compiler$option in clang*-O1) ;; clang*) continue ;; esac # it has no such rule
    # shellcheck disable=SC2086
    build_both $compiler $option
    expect_match report '"verdict":"transformed"'
  done
done
end

begin "a source that asks which compiler this is"
ask() { # CONDITION: other[t] where it holds
  write_program "#if $1"$'\n#define AT(t) other[t]\n#endif' >x.c
}
for condition in '!defined(__clang__)' 'defined(__GNUC__) && !defined(__clang__)' '__GNUC__ > 5' \
  '__GNUC_MINOR__ != 2' 'defined(__PIE__)' 'defined(__llvm__) || __GCC_IEC_559 == 2'; do
  ask "$condition"
  build_both gcc
  expect_match report '"verdict":"transformed"' # read once more, with the macros of gcc
done
ask 'defined(__NO_MATH_ERRNO__)'
build_both gcc -fno-math-errno
expect_match report '"verdict":"transformed"'
ask 'defined(__clang__) == (MINE > 2)'
build_both gcc -DMINE=3
expect_match report '"verdict":"transformed"'
REDCC_OPTS=--report=text "$redcc_cc" gcc -DMINE=3 -c x.c 2>messages
expect_equal "$case_name: remarks" 1 "$(grep -c 'remark: loop' messages)"
for condition in '!__has_feature(x)' '__has_builtin(__builtin_assume)' '!defined(__CLANG_ATOMIC_INT_LOCK_FREE)'; do
  ask "$condition"
  sed -i '1i#ifndef __has_feature\n#define __has_feature(x) 0\n#endif' x.c
  build_both gcc -v
  expect_match messages 'it tests which compiler this is'
  expect_match report '"left_alone":"it tests which compiler this is'
done
for condition in 'defined(__GNUC__)' '__GNUC__ >= 3' 'defined(__clang__) || defined(__GNUC__)'; do
  ask "$condition"
  build_both gcc
  expect_match report '"verdict":"transformed"'
done
for compiler in $compilers; do
  [ $compiler != gcc ] || continue
  ask 'defined(__clang__)' # libclang is one as well
  build_both $compiler
  expect_match report '"verdict":"transformed"'
done
write_program '#include "which.h"' >x.c
printf '#ifdef __clang__\n#else\n#define AT(t) other[t]\n#endif\n' >which.h
build_both gcc
expect_match report '"verdict":"transformed"'
end

finish
