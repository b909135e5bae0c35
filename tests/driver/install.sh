#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The installed tree: complete, movable, with nothing in it that points to where it was built.
# BUILD is the build folder, SOURCE the source folder.
. "$(dirname "$0")/library.sh"
install_tree "$BUILD" "$work/first"
mv "$work/first" "$work/prefix" # whatever knows its place by heart breaks here
prefix=$work/prefix library=$work/prefix/$(library_folder "$BUILD")

begin "the tree"
for file in bin/redcc bin/redcc-cc include/redcc/runtime.h \
  share/man/man1/redcc.1 share/man/man1/redcc-cc.1 share/man/man1/fabric.1 \
  share/bash-completion/completions/redcc share/bash-completion/completions/redcc-cc \
  share/bash-completion/completions/fabric; do
  expect_file "$prefix/$file"
done
for file in libredcc_rt.a libredcc_rt.so pkgconfig/redcc.pc pkgconfig/redcc-runtime.pc cmake/redcc/redcc-config.cmake cmake/redcc/redcc-config-version.cmake; do
  expect_file "$library/$file"
done
if [ -e "$BUILD/examples/fabric/fabric" ]; then
  expect_file "$prefix/bin/fabric"
  expect_file "$prefix/bin/fabric-serial"
fi
end

begin "nothing points back"
# debugging information (a Debug build) names the sources, as it should; look at the rest
cp -r "$prefix" stripped
find stripped -type f \( -path '*/bin/*' -o -name '*.so*' -o -name '*.a' \) -exec strip -g {} + 2>/dev/null
for folder in "$BUILD" "$work/first"; do
  found=$(grep -rlF -- "$folder" stripped)
  expect_equal "$case_name: $folder" "" "$found"
