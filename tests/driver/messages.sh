#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What compiler and linker have to say reaches the user, no more and no less, and the files are the
# same, whatever the options are.
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM
compilers=gcc
command -v clang-19 >/dev/null && compilers+=" clang-19"

# The compiler and the wrapper with the same arguments, each in a copy of the case's folder: the same
# status, files, standard output and messages. Folders and temporaries have other names in each.
expect_same_result() { # COMPILER ARGUMENTS...
  local program status files folder names='s#/(tmp|[^ ]*redcc-cc-)[^ :]*\.o##g; s#\+0x[0-9a-f]+##'
  for program in compiler wrapper; do
    folder=$work/by
    rm -rf "$folder"
    cp -r . "$folder"
    command=("$@")
    [ $program = compiler ] || command=("$redcc_cc" "$@")
    (cd "$folder" && "${command[@]}" >"$work/$program.out" 2>"$work/$program.err" </dev/null)
    status=$?
    files=$(cd "$folder" && find . | sort)
    sed -E "$names" "$work/$program.err" >"$work/$program.messages"
    printf '%s\n' "$status" "$files" >"$work/$program.result"
  done
  cmp -s "$work/compiler.result" "$work/wrapper.result" || fail "$case_name: $*: $(diff "$work/compiler.result" "$work/wrapper.result")"
  cmp -s "$work/compiler.out" "$work/wrapper.out" || fail "$case_name: $*: standard output differs"
  cmp -s "$work/compiler.messages" "$work/wrapper.messages" ||
    fail "$case_name: $*: $(diff "$work/compiler.messages" "$work/wrapper.messages")"
}
# The same of each compiler with each line of arguments.
expect_same_results() { # "ARGUMENTS"...
  local compiler arguments
  for compiler in $compilers; do
    for arguments in "$@"; do
      # shellcheck disable=SC2086
      expect_same_result $compiler $arguments
    done
  done
}
expect_translated() { expect_match "$RECORD" '^redcc'; rm -f "$RECORD"; }

begin "the long names of gcc's options"
printf '%s' "$source_text" >x.c
for option in --assemble --preprocess --dependencies --user-dependencies; do
  expect_same_result gcc $option x.c
done
for compiler in $compilers; do
  expect_same_result $compiler --compile x.c --output y.o
  expect_same_result $compiler --pedantic --shared -fPIC x.c -o libx.so
  expect_translated
done
[ "$compilers" = gcc ] || for option in --analyze -emit-ast -ccc-print-phases; do
  expect_same_result clang-19 $option x.c
done
end

begin "an option whose argument is missing"
printf '%s' "$source_text" >x.c
cc -c x.c -o y.o
expect_same_results "-c x.c -o" "x.c -o" "y.o -o" "x.c -x"
end

begin "an input that is missing, or is none"
printf '%s' "$source_text" >x.c
expect_same_results "-c x.c missing.c" "x.c missing.o -o p" "missing.c" "x.c . -o p"
end

begin "dependencies on standard output"
printf '%s' "$source_text" >x.c
for compiler in $compilers; do
  expect_same_result $compiler -MD -MF - -c x.c
  expect_same_result $compiler -MMD -MF/dev/stdout -c x.c
  expect_same_result $compiler -MMD -MF /dev/null -c x.c
  expect_translated
done
end

begin "the linker's messages"
{ printf '%s' "$source_text"; echo 'char *tmpnam(char *); char *name(void) { return tmpnam(0); }'; } >x.c
for compiler in $compilers; do
  for options in "" "-Wunused-macros -Wl,-z,nothing"; do
    # shellcheck disable=SC2086
    expect_same_result $compiler $options x.c -o p
    expect_match "$work/wrapper.messages" 'dangerous'
    expect_translated
  done
done
end

begin "options for the linker alone, where nothing is linked and where something is"
printf '%s' "$source_text" >x.c
all="-lm -L. -Wl,-s -no-pie -fuse-ld=bfd -static-libgcc -rdynamic"
for compiler in $compilers; do
  # shellcheck disable=SC2086
  expect_same_result $compiler -shared $all -c x.c
  expect_translated
  # shellcheck disable=SC2086
  expect_same_result $compiler -Werror $all x.c -o p
  expect_translated
  expect_same_result $compiler -Werror -shared -fPIC x.c -o libx.so
  expect_translated
  expect_same_result $compiler -Wa,--noexecstack -DA -I. x.c -o p
  expect_translated
done
end

begin "a program that the runtime cannot be linked to"
printf '%s' "$source_text" >x.c
expect_same_result gcc -nostartfiles -Wl,-e,main x.c -o p
end

begin "what the optimiser says"
printf '%s' "$source_text" >x.c
echo 'void f(float *a, const float *b) { for (int i = 0; i < 64; i++) a[i] += b[i]; }' >>x.c
expect_same_result gcc -O3 -fopt-info -c x.c
expect_match "$work/wrapper.messages" 'vectorized'
expect_same_result gcc -O3 -fopt-info-vec=vectors.txt -c x.c
expect_translated
end

finish
