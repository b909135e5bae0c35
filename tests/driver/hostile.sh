#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Builds in places that are against them: what comes out is what the compiler gives, or an error that
# says why; never a wrong object, half of one, or a source that was written over.
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM

begin "the output is one of the inputs"
printf '%s' "$source_text" >original.c
for compiler in gcc clang-19; do
  command -v $compiler >/dev/null || continue
  for arguments in "x.c -o x.c" "-c x.c -o x.c" "-S x.c -o ./x.c" "-c link.c -o x.c" "-c x.c -o link.c" "-x c x.c -ox.c"; do
    for program in cc redcc; do
      cp original.c x.c && ln -sf x.c link.c
      command=($compiler)
      [ $program = cc ] || command=("$redcc_cc" $compiler)
      # shellcheck disable=SC2086
      "${command[@]}" $arguments 2>$program.messages
      echo $? >$program.status
      cp x.c $program.x # clang does write over it
    done
    expect_same cc.status redcc.status
    expect_same cc.messages redcc.messages
    [ "$arguments" = "x.c -o x.c" ] || expect_same cc.x redcc.x # programs have build ids
    [ $compiler = clang-19 ] || expect_same original.c redcc.x
  done
done
expect_no_file "$RECORD"
end

begin "an output that cannot be written"
printf '%s' "$source_text" >x.c
mkdir folder
for output in /proc/nowhere/x.o missing/x.o folder; do
  cc -c x.c -o $output 2>expected
  status=$?
  "$redcc_cc" gcc -c x.c -o $output 2>messages
  expect_equal "$case_name: $output" $status $?
  [ -s messages ] || fail "$case_name: $output: no message"
  expect_no_file missing
done
"$redcc_cc" -S x.c -o /dev/full 2>messages && fail "$case_name: /dev/full"
[ -s messages ] || fail "$case_name: /dev/full: no message"
end

begin "a full disk: whatever is made works, whatever is not is missed"
printf '%s' "$source_text" >x.c
mkdir disk
in_small_disk() { # BYTES COMMAND...: with a file system of that size on disk/
  # shellcheck disable=SC2016
  unshare -m bash -c 'mount -t tmpfs -o size="$1" tmpfs disk && shift && "$@"' - "$@"
}
if in_small_disk 4096 true 2>/dev/null; then
  for size in 4096 16384 28672 65536; do
    for options in "" -pipe; do
      rm -f x.o p
      # shellcheck disable=SC2086
      TMPDIR="$PWD/disk" in_small_disk $size "$redcc_cc" gcc $options -O1 -c x.c -o x.o 2>messages
      status=$?
      [ $status = 0 ] || [ -s messages ] || fail "$case_name: $size $options: no message"
      [ $status = 0 ] || expect_no_file x.o
      [ "$options" = "" ] || expect_equal "$case_name: $size" 0 $status # without a temporary gcc works
      [ $status != 0 ] || { "$redcc_cc" x.o -o p && ./p | grep -qx ran; } || fail "$case_name: $size: wrong object"
      # shellcheck disable=SC2086
      TMPDIR="$PWD/disk" in_small_disk $size "$redcc_cc" gcc $options x.c -o p2 2>messages
      status=$?
      [ $status = 0 ] || [ -s messages ] || fail "$case_name: $size $options: link: no message"
      [ $status != 0 ] || ./p2 | grep -qx ran || fail "$case_name: $size: wrong program"
      # an error of the user's is still reported
      echo 'int f(void) { return undeclared; }' >e.c
      TMPDIR="$PWD/disk" in_small_disk $size "$redcc_cc" gcc -pipe e.c -o p3 2>messages &&
        fail "$case_name: an error was missed"
      expect_match messages 'undeclared|No space'
      # the output's disk is full
      in_small_disk $size bash -c '"$1" -c x.c -o disk/x.o 2>messages; status=$?; [ $status != 0 ] && [ -e disk/x.o ] && exit 9; exit $status' - "$redcc_cc"
      [ $? != 9 ] || fail "$case_name: half an object"
    done
  done
