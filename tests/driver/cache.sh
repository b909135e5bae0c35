#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The cache of translations: it is used when nothing has changed, and never when anything has.
# The loop of x.c is irregular where a header defines PARALLEL: its verdict shows which header the translation
# was made of.
. "$(dirname "$0")/library.sh"
redcc_cc=$REDCC_CC_PROGRAM
export REDCC_CACHE="$work/cache" XDG_CACHE_HOME="$work/xdg"

source='#include "h.h"
void count(int n, const int *restrict key, int *restrict h) {
#ifdef PARALLEL
    for (int t = 0; t < n; t++)
        h[key[t]]++;
#else
    for (int t = 0; t < n; t++)
        h[t] = key[t] + 1;
#endif
}
'
yes='#define PARALLEL 1'
no='  #define SERIAL 1' # as long as the other

fresh() { # CASE: a folder with a source of its own, and the header
  begin "$1"
  printf '%s/* %s */\n' "$source" "$1" >x.c
  echo "$yes" >h.h
}
# says ARGUMENTS...: "hit" or "miss", "parallel" or "serial", of translating x.c.
says() {
  local kept=miss form=serial
  rm -f verdicts
  REDCC_BUILD_REPORT=$PWD/verdicts "$redcc_cc" --redcc-report -v -O1 -c "$@" x.c 2>notes || fail "$case_name: $*"
  grep -q 'redcc-cc: note: .*from the cache' notes && kept=hit
  grep -q '"transformed"' verdicts && form=parallel
  echo "$kept $form"
}
expect() { # WHAT EXPECTED [ARGUMENTS...]
  local what=$1 expected=$2 got
  shift 2
  got=$(says "$@")
  expect_equal "$case_name, $what" "$expected" "$got"
}

mkdir "$work/tmp" && export TMPDIR="$work/tmp" && cd "$work"

# Used at the end: what is known of a project's files is stored once they are some seconds old.
mkdir "$work/project"
printf 'int where(int i);\nvoid count(int n, const int *restrict key, int *restrict h) {\n    for (int t = 0; t < n; t++)\n        h[where(key[t])]++;\n}\n' >"$work/project/x.c"
printf 'int where(int i) { return i + 1; }\n' >"$work/project/where.c"
touch "$work/project/Makefile"

fresh "the same again"
export REDCC_OPTS=--report=text
for time in first second; do
  "$redcc_cc" -O1 -c x.c -o "$time.o" 2>"$time.remarks" || fail "$case_name"
  REDCC_OPTS='' REDCC_BUILD_REPORT=$PWD/report "$redcc_cc" -O1 -c x.c -o "$time.o" || fail "$case_name"
done
expect_same first.o second.o
expect_same first.remarks second.remarks
expect_match second.remarks "remark: loop in 'count' runs in parallel"
for cache in "$REDCC_CACHE" "$REDCC_CACHE" off; do
  REDCC_OPTS='' REDCC_CACHE=$cache "$redcc_cc" -Rredcc -O1 -c x.c -o third.o 2>third.remarks || fail "$case_name"
  expect_same first.remarks third.remarks
done
expect_equal "$case_name: reports" 1 "$(sort -u report | wc -l)"
expect_equal "$case_name: reports" 2 "$(wc -l <report)"
unset REDCC_OPTS
expect "again" "hit parallel"
touch x.c h.h
expect "times alone" "hit parallel"
end

fresh "a new folder"
rm -rf "$work/cache"
expect first "miss parallel"
expect second "hit parallel"
end

fresh "what changes without a trace in times and sizes"
expect first "miss parallel"
cp -p h.h old && echo "$no" >h.h && touch -r old h.h
expect "the header" "miss serial"
expect "the header" "hit serial"
cp -p old h.h
expect "back" "hit parallel"
cp -p x.c old && sed -i 's/PARALLEL/PARALLEK/' x.c && touch -r old x.c
expect "the source" "miss serial"
end

