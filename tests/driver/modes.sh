#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What redcc-cc produces in each mode of a compiler: the same files, under the same names.
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM

# Runs the compiler and the wrapper with the same arguments in two copies of the case's folder and
# expects the same files to be there afterwards, the same status and the same standard output.
expect_same_files() {
  local gcc_status wrapper_status
  rm -rf ../by-compiler ../by-wrapper
  cp -r . ../by-compiler
  cp -r . ../by-wrapper
  (cd ../by-compiler && cc "$@" >../compiler.out 2>../compiler.err </dev/null)
  gcc_status=$?
  (cd ../by-wrapper && "$redcc_cc" "$@" >../wrapper.out 2>../wrapper.err </dev/null)
  wrapper_status=$?
  expect_equal "$case_name: status of $*" "$gcc_status" "$wrapper_status"
  expect_equal "$case_name: files of $*" "$(cd ../by-compiler && find . | sort)" \
    "$(cd ../by-wrapper && find . | sort)"
}

begin "compile and link"
printf '%s' "$source_text" >x.c
expect_same_files -O1 x.c -o p
expect_equal "$case_name" "translated ran" "$(../by-wrapper/p | paste -sd' ')"
expect_same_files x.c
expect_equal "$case_name" "translated ran" "$(../by-wrapper/a.out | paste -sd' ')"
end

begin "-c names the object after the source, in the current folder"
mkdir -p a/b
printf '%s' "$source_text" >a/b/x.c
expect_same_files -c a/b/x.c
expect_file ../by-wrapper/x.o
expect_same_files -c a/b/x.c -o a/y.o
expect_same_files -c a/b/x.c -oz.o
end

begin "objects link"
printf '%s' "$source_text" >x.c
"$redcc_cc" -c x.c && "$redcc_cc" x.o -o p || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(./p | paste -sd' ')"
end

begin "several sources"
printf '%s' "$source_text" >x.c
echo 'int f(void) { return 3; }' >f.c
mkdir sub
echo '
#include <stdio.h>
#define MARK
void g(void) {
    MARK;
    puts("g");
}' >sub/x.c
expect_same_files -c x.c f.c
expect_same_files -c x.c f.c -o both.o
expect_same_files x.c f.c sub/x.c -o p
expect_equal "$case_name" "translated ran" "$(../by-wrapper/p | paste -sd' ')"
printf 'void g(void);\nint main(void) { g(); return 0; }\n' >m.c
"$redcc_cc" sub/x.c m.c f.c -o q || fail "$case_name: q"
expect_equal "$case_name" "translated g" "$(./q | paste -sd' ')"
"$redcc_cc" -c m.c && "$redcc_cc" m.o -x c sub/x.c -x none -o q2 || fail "$case_name: q2"
expect_equal "$case_name" "translated g" "$(./q2 | paste -sd' ')"
"$redcc_cc" -x c m.c sub/x.c -o q3 || fail "$case_name: q3"
expect_equal "$case_name" "translated g" "$(./q3 | paste -sd' ')"
end

begin "-S"
printf '%s' "$source_text" >x.c
expect_same_files -S x.c
expect_match ../by-wrapper/x.s redcc_run
"$redcc_cc" -S x.c -o - >out.s || fail "$case_name"
expect_match out.s redcc_run
end

begin "-E, -M and -fsyntax-only are the compiler's own"
printf '%s' "$source_text" >x.c
for mode in -E -M -MM "-E -dM"; do
  # shellcheck disable=SC2086
  expect_same_files $mode x.c
  expect_same ../compiler.out ../wrapper.out
done
expect_same_files -fsyntax-only x.c
expect_no_file "$RECORD"
end

begin "questions to the compiler"
for question in --version -v -dumpversion -dumpmachine -print-search-dirs --help -print-file-name=libc.so; do
  cc $question >expected 2>&1
  "$redcc_cc" $question >actual 2>&1
  case $question in --version | --help) # and then what redcc-cc is
    tail -n "+$(($(wc -l <expected) + 1))" actual >own
    expect_match own 'redcc-cc'
    head -n "$(wc -l <expected)" actual >first && mv first actual ;;
  esac
  expect_same expected actual
done
printf '%s' "$source_text" >x.c
cc '-###' -c x.c >expected 2>&1
"$redcc_cc" '-###' -c x.c >actual 2>&1
sed -i 's/cc[A-Za-z0-9]*\.s//g' expected actual
expect_same expected actual
expect_no_file x.o
"$redcc_cc" -v -c x.c 2>messages || fail "$case_name -v -c"
expect_match messages "cc1"
end

begin "no input, an unknown option, a missing file"
expect_same_files
expect_same_files -O2
expect_same_files --no-such-option x.c
expect_same_files -c missing.c
expect_match ../wrapper.err "missing.c"
end

begin "standard input"
printf '%s' "$source_text" >x.text
"$redcc_cc" -x c - -o p <x.text || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(./p | paste -sd' ')"
cp x.text ../x.text
(mkdir c w && cd c && cc -x c -c - <../x.text && cd ../w && "$redcc_cc" -xc -c - <../x.text)
expect_equal "$case_name: object" "$(ls c)" "$(ls w)"
"$redcc_cc" -E -x c - <x.text | grep -q 'puts("ran")' || fail "$case_name -E"
echo 'int f( {' | "$redcc_cc" -x c -c - 2>messages && fail "$case_name: accepted"
expect_match messages '<stdin>:1'
end

