#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The launcher form, and compilers that lead back to redcc-cc.
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM
run_p() { ./p | paste -sd' '; }

begin "launcher form"
printf '%s' "$source_text" >x.c
"$redcc_cc" gcc x.c -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
"$redcc_cc" /usr/bin/gcc -c x.c && "$redcc_cc" /usr/bin/gcc x.o -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
"$redcc_cc" "$FAKES/compiler" -c x.c || fail "$case_name"
expect_match "$RECORD" '^cc .*/0/x\.c'
if command -v clang-19 >/dev/null; then
  "$redcc_cc" clang-19 x.c -o p || fail "$case_name"
  expect_equal "$case_name" "translated ran" "$(run_p)"
fi
REDCC_CC=/no/such/compiler "$redcc_cc" gcc -c x.c || fail "$case_name: REDCC_CC does not matter"
"$redcc_cc" gcc --version >actual && gcc --version | expect_same actual /dev/stdin
end

begin "a compiler named after a source is no compiler"
printf '%s' "$source_text" >x.c
chmod +x x.c
"$redcc_cc" x.c -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
"$redcc_cc" -c x.c && chmod +x x.o && "$redcc_cc" x.o -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
end

begin "further launchers"
printf '%s' "$source_text" >x.c
mkdir bin
printf '#!/bin/bash\necho "ccache $1" >>"$RECORD"\nexec "$@"\n' >bin/ccache
chmod +x bin/ccache
PATH="$PWD/bin:$PATH" "$redcc_cc" ccache gcc x.c -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
expect_match "$RECORD" '^ccache gcc'
PATH="$PWD/bin:$PATH" REDCC_CC="ccache gcc" "$redcc_cc" x.c -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
end

begin "a launcher that looks up what it compiled: the same text has the same path, and no question goes to it"
printf '%s' "$source_text" >x.c
mkdir bin other
printf '#!/bin/bash\nprintf "%%s\\n" "$@" >>"$RECORD.launched"\nexec "$@"\n' >bin/ccache
chmod +x bin/ccache
launched() { grep '^/.*/x\.c$' "$RECORD.launched" | sort -u; }
compile() { PATH="$work/case/bin:$PATH" "$redcc_cc" ccache gcc "$@" || fail "$case_name: $*"; }
rm -f "$RECORD.launched"
compile -c x.c
compile -O2 -c x.c
touch -d '2001-01-01' x.c && compile -c x.c
expect_match <(launched) '/redcc-cc-[0-9a-f]{16}/x\.c$'
expect_equal "$case_name: paths" 1 "$(launched | wc -l)"
expect_no_match "$RECORD.launched" '^(-M|-print-.*|-dM|-E)$'
[ -z "$(ls -A "$TMPDIR")" ] || fail "$case_name: left: $(ls "$TMPDIR")"
echo '/* another */' >>x.c
compile -c x.c
expect_equal "$case_name: another text" 2 "$(launched | wc -l)"
for i in 1 2 3 4 5 6; do (compile -c x.c -o x$i.o) & done
wait
for i in 2 3 4 5 6; do expect_same x1.o x$i.o; done
# the name is taken by what is none of this user's: a private folder, as ever
shared=$(launched | tail -n 1 | sed 's|/x\.c$||')
[ "$(grep -cxF "$shared/x.c" "$RECORD.launched")" -ge 6 ] || shared=$(launched | head -n 1 | sed 's|/x\.c$||')
mkdir -m 755 "$shared"
rm -f "$RECORD.launched"
compile x.c -o p
expect_equal "$case_name" "translated ran" "$(run_p)"
expect_no_match "$RECORD.launched" 'redcc-cc-[0-9a-f]{16}/'
rmdir "$shared" || fail "$case_name: a file was left in a folder of somebody else"
# two sources of one text and name, in one command
cp x.c other/x.c && sed -i 's/main/other/' x.c other/x.c && cp other/x.c other/y.c
compile -c x.c other/y.c
end

begin "g++ takes C for C++, a cross compiler is for another machine"
printf '%s' "$source_text" >x.c
mkdir bin && cp "$FAKES/compiler" bin/g++
"$redcc_cc" bin/g++ -c x.c || fail "$case_name"
cp "$FAKES/compiler" bin/arm-linux-gnueabi-gcc && cp "$FAKES/compiler" "bin/$(uname -m)-linux-gnu-gcc-12"
"$redcc_cc" bin/arm-linux-gnueabi-gcc -v -c x.c 2>messages || fail "$case_name"
expect_match messages 'another machine'
expect_no_match "$RECORD" '^redcc'
"$redcc_cc" "bin/$(uname -m)-linux-gnu-gcc-12" -c x.c || fail "$case_name"
expect_match "$RECORD" '^redcc'
end

begin "redcc-cc called by a compiler's name, first in PATH"
printf '%s' "$source_text" >x.c
mkdir bin
for name in cc gcc; do ln -s "$redcc_cc" "bin/$name"; done
for name in cc gcc; do
  (PATH="$PWD/bin:$PATH" && timeout 20 "$name" x.c -o p) || fail "$case_name"
  expect_equal "$case_name: $name" "translated ran" "$(run_p)"
done
(PATH="$PWD/bin:$PATH" && timeout 20 "$redcc_cc" cc x.c -o p) || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
(PATH="$PWD/bin:$PATH" && timeout 20 "$redcc_cc" "$PWD/bin/cc" x.c -o p) || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
end

begin "REDCC_CC is redcc-cc"
printf '%s' "$source_text" >x.c
mkdir bin && ln -s "$redcc_cc" bin/redcc-cc
for value in "$redcc_cc" "$PWD/bin/redcc-cc"; do
  REDCC_CC="$value" timeout 20 "$redcc_cc" x.c -o p || fail "$case_name"
  expect_equal "$case_name" "translated ran" "$(run_p)"
done
(PATH="$PWD/bin:$PATH" && REDCC_CC=redcc-cc timeout 20 redcc-cc x.c -o p) || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
(PATH="$PWD/bin:$PATH" && timeout 20 redcc-cc redcc-cc gcc x.c -o p) || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
end

begin "a compiler that is a script around redcc-cc"
printf '%s' "$source_text" >x.c
printf '#!/bin/bash\nexec "%s" "$@"\n' "$redcc_cc" >wrapper
chmod +x wrapper
# its own compiler is another one: translated once, no circle
timeout 20 "$redcc_cc" ./wrapper x.c -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(run_p)"
expect_equal "$case_name: once" 1 "$(grep -c '^redcc' "$RECORD")"
# it is its own compiler: a clear error, no circle
REDCC_CC="$PWD/wrapper" timeout 20 "$redcc_cc" x.c -o p2 2>messages
expect_equal "$case_name" 1 $?
expect_match messages 'redcc-cc: error: .*calls redcc-cc again'
end

begin "nothing but itself in PATH"
printf '%s' "$source_text" >x.c
mkdir bin && ln -s "$redcc_cc" bin/cc
(PATH="$PWD/bin" && cc x.c -o p 2>messages)
expect_equal "$case_name" 1 $?
expect_match messages 'REDCC_CC'
end

finish
