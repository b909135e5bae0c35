#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# redcc-cc as a guest in builds with other tools: compiler caches, CMake's interprocedural optimisation and
# unity builds, coverage, several sources in a command, precompiled headers. Each is translated, with
# the sequential program's bits, or said, and REDCC_STRICT misses none. BUILD is the build folder.
. "$(dirname "$0")/library.sh"
install_tree "$BUILD" "$work/prefix"
export PATH="$work/prefix/bin:$PATH" OMP_NUM_THREADS=3 OMP_WAIT_POLICY=passive
unset CMAKE_C_COMPILER_LAUNCHER CMAKE_GENERATOR CC CCACHE_BASEDIR CCACHE_NOHASHDIR CCACHE_DISABLE
write_sources() { # count.c, a program; other.c, the same loop in another function
  write_histogram count.c
  sed 's/int main(void)/int other(void)/' count.c >other.c
  gcc -O2 -ffp-contract=off count.c -o serial && ./serial >expected
}
expect_bits() { ./"$1" >actual && expect_same expected actual; }
# The report of a build: "transformed" for each loop that is, and why a file is left alone.
verdicts() { jq -r '(.left_alone // empty | "left alone: \(.)"), .loops[].verdict' report; }
build_reported() { rm -f report; REDCC_BUILD_REPORT=$PWD/report "$@" >log 2>&1 || fail "$case_name: $*: $(tail -n 5 log)"; }
expect_strict_error() { # PATTERN COMMAND...: said in the report, and an error where that is asked for
  local pattern=$1
  shift
  build_reported "$@"
  expect_match <(verdicts) "left alone: .*$pattern"
  REDCC_STRICT=1 "$@" >log 2>&1 && fail "$case_name: REDCC_STRICT misses it: $*"
  expect_match log "not translated \(REDCC_STRICT\): .*$pattern"
}

if command -v ccache >/dev/null; then
  begin "ccache behind and in front: the second call hits"
  write_sources
  export CCACHE_DIR="$work/case/cache" CCACHE_NOINODECACHE=1
  for how in "redcc-cc ccache gcc" "ccache redcc-cc" "ccache redcc-cc gcc"; do
    rm -rf "$CCACHE_DIR"
    for i in 1 2 3; do $how -O2 -g -c count.c -o count$i.o || fail "$case_name: $how"; done
    ccache --print-stats >stats
    hits=$(awk '/^(direct|preprocessed)_cache_hit/ {n += $2} END {print n}' stats)
    expect_equal "$case_name: $how: hits" 2 "$hits"
    expect_equal "$case_name: $how: misses" 1 "$(awk '/^cache_miss/ {print $2}' stats)"
    expect_same count1.o count2.o
    redcc-cc count3.o -o p && expect_bits p
    nm count3.o | grep -q redcc_run || fail "$case_name: $how: not translated"
  done
  # another text, the same name: no hit of the first
  sed -i 's/7919/7717/' count.c && gcc -O2 -ffp-contract=off count.c -o serial && ./serial >expected
  redcc-cc ccache gcc -O2 -g -c count.c -o count1.o && redcc-cc count1.o -o p && expect_bits p
  end
  begin "ccache that compiles preprocessed text"
  write_sources
  rm -rf "$CCACHE_DIR"
  export CCACHE_NOCPP2=1
  CCACHE_RECACHE=1 expect_strict_error 'preprocessed text' ccache redcc-cc -O2 -c count.c
  unset CCACHE_NOCPP2 CCACHE_DIR
  end
fi

begin "CMake: interprocedural optimisation, a launcher, a unity build"
write_sources
printf 'int other(void);\nint main(void) { return other(); }\n' >main.c
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.20)
project(p C)
add_library(half STATIC other.c)
add_executable(p main.c)
target_link_libraries(p half)
END
for how in -DCMAKE_C_COMPILER=redcc-cc "-DCMAKE_C_COMPILER_LAUNCHER=redcc-cc -DCMAKE_C_LINKER_LAUNCHER=redcc-cc"; do
  rm -rf b
  # shellcheck disable=SC2086
  cmake -S . -B b -DCMAKE_BUILD_TYPE=Release -DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON $how >log 2>&1 || fail "$case_name: $(tail -n 3 log)"
  build_reported cmake --build b
  expect_match <(verdicts) '^transformed'
  cp b/p p && expect_bits p