begin "response files"
printf '%s' "$source_text" >'my x.c'
printf '%s\n' '-O1 "my x.c"' '-o my\ p @more' >args
echo "'-DFOO=a b'" >more
"$redcc_cc" @args || fail "$case_name"
expect_equal "$case_name" "translated ran" "$('./my p' | paste -sd' ')"
printf '%s\n' "-include stdio.h '-DMARKED=puts(\"a\\\\tb\")' 'my x.c' -o quoted" >args
sed -i 's/MARK;/&\n    MARKED;/' 'my x.c'
cc @args -o by_compiler && "$redcc_cc" @args || fail "$case_name: quotes"
expect_equal "$case_name" "translated $(./by_compiler | paste -sd' ')" "$(./quoted | paste -sd' ')"
"$redcc_cc" -c @missing 2>messages && fail "$case_name: accepted"
expect_match messages '@missing'
end

begin "a command too long for the system, by a response file"
printf '%s' "$source_text" >x.c
deep=$(printf '%0200d' 0)
mkdir "$deep"
echo 'int f(void) { return 3; }' | cc -x c -c - -o f.o && ar rcs "$deep/f.a" f.o
yes "$deep/f.a" | head -n 12000 >args
"$redcc_cc" x.c @args -o p 2>messages || fail "$case_name: $(head -c 300 messages)"
expect_equal "$case_name" "translated ran" "$(./p | paste -sd' ')"
end

begin "other languages pass through"
printf '%s' "$source_text" >x.c
cp x.c x.cpp
cc -E x.c -o x.i
cc -S x.c -o x.s
cp x.s y.S
rm -f "$RECORD"
for file in x.cpp x.i x.s y.S; do
  expect_same_files -c "$file"
done
expect_same_files -c -x c++ x.c
expect_same_files -c -x cpp-output x.i
expect_no_file "$RECORD"
end

begin "-x in effect at the end does not reach the runtime"
printf '%s' "$source_text" >x.text
"$redcc_cc" -o p -x c x.text || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(./p | paste -sd' ')"
end

begin "-save-temps"
printf '%s' "$source_text" >x.c
expect_same_files -save-temps -c x.c
expect_same_files -save-temps x.c -o p
expect_same_files -save-temps=obj -c x.c -o sub.o
echo 'int f(void) { return 3; }' >f.c
expect_same_files -save-temps x.c f.c -o p
end

begin "-pipe, -flto, -static, -shared, coverage"
printf '%s' "$source_text" >x.c
printf '#define MARK\nvoid g(void) {\n    MARK;\n}\n' >g.c
expect_same_files -pipe -c x.c
expect_same_files -flto -O2 x.c -o p
expect_equal "$case_name" "translated ran" "$(../by-wrapper/p | paste -sd' ')"
expect_same_files -static x.c -o p
expect_same_files --coverage -c x.c
expect_same_files --coverage x.c -o p
expect_same_files -shared -fPIC x.c -o libx.so
expect_same_files -r x.c -o x.ro
"$redcc_cc" -c x.c -o x.o || fail "$case_name"
expect_same_files -r x.o -o y.ro
end

begin "untranslated programs need nothing new"
echo 'int main(void) { return 0; }' >m.c
cc m.c -o by-cc && "$redcc_cc" m.c -o by-redcc
expect_equal "$case_name" "$(readelf -d by-cc | grep NEEDED)" "$(readelf -d by-redcc | grep NEEDED)"
expect_same by-cc by-redcc
cc -g -O2 -c m.c -o by-cc.o && "$redcc_cc" -g -O2 -c m.c -o by-redcc.o
expect_same by-cc.o by-redcc.o
end

begin "--redcc-report: what would be translated is in the report, and nothing is compiled"
printf '%s' "$source_text" >x.c
grep -v MARK x.c >y.c
REDCC_BUILD_REPORT=report "$redcc_cc" -O2 -MD -c x.c -o x.o --redcc-report >said 2>&1 || fail "$case_name"
REDCC_BUILD_REPORT=report "$redcc_cc" --redcc-report -O2 y.c -o y || fail "$case_name"
REDCC_BUILD_REPORT=report "$redcc_cc" --redcc-report -ftrapv -c x.c || fail "$case_name"
REDCC_BUILD_REPORT=report "$redcc_cc" --redcc-report x.o -o y || fail "$case_name"
expect_empty said
expect_equal "$case_name: files" "report said x.c y.c" "$(echo *)"
expect_equal "$case_name: lines" "x.c false y.c false x.c true" \
  "$(jq -r '[.file, (.left_alone != null)] | join(" ")' report | paste -sd ' ')"
end

begin "--redcc-show, --redcc-help, --redcc-version"
printf '%s' "$source_text" >x.c
"$redcc_cc" --redcc-show -O2 -c x.c >shown || fail "$case_name"
expect_no_file x.o
expect_no_file "$RECORD"
expect_match shown "bin/redcc' x.c -o "
expect_match shown "-ffp-contract=off"
expect_no_match shown "fopenmp"
expect_no_match shown "falign"
echo redcc_run | tr '\n' '\0' >y.o
"$redcc_cc" --redcc-show x.o y.o -o p >shown || fail "$case_name"
expect_match shown "-Wl,-u,redcc_run.*libredcc_rt.a'"
"$redcc_cc" --redcc-help | grep -q '^Usage' || fail "$case_name: help"
"$redcc_cc" --redcc-version | grep -q '^redcc-cc [0-9]' || fail "$case_name: version"
end

finish