fresh "headers that appear, vanish and move"
mkdir one two
mv h.h two/
expect first "miss parallel" -Ione -Itwo
expect second "hit parallel" -Ione -Itwo
echo "$no" >one/h.h
expect "one that comes before" "miss serial" -Ione -Itwo
expect "another order" "miss parallel" -Itwo -Ione
rm one/h.h
expect "it is gone" "hit parallel" -Ione -Itwo
echo "$no" >h.h
expect "beside the source" "miss serial" -Ione -Itwo
rm h.h && rmdir one
expect "no folder" "miss parallel" -Ione -Itwo
mkdir one && echo "$no" >one/h.h
expect "the folder comes" "hit serial" -Ione -Itwo
CPATH=$PWD/one expect "CPATH" "miss parallel" -Itwo
rm one/h.h && mv two/h.h one/h.h && ln -s ../one/h.h two/h.h
expect "a link" "miss parallel" -Itwo
echo "$no" >other && rm two/h.h && ln -s ../other two/h.h
expect "the link leads elsewhere" "miss serial" -Itwo
end

fresh "two names of one file, or two files"
mkdir a b
printf '#pragma once\n#include "../%s/p.h"\n#ifdef SEEN\n#define PARALLEL 1\n#endif\n#define SEEN 1\n' b >a/p.h
ln -s ../a/p.h b/p.h
echo '#include "a/p.h"' >h.h
expect "one file" "miss serial"
expect "one file" "hit serial"
rm b/p.h && cp a/p.h b/p.h && touch -d yesterday b/p.h # gcc takes files of one content and time for one
expect "a copy" "miss parallel"
end

fresh "what is asked for and not included"
printf '#if __has_include("extra.h")\n#define PARALLEL 1\n#endif\n' >h.h
expect first "miss serial"
expect second "hit serial"
touch extra.h
expect "it is there" "miss parallel"
printf '#define WHICH "which.h"\n#include WHICH\n' >h.h
echo "$yes" >which.h
expect "by a macro" "miss parallel"
echo "$no" >which.h
expect "by a macro" "miss serial"
printf '#ifdef WHICH\n#include WHICH\n#endif\n' >h.h
expect "by a macro that is not there" "miss serial"
expect "by a macro that is not there" "hit serial"
echo "$yes" >which.h
expect "by a macro of the command" "miss parallel" '-DWHICH="which.h"'
echo "$no" >which.h
expect "by a macro of the command" "miss serial" '-DWHICH="which.h"'
printf '#inc\\\nlude "which.h"\n' >h.h
expect "in two lines" "miss serial"
expect "in two lines" "hit serial"
echo "$yes" >which.h
expect "in two lines" "miss parallel"
printf '/* a */ %%: /* b */ include /* c */ "which.h"\r\n' >h.h
expect "by a digraph" "miss parallel"
echo "$no" >which.h
expect "by a digraph" "miss serial"
echo "#define NOW __TIME__" >h.h
expect "the time" "miss serial"
expect "the time" "miss serial"
end

fresh "options, variables, folders"
echo "$no" >h.h
expect first "miss serial"
expect "a macro" "miss parallel" -DPARALLEL
echo "$yes" >first.h
expect "-include" "miss parallel" -include first.h
expect "-include" "hit parallel" -include first.h
echo "$no" >first.h
expect "-include" "miss serial" -include first.h
SOURCE_DATE_EPOCH=1 expect "SOURCE_DATE_EPOCH" "miss serial"
REDCC_OPTS=--order=any expect "REDCC_OPTS" "miss serial"
REDCC_OPTS=--order=any expect "REDCC_OPTS" "hit serial"
REDCC_OPTS="--inputs-file=$PWD/list" expect "an option that writes" "miss serial"
REDCC_OPTS="--inputs-file=$PWD/list" expect "an option that writes" "miss serial"
mkdir other && cp x.c h.h other/ && cd other || exit 1
expect "another folder, the same" "hit serial"
echo "$yes" >h.h
expect "another folder" "miss parallel"
cd .. || exit 1
expect "back" "hit serial"
end

