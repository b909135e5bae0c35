#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Headers: found as the compiler finds them for the source itself; dependency files and the names in
# objects are the compiler's own.
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM

# A project whose headers include one another from several folders.
make_project() {
  mkdir -p src/inner inc obj 'a dir'
  cat >src/x.c <<'END'
#include <stdio.h>
#include "x.h"
#include "../inc/far.h"
#include <near.h>
#define MARK
int main(void) {
    MARK;
    puts(__FILE__);
    puts(x_file());
    puts(far_file());
    puts(near_file());
    puts(inner_file());
    return 0;
}
END
  printf '#include "inner/inner.h"\nstatic inline const char *x_file(void) { return __FILE__; }\n' >src/x.h
  echo 'static inline const char *inner_file(void) { return __FILE__; }' >src/inner/inner.h
  echo 'static inline const char *far_file(void) { return __FILE__; }' >inc/far.h
  echo 'static inline const char *near_file(void) { return __FILE__; }' >inc/near.h
  sed 's|MARK;|MARK; /* line */|; s|\.\./inc|inc|; s|"x.h"|"src/x.h"|' src/x.c |
    sed 's|MARK; /\* line \*/|MARK;|' >here.c
  echo 'static inline const char *near_file(void) { return __FILE__; }' >near.h
  cp src/x.c "a dir/#1 \$x.c"
  cp -r src/x.h src/inner "a dir/"
}

# The compiler's and the wrapper's dependency files after the same command.
expect_same_dependencies() { # FILES... -- ARGUMENTS...
  local files=()
  while [ "$1" != -- ]; do files+=("$1"); shift; done
  shift
  rm -f "${files[@]}"
  cc "$@" || fail "$case_name: cc $*"
  for f in "${files[@]}"; do mv "$f" "$f.cc" || fail "$case_name: cc $*: no $f"; done
  "$redcc_cc" "$@" || fail "$case_name: redcc-cc $*"
  for f in "${files[@]}"; do expect_same "$f.cc" "$f"; done
  grep -q '^redcc' "$RECORD" || fail "$case_name: not translated: $*"
}

begin "dependency files"
make_project
expect_same_dependencies obj/x.d -- -Iinc -MD -c src/x.c -o obj/x.o
expect_same_dependencies x.d -- -Iinc -MMD -MP -c src/x.c
expect_same_dependencies obj/y.d -- -Iinc -MMD -MF obj/y.d -MT 'a b' -c src/x.c -o obj/x.o
expect_same_dependencies obj/y.d -- -Iinc -MD -MFobj/y.d -MQ 'a$b' -c src/x.c -o obj/x.o
expect_same_dependencies y.d -- -Iinc -Wp,-MD,y.d -c src/x.c -o obj/x.o
expect_same_dependencies y.d -- -Iinc -Wp,-MMD,y.d -c src/x.c -o obj/x.o
expect_same_dependencies 'obj/z.d' -- -Iinc -MD -c "a dir/#1 \$x.c" -o obj/z.o
expect_same_dependencies here.d -- -I. -MD -c here.c
expect_same_dependencies prog.d -- -Iinc -MMD src/x.c -o prog
echo 'int f(void) { return 3; }' >f.c
expect_same_dependencies x.d f.d -- -Iinc -MMD -c src/x.c f.c
nm obj/x.o x.o obj/z.o here.o | grep -c redcc_run | grep -q 4 || fail "$case_name: not translated"
end

begin "CMake's and automake's way to ask for dependencies"
make_project
expect_same_dependencies obj/x.o.d -- -Iinc -MD -MT obj/x.o -MF obj/x.o.d -o obj/x.o -c src/x.c
expect_same_dependencies obj/x.Tpo -- -Iinc -MT x.o -MD -MP -MF obj/x.Tpo -c -o x.o src/x.c
end

begin "__FILE__ in source and headers"
make_project
for compiler in cc clang clang-19; do
  command -v "$compiler" >/dev/null || continue
  for arguments in "-Iinc src/x.c" "-I. -Iinc here.c" "-Isrc -Iinc src/x.c" "-I$PWD/src -Iinc ./src/x.c" \
    "-Iinc ./here.c" "-Iinc -iquote src src/inner/../x.c" "-Iinc $PWD/src/x.c"; do
    # the working folder has spaces in its name: words are parted by hand
    eval "words=(${arguments//$PWD/\"\$PWD\"})"
    $compiler "${words[@]}" -o p1 && ./p1 >expected || fail "$case_name: $compiler $arguments"
    REDCC_CC=$compiler "$redcc_cc" "${words[@]}" -o p2 && ./p2 >actual || fail "$case_name: $arguments"
    if [ "$compiler" != clang ]; then # which here has no OpenMP library of its own
      grep -qx translated actual || fail "$case_name: $compiler $arguments: not translated"
    fi
    grep -vx translated actual >actual2
    expect_same expected actual2
  done
done
end

begin "a header that is found otherwise from the temporary folder: compiled as it is"
make_project
# inc/near.h asks for "config.h", which lies in gen/; src/ has another, which only src/ may see
mkdir gen
echo '#define WHICH "generated"' >gen/config.h
echo '#define WHICH "beside the source"' >src/config.h
printf '#include "config.h"\nstatic inline const char *near_file(void) { return WHICH; }\n' >inc/near.h
cc -Iinc -Igen src/x.c -o p1 && ./p1 >expected
"$redcc_cc" -v -Iinc -Igen src/x.c -o p2 2>messages && ./p2 >actual
expect_same expected actual
expect_match messages "other headers"
end