done
expect_match b/CMakeCache.txt 'CMAKE_C_COMPILER_AR:FILEPATH=.*gcc-ar'
rm -rf b
cmake -S . -B b -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_C_COMPILER=redcc-cc >log 2>&1
build_reported cmake --build b
expect_equal "$case_name: a unity build" transformed "$(verdicts)"
cp b/p p && expect_bits p
cp other.c other.kept && echo 'const char *where(void) { return __FILE__; }' >>other.c
build_reported cmake --build b
expect_equal "$case_name: a unity build, and a source that says where it is" refused "$(verdicts)"
cp b/p p && expect_bits p
mv other.kept other.c
echo 'find_package(redcc REQUIRED)
redcc_target(half)' >>CMakeLists.txt # turns the unity build of its target off
rm -rf b
cmake -S . -B b -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON "-DCMAKE_PREFIX_PATH=$work/prefix" >log 2>&1
build_reported cmake --build b
expect_equal "$case_name: redcc_target" transformed "$(verdicts)"
cp b/p p && expect_bits p
end

begin "a comment and a header of another name include no source"
write_sources
printf '/*\n#include "none.c"\n*/\n' | cat - count.c >commented.c
REDCC_STRICT=1 redcc-cc -O2 commented.c -o p 2>messages || fail "$case_name: $(cat messages)"
expect_bits p
end

begin "several sources in a command, with files other than objects"
write_sources
for options in -save-temps "-g -gsplit-dwarf"; do
  # shellcheck disable=SC2086
  expect_strict_error "files other than objects" redcc-cc -O2 $options count.c other.c -o p
  expect_bits p
  # shellcheck disable=SC2086
  REDCC_STRICT=1 redcc-cc -O2 $options -c count.c || fail "$case_name: one source with $options is translated"
done
REDCC_STRICT=1 redcc-cc -O2 count.c other.c -o p || fail "$case_name: without such options both are"
expect_bits p
end

begin "coverage is the source's own: left alone, and said"
write_sources
for options in --coverage "-fprofile-arcs -ftest-coverage"; do
  rm -f ./*.gc*
  # shellcheck disable=SC2086
  expect_strict_error "coverage counts the source's own lines" redcc-cc $options count.c -o p
  expect_bits p
  gcov -n p-count.gcda >lines 2>&1
  expect_match lines 'Lines executed:100.00% of'
done
end

begin "sanitizers, link-time optimisation, profiles: translated, or said"
write_sources
for options in -fsanitize=address -fsanitize=undefined -flto "-flto -ffat-lto-objects" -pg; do
  # shellcheck disable=SC2086
  build_reported redcc-cc -O1 $options count.c -o p
  expect_equal "$case_name: $options" transformed "$(verdicts)"
  expect_bits p
done
expect_strict_error 'cannot follow: -fsanitize=thread' redcc-cc -fsanitize=thread -c count.c
end

begin "precompiled headers"
write_sources
sed 's|<stdio.h>|"pre.h"|' count.c >pre.c
echo '#include <stdio.h>' >pre.h
REDCC_STRICT=1 redcc-cc -O2 pre.h -o pre.h.gch 2>messages || fail "$case_name: making one"
expect_empty messages
expect_strict_error 'the precompiled header pre.h.gch' redcc-cc -O2 pre.c -o p
expect_bits p
end

begin "transactional memory is said, whether there is a transaction or not"
write_sources
expect_strict_error 'cannot follow: -fgnu-tm' redcc-cc -fgnu-tm -O2 -c count.c
end

begin "options of setuptools: -fwrapv, and its undoing"
write_sources
for options in "-fwrapv" "-fwrapv -fno-wrapv"; do
  # shellcheck disable=SC2086
  build_reported redcc-cc -O2 $options count.c -o p
  expect_equal "$case_name: $options" transformed "$(verdicts)"
  expect_bits p
done
expect_strict_error 'cannot follow: -fno-strict-overflow' redcc-cc -fno-strict-overflow -O2 -c count.c
# a counter that may wrap around
sed 's/int t = 0; t < /int t = 1; t <= last - /; s/^int main/int last = 100000;\n&/' count.c >most.c
grep -q 't <= last' most.c || fail "$case_name: most.c"
for options in "-fwrapv" "-fno-wrapv -fwrapv"; do
  # shellcheck disable=SC2086
  build_reported redcc-cc -O2 $options -c most.c
  expect_match report '"counter-wraps"'
done
build_reported redcc-cc -O2 -fwrapv -fno-wrapv -c most.c
expect_match report '"transformed"'
end

begin "a header with \\U in a comment, as Python.h; outside of one it may be a macro's name"
write_sources
sed '1i#include "has.h"' count.c >with.c
pragma='#define QUIET _Pragma("GCC diagnostic push")'
printf '%s\n/* escapes: \\x, \\u and \\U */\n' "$pragma" >has.h
build_reported redcc-cc -O2 with.c -o p
expect_equal "$case_name" transformed "$(verdicts)"
expect_bits p
for text in 'static int \u00e9;' '/*/ \u00e9 */' "/* 1'000' */ static int \\u00e9;"; do
  printf '%s\n%s\n' "$pragma" "$text" >has.h
  redcc --analyze with.c -- -I. >remarks 2>&1
  expect_match remarks 'R512|error:'
