#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Killed half-way: no object, no temporary, and the status that the signal gives.
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM
cat >"$work/slow" <<'END'
#!/bin/bash
# A compiler that begins its output, says that it is at work, and removes the output when told to
# stop, as gcc does. Questions are answered by the real one.
case " $* " in *" -M "* | *" -print-file-name"*) exec cc "$@" ;; esac
trap 'rm -f half.o; kill $!; trap - TERM; kill -TERM $$' TERM
trap 'rm -f half.o; kill $!; trap - INT; kill -INT $$' INT
trap 'rm -f half.o; kill $!; trap - HUP; kill -HUP $$' HUP
sleep 60 &
echo half >half.o
touch "$RECORD.asleep"
wait
END
chmod +x "$work/slow"

# Starts the wrapper with default signal actions (a shell's background job ignores SIGINT).
start() { rm -f "$RECORD.asleep"; env --default-signal=INT,TERM,HUP "$@" & child=$!; }
wait_asleep() {
  local i
  for ((i = 0; i < 1000; i++)); do [ -e "$RECORD.asleep" ] && return; sleep 0.02; done
  fail "$case_name: nothing began"
}

for signal in TERM INT HUP; do
  begin "SIG$signal while compiling"
  printf '%s' "$source_text" >x.c
  start "$redcc_cc" "$work/slow" -c x.c
  wait_asleep
  kill -s $signal $child
  wait $child 2>/dev/null
  status=$?
  expect_equal "$case_name: status" $((128 + $(kill -l $signal))) $status
  expect_no_file half.o
  end

  begin "SIG$signal while translating"
  printf '%s' "$source_text" >x.c
  FAKE_SLEEP=60 start "$redcc_cc" -c x.c
  wait_asleep
  kill -s $signal $child
  wait $child 2>/dev/null
  status=$?
  expect_equal "$case_name: status" $((128 + $(kill -l $signal))) $status
  expect_no_file x.o
  end
done

begin "SIGTERM while several are compiled"
printf '%s' "$source_text" >x.c
cp x.c y.c
start "$redcc_cc" "$work/slow" -c x.c y.c
wait_asleep
kill -s TERM $child
wait $child 2>/dev/null
expect_equal "$case_name: status" 143 $?
expect_no_file half.o
end

begin "a compiler ended by a signal: the same signal, no second try"
printf '%s' "$source_text" >x.c
printf '#!/bin/bash\ncase " $* " in *" -M "* | *" -print-file-name"*) exec cc "$@" ;; esac\necho once >>"$RECORD.tries"\nkill -TERM $$\n' >dying
chmod +x dying
rm -f "$RECORD.tries"
"$redcc_cc" ./dying -c x.c 2>/dev/null
expect_equal "$case_name" 143 $?
expect_equal "$case_name" 1 "$(wc -l <"$RECORD.tries")"
rm -f "$RECORD.tries"
end

begin "the compiler's own exit status"
printf '%s' "$source_text" >x.c
printf '#!/bin/bash\nexit 42\n' >failing
chmod +x failing
"$redcc_cc" ./failing -c x.c
expect_equal "$case_name" 42 $?
REDCC_DISABLE=1 "$redcc_cc" ./failing -c x.c
expect_equal "$case_name" 42 $?
end

begin "nobody reads the messages"
{ echo '#warning one'; printf '%s' "$source_text"; } >x.c
"$redcc_cc" -v -c x.c 2> >(exec true)
end

begin "an ignored SIGHUP stays ignored"
printf '%s' "$source_text" >x.c
rm -f "$RECORD.asleep"
FAKE_SLEEP=1 env --ignore-signal=HUP "$redcc_cc" -c x.c 2>/dev/null &
child=$!
wait_asleep
kill -s HUP $child
wait $child
expect_equal "$case_name" 0 $?
expect_file x.o
end

finish