fresh "the compiler's own macros"
make_compiler() { # FLAG
  printf '#include <unistd.h>\nint main(int n, char **a) { char *b[999]; int k = 1; b[0] = "cc"; b[k++] = "%s";
    for (int i = 1; i < n; i++) b[k++] = a[i];
    b[k] = 0; return execvp("cc", b); }\n' "$1" | cc -x c - -o mycc || fail "$case_name"
}
printf '#define PARALLEL 1\n#if defined(__SSP__)\n#undef PARALLEL\n#endif\n' >h.h
export REDCC_CC="$PWD/mycc"
make_compiler -O1
expect "first" "miss parallel"
expect "second" "hit parallel"
make_compiler -fstack-protector
expect "another program of the same name" "miss serial"
printf '#!/bin/sh\nexec cc "$@"\n' >mycc
expect "a script, which is anybody's guess" "miss parallel"
expect "a script" "miss parallel"
unset REDCC_CC
end

fresh "standard input, and what cannot be parsed"
for time in 1 2; do "$redcc_cc" -v -O1 -x c -c - -o "$time.o" <x.c 2>notes || fail "$case_name"; done
expect_match notes 'stdin: translated before'
expect_same 1.o 2.o
echo 'int f(void) { return ; ' >x.c
for time in 1 2; do
  "$redcc_cc" -v -c x.c 2>notes && fail "$case_name"
  grep 'compiled as it is' notes >"$time.why"
done
expect_match notes 'translated before'
expect_same 1.why 2.why
end

fresh "damage"
expect first "miss parallel"
cp -r "$work/cache" "$work/good"
spoil() { # WHAT COMMAND...: each entry by the command; then the object is right, and so are the entries
  local what=$1 entry
  shift
  rm -rf "$work/cache" && cp -r "$work/good" "$work/cache"
  find "$work/cache" -type f | while read -r entry; do "$@" "$entry"; done
    expect "$what" "miss parallel"
  expect "$what, mended" "hit parallel"
}
spoil "cut short" truncate -s -1
spoil "changed" sh -c 'printf X | dd of="$0" bs=1 seek=$(($(stat -c %s "$0") - 1)) conv=notrunc status=none'
find "$work/cache" -type f | while read -r entry; do rm "$entry" && mkdir "$entry"; done
expect "folders" "miss parallel"
rm -rf "$work/good"
end

fresh "no folder, no room"
touch "$work/plain"
for folder in "$work/plain" /proc/none off relative; do
  REDCC_CACHE=$folder expect "$folder" "miss parallel"
done
expect_no_file relative
expect_match notes 'REDCC_CACHE takes the absolute path of a folder, or off'
rm -rf "$work/cache" && mkdir "$work/cache" && chmod 777 "$work/cache"
expect "everybody may write it" "miss parallel"
[ -z "$(ls -A "$work/cache")" ] || fail "$case_name: a folder that others may write was used"
REDCC_CACHE='' expect "the usual place" "miss parallel"
expect_file "$work/xdg/redcc"
REDCC_CACHE_SIZE=many REDCC_CACHE='' expect "a wrong size" "hit parallel"
expect_match notes "REDCC_CACHE_SIZE takes a number of bytes, with K, M or G, not 'many'"
end

fresh "the limit"
rm -rf "$work/cache" && expect "before it" "miss parallel"
# what was used lately is kept, what was not goes, and what a killed writer has left
mkdir -p "$work/cache/0"
head -c 100000 /dev/zero >"$work/cache/0/old" && head -c 3000 /dev/zero >"$work/cache/0/.new-left"
touch -d '3 hours ago' "$work/cache/0/old" "$work/cache/0/.new-left"
for share in 1 2 3 4 5 6 7 8 9 a b c d e f; do mkdir -p "$work/cache/$share" && cp -p "$work"/cache/0/{old,.new-left} "$work/cache/$share/"; done
for number in 1 2 3; do
  echo "int v$number;" >"$number.c"
  REDCC_CACHE_SIZE=1M "$redcc_cc" -c $number.c || fail "$case_name"