else
  echo "no right to mount a small file system: the full disk is left out"
fi
end

begin "the compiler crashes"
printf '%s' "$source_text" >x.c
cat >fragile <<'END2'
#!/bin/bash
# crashes over translated texts only
case "$*" in *-M\ * | *-print-file-name*) ;; *"/0/x.c "*) kill -SEGV $$ ;; esac
exec cc "$@"
END2
cat >crashing <<'END2'
#!/bin/bash
case "$*" in *-M\ * | *-print-file-name*) exec cc "$@" ;; esac
echo half >x.o
kill -SEGV $$
END2
chmod +x fragile crashing
"$redcc_cc" ./fragile -c x.c 2>messages || fail "$case_name"
expect_match messages 'does not compile.*report'
cc x.o -o p && expect_equal "$case_name" ran "$(./p)"
("$redcc_cc" ./crashing -c x.c) 2>messages
expect_equal "$case_name: status" 139 $?
end

begin "killed: what is left behind is removed by a later call"
printf '%s' "$source_text" >x.c
FAKE_SLEEP=60 "$redcc_cc" -c x.c &
child=$!
for ((i = 0; i < 1000; i++)); do [ -e "$RECORD.asleep" ] && break; sleep 0.02; done
rm -f "$RECORD.asleep"
folder=$(echo "$TMPDIR"/redcc-cc-*)
expect_file "$folder"
touch -d '-1 hour' "$folder"
"$redcc_cc" -c x.c -o other.o
expect_file "$folder" # its owner lives
sleeper=$(pgrep -P $child)
kill -KILL $child
wait $child 2>/dev/null
expect_no_file x.o
[ -z "$sleeper" ] || kill "$sleeper"
expect_file "$folder"
mkdir "$TMPDIR/redcc-cc-notes" "$TMPDIR/redcc-cc-mine-22"
touch -d '-1 hour' "$folder" "$TMPDIR/redcc-cc-mine-22"
ln -s "$work/case" "$TMPDIR/redcc-cc-linked" # of another length; and one of this:
ln -s "$work/case" "$TMPDIR/redcc-cc-linkto"
"$redcc_cc" -c x.c -o other.o
expect_no_file "$folder"
expect_file "$TMPDIR/redcc-cc-notes" # too young
expect_file "$TMPDIR/redcc-cc-mine-22"
expect_file x.c
rm -r "$TMPDIR"/redcc-cc-*
end

begin "nobody reads the output"
printf '%s' "$source_text" >x.c
"$redcc_cc" -S x.c -o - | true
"$redcc_cc" -c x.c 2>&1 | true
{ "$redcc_cc" -v -c x.c -o y.o; } >&- 2>&- || fail "$case_name: closed streams"
expect_file y.o
"$redcc_cc" -c x.c -o z.o <&- || fail "$case_name: closed input"
end

begin "a real ccache in front, and behind"
printf '%s' "$source_text" >x.c
if command -v ccache >/dev/null; then
  export CCACHE_DIR="$PWD/cache"
  for _ in 1 2; do
    ccache "$redcc_cc" -c x.c -o front.o && "$redcc_cc" front.o -o front || fail "$case_name: in front"
    ./front | grep -qx ran || fail "$case_name: in front"
    "$redcc_cc" ccache gcc -c x.c -o behind.o && "$redcc_cc" behind.o -o behind || fail "$case_name: behind"
    expect_equal "$case_name: behind" "translated ran" "$(./behind | paste -sd' ')"
    REDCC_CC="ccache gcc" "$redcc_cc" -c x.c -o behind2.o && "$redcc_cc" behind2.o -o behind2 || fail "$case_name"
    expect_equal "$case_name: REDCC_CC" "translated ran" "$(./behind2 | paste -sd' ')"
  done
  unset CCACHE_DIR
fi
REDCC_CC="distcc-that-is-not-there gcc" "$redcc_cc" -c x.c -o d.o 2>messages
expect_equal "$case_name: no distcc" 127 $?
expect_match messages "distcc-that-is-not-there"
end

finish