begin "a header that several headers include"
make_project
printf '#ifndef X_H\n#define X_H\nstatic inline const char *x_file(void) { return __FILE__; }\n#endif\n' >src/x.h
printf '#include "../x.h"\nstatic inline const char *inner_file(void) { return __FILE__; }\n' >src/inner/inner.h
sed 's|"x.h"|"x.h"\n#include "inner/inner.h"|' src/x.c >src/twice.c
"$redcc_cc" -v -Iinc src/twice.c -o p 2>messages && ./p >actual
expect_no_match messages 'compiled as it is'
expect_match actual '^translated$'
printf '#include "x.h"\nstatic inline const char *inner_file(void) { return __FILE__; }\n' >src/inner.h
sed 's|"x.h"|"x.h"\n#include "inner.h"|' src/x.c >src/twice.c
"$redcc_cc" -v -Iinc src/twice.c -o p 2>messages && ./p >actual
expect_no_match messages 'compiled as it is'
expect_match actual '^translated$'
end

begin "debug information names the user's file and lines"
make_project
for compiler in cc clang-19; do
  command -v "$compiler" >/dev/null || continue
  REDCC_CC=$compiler "$redcc_cc" -g -Iinc -c src/x.c -o x.o || fail "$case_name"
  readelf --debug-dump=info --debug-dump=line --debug-dump=str --debug-dump=line-str x.o >dump 2>/dev/null
  expect_match dump 'src/x\.c'
  expect_no_match dump 'redcc-cc-[A-Za-z0-9]{6}/0/x\.c'
  nm -l x.o 2>/dev/null | grep ' main' | grep -q "src/x.c:6" || fail "$case_name: line of main ($compiler)"
  REDCC_CC=$compiler "$redcc_cc" -g -c -Iinc -I. here.c -o x.o || fail "$case_name"
  readelf --debug-dump=info --debug-dump=line --debug-dump=str --debug-dump=line-str x.o >dump 2>/dev/null
  expect_no_match dump '\./\./'
done
"$redcc_cc" -g -Iinc -ffile-prefix-map=src=there -c src/x.c -o x.o
readelf --debug-dump=info x.o 2>/dev/null >dump
expect_match dump 'there/x\.c'
end

begin "the same command twice gives the same object"
make_project
"$redcc_cc" -g -O2 -Iinc -c src/x.c -o 1.o && "$redcc_cc" -g -O2 -Iinc -c src/x.c -o 2.o
expect_same 1.o 2.o
end

begin "messages name the user's file and lines"
printf 'int f(int a) {\n    int unused;\n    return a;\n}\n#define MARK\nvoid g(void) {\n    MARK;\n}\n' >w.c
"$redcc_cc" -Wall -c w.c 2>messages || fail "$case_name"
expect_match messages '^w\.c:2:9: warning'
"$redcc_cc" -Wall -Werror -c w.c 2>messages && fail "$case_name: -Werror"
expect_match messages '^w\.c:2:9: error'
expect_equal "$case_name: shown once" 1 "$(grep -c 'w\.c:2:9' messages)"
end

begin "messages are those of the source, translated or not"
{ echo '#warning of the user'; cat w.c 2>/dev/null; printf '%s' "$source_text"; echo 'static int unused;'; } >w.c
for options in -c "-Wall -c" "-Wall -O2 -S" "-Wall -o p"; do
  for compiler in gcc clang-19; do
    command -v $compiler >/dev/null || continue
    # shellcheck disable=SC2086
    { $compiler $options w.c 2>expected; FAKE_WARN=1 "$redcc_cc" $compiler $options w.c 2>messages; } || fail "$case_name: $options"
    expect_same expected messages
  done
done
printf '%s' "$source_text" >w.c
FAKE_WARN=1 "$redcc_cc" -Werror w.c -o p 2>messages || fail "$case_name: -Werror"
expect_empty messages
expect_equal "$case_name: -Werror" "translated ran" "$(./p | paste -sd' ')"
end

begin "read-only source folder, nothing written beside the source"
make_project
chmod -R a-w src
before=$(find src | sort)
"$redcc_cc" -Iinc -c src/x.c -o x.o || fail "$case_name"
expect_equal "$case_name" "$before" "$(find src | sort)"
chmod -R u+w src
end

begin "names with spaces, UTF-8 and strange bytes"
make_project
for name in "a b.c" "é ü.c" "it's.c" 'q"q.c' 'a,b.c' '-minus.c' 'x.y.c' '$HOME.c' 'back\slash.c'; do
  cp here.c "./$name"
  "$redcc_cc" -Iinc -I. -c "./$name" 2>messages || fail "$case_name: $name: $(cat messages)"
  nm "./${name%.c}.o" 2>/dev/null | grep -q redcc_run || fail "$case_name: $name not translated"
done
sed 's/main(void) {/& puts(__BASE_FILE__);/' here.c >'a=b.c' # no prefix map can name it
"$redcc_cc" -Iinc -I. -v 'a=b.c' -o p 2>messages || fail "$case_name: a=b.c: $(cat messages)"
expect_match messages "holds a '='"
expect_equal "$case_name" 'a=b.c' "$(./p | grep = | sort -u)"
end

finish