done
left=$(find "$work/cache" -name old | wc -l)
[ "$left" -ge 10 ] && [ "$left" -le 15 ] || fail "$case_name: $left of 16 old entries, 3 shares were written"
expect_equal "$case_name: parts" "$left" "$(find "$work/cache" -name .new-left | wc -l)"
rm -f "$work"/cache/*/.new-left
REDCC_CACHE_SIZE=1M expect "after it" "hit parallel"
end

fresh "many at once"
for number in 1 2 3 4; do mkdir $number && cp x.c h.h $number/; done
echo "$no" >2/h.h
for round in 1 2; do
  seq 4 | xargs -P 4 -I N sh -c 'cd N && "$0" -O1 -c x.c -o x.o' "$redcc_cc" || fail "$case_name"
  for number in 1 2 3 4; do
    form=$(nm $number/x.o | grep -q redcc_ && echo yes || echo no)
    expect_equal "$case_name $round.$number" "$(case $number in 2) echo no ;; *) echo yes ;; esac)" "$form"
  done
done
[ -z "$(find "$work/cache" -name '.new-*')" ] || fail "$case_name: parts of entries are left"
end

fresh "the messages of a source with parallel loops"
printf '#include <stdio.h>\n#include <string.h>\n#include <unistd.h>\nint main(int n, char **a) { a[0] = "cc";
    for (int i = 1; i < n; i++) if (strstr(a[i], "/messages.o")) fputs("compiled\\n", fopen("messages", "a"));
    return execvp("cc", a); }\n' | sed 's/return execvp/fflush(NULL); return execvp/' | cc -x c - -o mycc || fail "$case_name"
export REDCC_CC="$PWD/mycc"
sed -i 's/for (int t/int unused; &/' x.c
for time in 1 2; do "$redcc_cc" -Wall -O1 -c x.c -o $time.o 2>$time.messages || fail "$case_name"; done
expect_equal "$case_name: runs for them alone" 1 "$(wc -l <messages)"
expect_match 2.messages 'warning: unused variable'
expect_same 1.messages 2.messages
expect_same 1.o 2.o
"$redcc_cc" -O1 -c x.c 2>3.messages || fail "$case_name"
expect_empty 3.messages
cc -Wall -O1 -c x.c 2>expected
expect_same expected 2.messages
unset REDCC_CC
end

make_counting_compiler() {
  printf '#include <stdio.h>\n#include <string.h>\n#include <unistd.h>\nint main(int n, char **a) { FILE *f = fopen("compiled", "a"); a[0] = "cc"; a[n] = 0;
    for (int i = 1; i < n; i++) if (strcmp(a[i], "-c") == 0) fputs("run\\n", f);
    fclose(f); return execvp("cc", a); }\n' | cc -x c - -o mycc || fail "$case_name"
  export REDCC_CC="$PWD/mycc"
}
fresh "the object of a source with parallel loops"
make_counting_compiler
compile() { # WHAT RUNS [ARGUMENTS...]: the compilations it takes; without the cache the object is the same
  local what=$1 runs=$2
  shift 2
  rm -f compiled
  "$redcc_cc" -O1 "$@" -c x.c -o x.o 2>messages || fail "$case_name, $what: $(cat messages)"
  expect_equal "$case_name, $what: compilations" "$runs" "$(cat compiled 2>/dev/null | wc -l)"
  mv x.o kept.o
  REDCC_CACHE=off "$redcc_cc" -O1 "$@" -c x.c -o x.o 2>expected || fail "$case_name, $what"
  expect_same x.o kept.o
  expect_same expected messages
  nm kept.o | grep -q redcc_run || fail "$case_name, $what: not translated"
}
compile first 1
compile second 0
sed -i 's/PARALLEL 1/PARALLEL 2/' h.h
compile "another header" 1
compile "another header, again" 0
compile "-g" 1 -g
compile "-g, again" 0 -g
mkdir other && cp x.c h.h mycc other/ && cd other || exit 1
compile "in another folder" 0
compile "-g in another folder" 1 -g
cd .. || exit 1
# other names of the object keep their bytes
"$redcc_cc" -O1 -c x.c -o x.o && cp x.o before && "$redcc_cc" -O2 -c x.c -o x.o && cp x.o second && ln x.o other.o &&
  "$redcc_cc" -O1 -c x.c -o x.o || fail "$case_name"
expect_same second other.o
expect_same before x.o
"$redcc_cc" -O2 -c x.c && cmp -s x.o before && fail "$case_name: the object of -O1"
"$redcc_cc" -O1 -c x.c
expect_same before x.o
# a command that may read or write more, or whose object depends on the machine
for option in -march=native -Wa,-adhl=list -save-temps; do
  compile "$option" 1 "$option"
  compile "$option, again" 1 "$option"
done
expect_file list
mkdir bin && cp "$(command -v as)" bin/ && echo >>bin/as
(export PATH="$PWD/bin:$PATH" && compile "another assembler" 1 && compile "another assembler, again" 0)
printf 'one' >bytes
echo '__asm__(".section .rodata\n.incbin \"bytes\"\n.text");' >>x.c
compile "a file that the assembler reads" 1
printf 'two' >bytes
compile "a file that the assembler reads, changed" 1
end

fresh "the dependency file of a source with parallel loops"
make_counting_compiler
for time in 1 2; do "$redcc_cc" -O1 -MD -MP -MF $time.d -MT x.o -c x.c -o x.o || fail "$case_name"; done
expect_same 1.d 2.d
cc -O1 -MD -MP -MF expected.d -MT x.o -c x.c -o x.o
for time in 1 2; do
  rm -f compiled
  "$redcc_cc" -O1 -MD -MP -MF x.d -MT x.o -c x.c -o x.o || fail "$case_name"
  expect_same expected.d x.d
done
expect_no_file compiled
unset REDCC_CC
end

# A file that has lain for some seconds is known by its times, and a folder by its own; the cases above change
# files before that.
begin "what has settled is not read again, and every change is seen"
settled() { # folder one comes first and has no h.h; two has it; three/ is not there
  rm -rf ./* && mkdir one two && echo "$yes" >two/h.h && printf '%s/* %s */\n' "$source" "settled $1" >x.c
  if [ "$1" = deep ]; then sed -i 's|"h.h"|"deep/h.h"|' x.c && mkdir two/deep && mv two/h.h two/deep/; fi
  if [ "$1" = dangling ]; then ln -s ../elsewhere one/h.h; fi
}
changed() { # NAME EXPECTED COMMAND...: what the change does to a translation that is known
  local name=$1 expected=$2
  cd "$work/settled $name" || exit 1
  shift 2
  expect "$name, again" "hit parallel" -Ione -Itwo -Ithree
  "$@" || fail "$case_name: $name"
  expect "$name" "$expected" -Ione -Itwo -Ithree
  expect "$name, again" "hit ${expected#* }" -Ione -Itwo -Ithree
}
names="nothing contents earlier deep dangling folder precompiled source"
for name in $names; do mkdir "$work/settled $name" && cd "$work/settled $name" && settled $name; done
sleep 4
for name in $names; do cd "$work/settled $name" && expect "$name, first" "miss parallel" -Ione -Itwo -Ithree; done
changed nothing "hit parallel" true
if command -v strace >/dev/null && strace -o traced true 2>/dev/null; then
  REDCC_BUILD_REPORT=$PWD/verdicts strace -o traced "$redcc_cc" --redcc-report -v -O1 -c -Ione -Itwo -Ithree x.c 2>notes
  expect_no_match traced 'open.*two/h\.h'