done
# fabric's loops say in reports where they stand in its sources, by the path that CMake gave; nothing
# else may know where the sources were
found=$(grep -rlF -- "$SOURCE" stripped | grep -v bin/fabric)
expect_equal "$case_name: $SOURCE" "" "$found"
for program in "$prefix"/bin/* "$library"/*.so; do
  readelf -d "$program" 2>/dev/null >dynamic
  expect_no_match dynamic 'RPATH|RUNPATH'
  ldd "$program" 2>/dev/null >libraries
  expect_no_match libraries 'not found'
done
end

begin "every program says its version"
"$prefix/bin/redcc" --version >version || fail redcc
"$prefix/bin/redcc-cc" --redcc-version >>version || fail redcc-cc
expect_match version '[0-9]+\.[0-9]+\.[0-9]+'
end

begin "a summary says where to read on"
echo '{"redcc":"1","file":"a.c","loops":[],"left_alone":"it is C++"}' >report
"$prefix/bin/redcc-cc" --redcc-summary report >summary || fail "$case_name"
page=$(sed -n 's|^  what can be done: file://||p' summary)
page=$(printf %b "${page//%/\\x}") # as a URI spells it
grep -q '^# My loop was refused' "$page" || fail "$case_name: '$page'"
end

begin "pkg-config"
export PKG_CONFIG_PATH="$library/pkgconfig"
expect_equal version "$("$prefix/bin/redcc-cc" --redcc-version | sed 's/.* //')" "$(pkg-config --modversion redcc)"
cat >use.c <<'END'
#include <redcc/runtime.h>
REDCC_REQUIRE_VERSION(REDCC_RUNTIME_VERSION);
int main(void) { return redcc_run == 0; }
END
eval "cc use.c $(pkg-config --cflags --libs redcc) -o use" || fail "$case_name"
./use || fail "$case_name: a program starts without a variable"
eval "cc use.c $(pkg-config --cflags redcc) -L'$library' -Wl,--no-as-needed -lredcc_rt -o use-shared" || fail "$case_name: shared"
LD_LIBRARY_PATH="$library" ./use-shared || fail "$case_name: run the shared one"
end

begin "manual pages and completions"
if command -v man >/dev/null; then
  for page in "$prefix"/share/man/man1/*.1; do
    man --warnings -l "$page" >text 2>messages || fail "$page"
    expect_empty messages
    expect_no_match "$page" '@[A-Z_]+@'
  done
fi
for file in "$prefix"/share/bash-completion/completions/*; do bash -n "$file" || fail "$file"; done
complete_with() { # FILE FUNCTION WORDS...: what is offered for the last word
  bash -c '. "$1"; COMP_WORDS=("${@:3}"); COMP_CWORD=$(($# - 3)); "$2" 2>/dev/null; echo "${COMPREPLY[*]}"' \
    - "$prefix/share/bash-completion/completions/$1" "${@:2}"
}
expect_equal completion json "$(complete_with redcc _redcc redcc --report = j)"
expect_equal completion --order= "$(complete_with redcc _redcc redcc --or)"
expect_equal completion --redcc-show "$(complete_with redcc-cc _redcc_cc redcc-cc --redcc-sh)"
expect_equal completion render "$(complete_with fabric _fabric fabric re)"
expect_equal completion R204 "$(PATH="$prefix/bin:$PATH" complete_with redcc _redcc redcc --explain R20 | grep -o R204)"
# what a page or a completion names, the program knows, and the other way round
"$prefix/bin/redcc" --help >help
for program in redcc redcc-cc; do
  "$prefix/bin/$program" "$([ $program = redcc ] && echo --help || echo --redcc-help)" |
    grep -oE '^  --[a-z-]+|, --[a-z]+$' | grep -oE -- '--[a-z-]+' | while read -r option; do
    expect_match "$prefix/share/bash-completion/completions/$program" "$option"
  done
done
for option in $(grep -oE -- '--[a-z-]+' "$prefix/share/bash-completion/completions/redcc" | sort -u); do
  expect_match help "$option"
done
end

begin "the installed redcc-cc, from a folder with spaces, on a real loop"
write_histogram 'a loop.c'
cc -O2 -ffp-contract=off 'a loop.c' -o serial && ./serial >expected
for compiler in gcc clang-19; do
  command -v $compiler >/dev/null || continue
  for how in "-O0" "-O2" "-O3 -march=native -flto" "-O2 -static" "-std=c99 -pedantic-errors -Wall -Werror -O1" "-g -O2 -fsanitize=undefined"; do
    [ "$compiler $how" != "clang-19 -O2 -static" ] || continue # has no static libomp
    # shellcheck disable=SC2086
    REDCC_KEEP=$PWD/kept "$prefix/bin/redcc-cc" $compiler $how 'a loop.c' -o parallel 2>messages || fail "$compiler $how"
    # a static libgomp draws this from the linker, redcc or not
    # ... and what clang remarks on -march=native where it is newer than the processor.
    grep -vE 'dlopen|libgomp\.a|invalid-feature-combination|^[0-9]+ warnings? generated' messages >others
    expect_empty others
    expect_match 'kept/a loop.c' REDCC_ATTEMPT
    rm -r kept
    for threads in 1 2 3; do
      OMP_NUM_THREADS=$threads ./parallel | expect_same expected /dev/stdin
    done
    nm parallel | grep -q redcc_run || fail "$compiler $how: not parallel"
  done
done
end

begin "libclang is missing"
cp -r "$prefix" broken
library=$(readelf -d broken/bin/redcc | sed -n 's/.*NEEDED.*\[\(libclang[^]]*\)\]/\1/p')
[ -n "$library" ] || fail "$case_name: redcc is not linked to libclang"
# a name as long, of a library that no system has
sed -i "s/$library/libcl@ng${library#libclang}/" broken/bin/redcc
broken/bin/redcc in.c -o out.c 2>messages
expect_equal "$case_name: redcc" 127 $?
expect_match messages 'libcl@ng.*cannot open shared object file'
cat >loop.c <<'END'
static double b[64];
static int s[1000];
int main(void) {
    for (int t = 0; t < 1000; t++)
        b[s[t]] += 1.0 / (1 + t);
    return b[1] > 0;
}
END
broken/bin/redcc-cc -O2 loop.c -o p 2>messages || fail "$case_name: $(cat messages)"
./p || fail "$case_name: the program does not run"
expect_match messages '^redcc-cc: warning: loop\.c: compiled as it is: redcc failed: .*libcl@ng'
expect_equal "$case_name: one line" 1 "$(wc -l <messages)"
end

finish