done
end

begin "digraphs and trigraphs"
write_sources
sed 's/#/%:/; s/\[/<:/g; s/\]/:>/g; s/{/<%/g; s/}/%>/g' count.c >di.c
sed 's/#/??=/; s/\[/??(/g; s/\]/??)/g; s/{/??</g; s/}/??>/g' count.c >tri.c
for source in di.c "-trigraphs tri.c"; do
  # shellcheck disable=SC2086
  build_reported redcc-cc -O2 $source -o p
  expect_equal "$case_name: $source" transformed "$(verdicts)"
  REDCC_METHOD=localwrite expect_bits p
done
end

begin "C++ is named as such, and is no error"
echo 'int main() { return 0; }' >one.cpp
build_reported redcc-cc g++ -c one.cpp
expect_match <(verdicts) 'left alone: it is C\+\+'
REDCC_STRICT=1 redcc-cc g++ -c one.cpp || fail "$case_name: REDCC_STRICT is about C"
end

begin "a link that takes no library"
write_sources
redcc-cc -O2 -c count.c
redcc-cc -nostdlib count.o -o p 2>messages
expect_match messages 'redcc-cc: warning: count.o: has translated loops, and the command takes no library'
redcc-cc -r count.o -o both.o 2>messages || fail "$case_name: -r"
expect_empty messages
redcc-cc both.o -o p && expect_bits p
end

begin "static programs run in parallel, too"
write_sources
redcc-cc -O2 -c count.c
for options in -static -static-pie; do
  redcc-cc $options count.o -o p || fail "$case_name: $options"
  REDCC_METHOD=localwrite REDCC_REPORT=$PWD/run expect_bits p
  jq -e '.loops[0].threads == 3' run >/dev/null || fail "$case_name: $options: $(cat run)"
done
end

begin "a loop that gets no threads sees the errno of before"
write_sources
sed -i 's/<stdio.h>/<stdio.h>\n#include <errno.h>/; s/int main(void) {/&\n    errno = 0;/; s/for (int e/if (errno)\n        perror("loop");\n    &/' count.c
redcc-cc -O2 count.c -o p || fail "$case_name"
(ulimit -v 6000 && OMP_NUM_THREADS=8 REDCC_METHOD=localwrite REDCC_REPORT=$PWD/run ./p >actual 2>messages) || fail "$case_name: $(cat messages)"
expect_same expected actual
expect_empty messages
expect_match run '"slug": "no-threads"'
end

begin "--help and --version; options of ours that are none"
redcc-cc --version >version && expect_equal "$case_name" "$(cc --version | head -n 1)" "$(head -n 1 version)"
expect_match version '^redcc-cc [0-9.]+ runs the compiler above'
redcc-cc --help >help && expect_match help '^Usage: redcc-cc \[COMPILER\] ARGUMENTS'
redcc-cc gcc --version | cmp - <(gcc --version) || fail "$case_name: the launcher form's answer is the compiler's"
redcc-cc --redcc-sho x.c 2>messages
expect_equal "$case_name" 2 $?
expect_match messages "unknown option '--redcc-sho'"
end

begin "remarks and the build's report at once"
write_sources
REDCC_OPTS=--report=text build_reported redcc-cc -O2 -c count.c
expect_match log 'count.c:7:5: remark: loop in .main. runs in parallel'
expect_equal "$case_name" transformed "$(verdicts)"
build_reported redcc-cc -Rredcc -O2 -c count.c
expect_match log 'count.c:7:5: remark: loop in .main. runs in parallel'
expect_equal "$case_name: -Rredcc" transformed "$(verdicts)"
REDCC_OPTS="--report=json --report-file=own.json" build_reported redcc-cc -O2 -c count.c
jq -e '.loops[0].verdict == "transformed"' own.json >/dev/null || fail "$case_name: the user's own report"
expect_equal "$case_name" transformed "$(verdicts)"
end
finish
