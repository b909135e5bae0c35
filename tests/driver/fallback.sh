#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Whatever fails, the build gives the same result as without redcc-cc.
# covers: row 69, row 70
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM

# Expects x.c to compile and run untranslated; messages in `messages`.
expect_untranslated() {
  "$redcc_cc" "$@" x.c -o p 2>messages || fail "$case_name: $(cat messages)"
  expect_equal "$case_name" "ran" "$(./p | paste -sd' ')"
}

begin "the translator refuses the source: quietly"
printf '%s' "$source_text" >x.c
FAKE_STATUS=1 expect_untranslated
expect_empty messages
FAKE_STATUS=1 expect_untranslated -v
expect_match messages 'redcc-cc: note: x\.c: compiled as it is: .*fake trouble'
end

begin "the translator fails (libclang is missing, it crashes): one line"
printf '%s' "$source_text" >x.c
for status in 2 3 126 127 134; do
  FAKE_STATUS=$status expect_untranslated
  expect_match messages '^redcc-cc: warning: x\.c: compiled as it is: redcc failed: .*fake trouble$'
  expect_equal "$case_name" 1 "$(wc -l <messages)"
done
printf '#!/bin/bash\nkill -SEGV $$\n' >"$work/root/bin/redcc"
expect_untranslated # some sources make the parser crash: that is worth a line for who asks by -v
expect_empty messages
printf 'no program' >"$work/root/bin/redcc"
expect_untranslated
expect_match messages 'redcc failed'
printf '#!/no/such/interpreter\n' >"$work/root/bin/redcc"
expect_untranslated
printf '#!/bin/bash\nexit 0\n' >"$work/root/bin/redcc"
expect_untranslated
make_root "$work/root"
end

begin "redcc, its runtime or its header is missing"
printf '%s' "$source_text" >x.c
for gone in bin/redcc lib/libredcc_rt.a include/redcc/runtime.h; do
  mv "$work/root/$gone" "$work/gone"
  expect_untranslated
  expect_match messages "^redcc-cc: warning: .* not found"
  "$redcc_cc" -c x.c 2>messages && cc x.o -o p || fail "$case_name: $gone -c"
  mv "$work/gone" "$work/root/$gone"
done
REDCC_ROOT=/nonexistent expect_untranslated
end

begin "the translated text does not compile"
printf '%s' "$source_text" >x.c
echo 'int f(void) { return 3; }' >f.c
expect_regret() {
  expect_match messages '^redcc-cc: warning: x\.c: the translated text does not compile.*report'
  expect_equal "$case_name: one line" 1 "$(wc -l <messages)"
}
FAKE_BREAK=1 expect_untranslated
expect_regret
FAKE_BREAK=1 "$redcc_cc" -c x.c 2>messages || fail "$case_name"
expect_regret
cc x.o -o p || fail "$case_name"
expect_equal "$case_name" "ran" "$(./p)"
FAKE_BREAK=1 "$redcc_cc" -c x.c f.c 2>messages || fail "$case_name: several"
expect_regret
cc x.o f.o -o p || fail "$case_name"
expect_equal "$case_name" "ran" "$(./p)"
FAKE_BREAK=1 "$redcc_cc" x.c f.c -o p 2>messages || fail "$case_name: several, linked"
expect_regret
expect_equal "$case_name" "ran" "$(./p)"
end

begin "errors of the user's are shown once, with the compiler's status"
printf 'int f(void) {\n    return undeclared;\n}\n#define MARK\nvoid g(void) {\n    MARK;\n}\n' >e.c
cc -c e.c 2>expected
expect_equal "$case_name" 1 $?
"$redcc_cc" -c e.c 2>messages
expect_equal "$case_name" 1 $?
expect_same expected messages
printf '#define MARK\nvoid missing(void);\nint main(void) {\n    MARK;\n    missing();\n    return 0;\n}\n' >u.c
"$redcc_cc" u.c -o p 2>messages
expect_equal "$case_name: link" 1 $?
expect_equal "$case_name: link" 1 "$(grep -c 'undefined reference' messages)"
expect_no_match messages 'redcc_run|redcc-cc'
expect_no_file p
"$redcc_cc" -c u.c && "$redcc_cc" u.o -o p 2>messages
expect_equal "$case_name: objects" 1 "$(grep -c 'undefined reference' messages)"
expect_no_match messages 'redcc_run'
end

begin "a runtime that does not link"
printf '%s' "$source_text" >x.c
cp "$work/root/lib/libredcc_rt.a" "$work/saved"
echo garbage >"$work/root/lib/libredcc_rt.a"
expect_untranslated
echo 'int redcc_run(void) __attribute__((weak)); int main(void) { return redcc_run ? redcc_run() : 0; }' >m.c
cc -c m.c && "$redcc_cc" m.o -o p2 2>messages || fail "$case_name: $(cat messages)"
expect_match messages '^redcc-cc: warning: linked without the runtime'
expect_equal "$case_name: one line" 1 "$(wc -l <messages)"
cp "$work/saved" "$work/root/lib/libredcc_rt.a"
end

begin "no temporary folder"
printf '%s' "$source_text" >x.c
TMPDIR=/nonexistent "$redcc_cc" -c x.c 2>messages || cat messages
: >"$work/file"
for place in "$work/file" /proc/self; do
  # the compiler itself looks for another place; redcc-cc does without
  TMPDIR="$place" "$redcc_cc" x.c -o p 2>messages || fail "$case_name: $place: $(cat messages)"
  expect_equal "$case_name" "ran" "$(./p | paste -sd' ')"