fi
with_old_times() { cp -p two/h.h old && echo "$no" >two/h.h && touch -r old two/h.h; }
changed contents "miss serial" with_old_times
changed earlier "miss serial" sh -c 'echo "$0" >one/h.h' "$no"
changed deep "miss serial" sh -c 'mkdir one/deep && echo "$0" >one/deep/h.h' "$no"
changed dangling "miss serial" sh -c 'echo "$0" >elsewhere' "$no"
changed folder "miss parallel" mkdir three
changed source "miss serial" sed -i 's/PARALLEL/PARALLEK/' x.c
cd "$work/settled precompiled" && touch two/h.h.gch
expect "a precompiled header" "miss serial" -Ione -Itwo -Ithree
expect "a precompiled header, again" "miss serial" -Ione -Itwo -Ithree
cd "$work/case" || exit 1
end

begin "a function of another file"
cd "$work/project" || exit 1
expect first "miss parallel"
expect second "hit parallel"
cp -p where.c old && sed -i 's/i + 1; /i * 3; /' where.c && touch -r old where.c
expect "it does something else" "miss parallel"
cp -p where.c older && sed -i 's/i \* 3; /puts(""); /; s/^/int puts(const char *);/' where.c
expect "it prints" "miss serial"
cp -p old where.c
expect "as it was" "hit parallel"
cd "$work/case" || exit 1
end

finish