done
end

begin "checks by configure scripts, CMake and Meson are not touched"
printf '%s' "$source_text" >conftest.c
"$redcc_cc" conftest.c -o conftest || fail "$case_name"
"$redcc_cc" -c conftest.c && "$redcc_cc" -o conftest conftest.o || fail "$case_name"
for folder in CMakeFiles/CMakeScratch/TryCompile-abc CMakeFiles/CMakeTmp CMakeFiles/CompilerIdC meson-private/tmpxyz; do
  mkdir -p "$folder"
  (cd "$folder" && printf '%s' "$source_text" >x.c && "$redcc_cc" x.c -o p) || fail "$case_name: $folder"
done
printf '%s' "$source_text" >CMakeCCompilerId.c
"$redcc_cc" CMakeCCompilerId.c || fail "$case_name"
expect_no_file "$RECORD"
end

begin "DEPENDENCIES_OUTPUT"
printf '%s' "$source_text" >x.c
DEPENDENCIES_OUTPUT=1.d cc -c x.c && DEPENDENCIES_OUTPUT=2.d "$redcc_cc" -c x.c
expect_same 1.d 2.d
end

begin "a source that can be read but once"
"$redcc_cc" -x c <(printf '%s' "$source_text") -o p || fail "$case_name"
expect_equal "$case_name" "ran" "$(./p)"
end

begin "options that redcc cannot follow"
printf '%s' "$source_text" >x.c
for option in -ffreestanding -Xpreprocessor\ -DA -Wp,-I. -P --specs=/dev/null -nostdlib\ -c; do
  # shellcheck disable=SC2086
  "$redcc_cc" $option -c x.c -o x.o 2>/dev/null || [ "$option" = --specs=/dev/null ] || fail "$case_name: $option"
done
expect_no_file "$RECORD"
expect_untranslated -v -ffreestanding
expect_match messages 'an option that redcc cannot follow'
end

begin "a source with OpenMP in it, and OpenMP off: it is translated, and the pragmas stay asleep"
{ printf '%s' "$source_text"; echo '#pragma omp declare simd'; echo 'int k(int a) { return a; }'; } >x.c
for option in -O1 -fopenmp; do
  "$redcc_cc" $option x.c -o p || fail "$case_name"
  expect_equal "$case_name" "translated ran" "$(./p | paste -sd' ')"
done
{ echo '#include "has_omp.h"'; printf '%s' "$source_text"; } >x.c
printf '#ifdef _OPENMP\n#define puts(x) puts("other " x)\n#endif\n' >has_omp.h
"$redcc_cc" x.c -o p || fail "$case_name"
expect_equal "$case_name: its macro" "translated ran" "$(./p | paste -sd' ')"
# ... and what never becomes awake makes no difference
cat >has_omp.h <<'END'
/* omp parallel would help here */
#ifdef USE_OMP
#include <omp.h>
#pragma omp parallel for
#endif
#ifdef _OPENMP
#define NOTHING
#endif
END
"$redcc_cc" -v x.c -o p 2>messages || fail "$case_name: a word in dead code"
expect_equal "$case_name: a word in dead code" "translated ran" "$(./p | paste -sd' ')"
headers=""
for header in assert complex ctype errno fenv float inttypes iso646 limits locale math pthread setjmp \
  signal stdalign stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string strings \
  tgmath threads time uchar unistd wchar wctype sys/stat sys/types sys/time; do
  headers+="#include <$header.h>"$'\n'
done
printf '%s%s' "$headers" "$source_text" >x.c
"$redcc_cc" -v x.c -o p 2>messages || fail "$case_name: $(cat messages)"
expect_equal "$case_name: the standard headers" "translated ran" "$(./p | paste -sd' ')"
end

begin "a precompiled header: made for the options of the source itself"
printf '%s' "$source_text" >x.c
mkdir elsewhere && echo '#define NOTHING' >elsewhere/all.h
gcc -x c-header elsewhere/all.h -o elsewhere/all.h.gch
for options in "-include elsewhere/all.h" "-Ielsewhere -Winvalid-pch -include all.h"; do
  # shellcheck disable=SC2086
  expect_untranslated gcc -v $options
  expect_match messages 'the precompiled header elsewhere/all\.h\.gch'
  # shellcheck disable=SC2086
  expect_untranslated gcc $options
  expect_empty messages
done
rm elsewhere/all.h.gch
"$redcc_cc" -include elsewhere/all.h x.c -o p && expect_equal "$case_name: none" "translated ran" "$(./p | paste -sd' ')"
end

begin "what the translator is told"
printf '%s' "$source_text" >x.c
mkdir inc
"$redcc_cc" -O2 -Wall -Iinc -I inc -DA='"a b"' -D B -UC -std=gnu11 -include stdio.h -isystem inc \
  -march=native -Wp,-DX=1,-DY -MD -MF x.d -pthread -fopenmp -g -o p -L. -lm x.c || fail "$case_name"
expect_match "$RECORD" '-- -O2 -Iinc -I inc -DA="a b" -D B -UC -std=gnu11 -include stdio.h -isystem inc -march=native -DX=1 -DY -pthread -fopenmp -pthread$'
end

finish
