#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The variables REDCC_CC, REDCC_OPTS, REDCC_DISABLE, REDCC_KEEP, REDCC_BUILD_REPORT, REDCC_STRICT, REDCC_ROOT.
. "$(dirname "$0")/library.sh"
make_root "$work/root"
export REDCC_ROOT="$work/root"
redcc_cc=$REDCC_CC_PROGRAM

begin "REDCC_CC"
printf '%s' "$source_text" >x.c
REDCC_CC="$FAKES/compiler" "$redcc_cc" -c x.c || fail "$case_name"
expect_match "$RECORD" '^cc .*-c .*/0/x\.c'
REDCC_CC="$FAKES/compiler -DFROM_CC" "$redcc_cc" -c x.c || fail "$case_name"
expect_match "$RECORD" '^cc -DFROM_CC .*-c .*/0/x\.c'
mkdir 'my tools' && cp "$FAKES/compiler" 'my tools/cc' && rm "$RECORD"
REDCC_CC='my tools/cc' "$redcc_cc" -c x.c || fail "$case_name"
expect_match "$RECORD" '^cc '
REDCC_CC=/no/such/compiler "$redcc_cc" -c x.c 2>messages
expect_equal "$case_name" 127 $?
expect_match messages '/no/such/compiler'
end

begin "c99 means its standard"
echo 'int f(void) { return 3; }' >x.c
"$redcc_cc" c99 -c x.c && expect_match "$RECORD" '-- -std=c99$'
end

begin "REDCC_OPTS"
printf '%s' "$source_text" >x.c
REDCC_OPTS="--order=fixed  --pure='a b,c'" "$redcc_cc" --redcc-show -c x.c >shown || fail "$case_name"
expect_match shown "redcc' x.c -o [^ ]* --files=project --order=fixed '--pure=a b,c' --"
expect_match shown 'ffp-contract=off'
REDCC_OPTS="--order=any" "$redcc_cc" --redcc-show -c x.c >shown || fail "$case_name"
expect_no_match shown 'ffp-contract'
REDCC_OPTS="--order serial" "$redcc_cc" --redcc-show -c x.c >shown || fail "$case_name"
expect_match shown 'ffp-contract=off'
REDCC_OPTS="--report=text" "$redcc_cc" -c x.c 2>messages || fail "$case_name"
expect_match messages '^x\.c:4:5: remark: fake remark'
REDCC_OPTS="--order=fixed" "$redcc_cc" -Rredcc -c x.c 2>messages || fail "$case_name: -Rredcc"
expect_match messages '^x\.c:4:5: remark: fake remark'
"$redcc_cc" --redcc-show -Rredcc -c x.c >shown || fail "$case_name"
expect_no_match shown 'Rredcc'
expect_match shown "redcc' x.c .*--report=text"
REDCC_DISABLE=1 "$redcc_cc" -Rredcc x.c -o p || fail "$case_name: -Rredcc reached the compiler"
"$redcc_cc" -Rredcc -ftrapv -c x.c 2>messages || fail "$case_name: -Rredcc reached the compiler"
expect_match messages '^redcc-cc: note: x\.c: compiled as it is: .*-ftrapv'
"$redcc_cc" -Rredcc-missed -c x.c 2>messages
expect_equal "$case_name" 2 $?
expect_match messages "unknown option '-Rredcc-missed'; -Rredcc prints all remarks"
REDCC_OPTS="--bad" "$redcc_cc" -c x.c 2>messages || fail "$case_name"
expect_match messages "warning: x\.c: compiled as it is: redcc failed: .*'--bad'"
end

begin "REDCC_DISABLE"
printf '%s' "$source_text" >x.c
REDCC_DISABLE=1 "$redcc_cc" x.c -o p || fail "$case_name"
expect_equal "$case_name" ran "$(./p)"
expect_no_file "$RECORD"
for off in 0 ''; do
  REDCC_DISABLE=$off "$redcc_cc" x.c -o p || fail "$case_name"
  expect_equal "$case_name=$off" "translated ran" "$(./p | paste -sd' ')"
done
end

begin "REDCC_KEEP"
mkdir -p project/src other
printf '%s' "$source_text" >project/src/x.c
cp project/src/x.c other/x.c
echo 'int f(void) { return 3; }' >project/src/plain.c
cd project || exit 1
export REDCC_KEEP="$PWD/../kept here"
"$redcc_cc" -c src/x.c src/plain.c && "$redcc_cc" -c ../other/x.c && "$redcc_cc" -c "$work/case/other/x.c"
"$redcc_cc" -x c -c - -o i.o <src/x.c
cd ..
for kept in src/x.c up/other/x.c "${work#/}/case/other/x.c" stdin.c; do
  expect_match "kept here/$kept" redcc_run
done
expect_no_file "kept here/src/plain.c"
expect_no_file "kept here/src/x.c.messages"
(cd project && FAKE_BREAK=1 "$redcc_cc" -c src/x.c 2>/dev/null)
expect_match "kept here/src/x.c.messages" 'this is no C|error'
REDCC_KEEP=/proc/nowhere "$redcc_cc" -c other/x.c 2>messages || fail "$case_name"
expect_match messages "warning: cannot keep"
unset REDCC_KEEP
end

begin "REDCC_BUILD_REPORT"
printf '%s' "$source_text" >x.c
echo 'int f(void) { return 3; }' >'f f.c'
export REDCC_BUILD_REPORT="$PWD/a report" REDCC_REPORT="$PWD/of the run"
"$redcc_cc" -c x.c 'f f.c' || fail "$case_name"
for name in x.c 'f f.c'; do printf '{"directory":"%s","redcc":"fake","file":"%s","loops":[]}\n' "$PWD" "$name"; done >expected
sort expected >sorted && sort "$REDCC_BUILD_REPORT" | expect_same sorted /dev/stdin
rm "$REDCC_BUILD_REPORT"
FAKE_STATUS=1 "$redcc_cc" -c x.c
FAKE_STATUS=7 "$redcc_cc" -c x.c 2>/dev/null
FAKE_BREAK=1 "$redcc_cc" -c x.c 2>/dev/null
"$redcc_cc" -c -ftrapv x.c 'f f.c'
jq -r '"\(.file): \(.loops | length): \(.left_alone)"' "$REDCC_BUILD_REPORT" >actual
cat >expected <<'END'
x.c: 0: redcc: x.c:1:1: error: fake trouble
x.c: 0: redcc failed: x.c:1:1: error: fake trouble
x.c: 0: its translated text does not compile
x.c: 0: an option that redcc cannot follow: -ftrapv
f f.c: 0: an option that redcc cannot follow: -ftrapv
END
expect_same expected actual
rm "$REDCC_BUILD_REPORT"
expect_no_file "$REDCC_REPORT"
for i in $(seq 16); do "$redcc_cc" -c x.c -o "$i.o" & done
wait
expect_equal "$case_name: lines" 16 "$(grep -cx '{"directory":"[^"]*","redcc":"fake","file":"x.c","loops":\[\]}' "$REDCC_BUILD_REPORT")"
expect_equal "$case_name: lines" 16 "$(wc -l <"$REDCC_BUILD_REPORT")"
REDCC_BUILD_REPORT=/proc/nowhere/report "$redcc_cc" -c x.c 2>messages || fail "$case_name"
expect_match messages "warning: cannot append"
unset REDCC_BUILD_REPORT
"$redcc_cc" -c x.c 2>messages || fail "$case_name: by the run's name"
expect_match messages "note: the build's report goes to '.*of the run'.*REDCC_BUILD_REPORT=FILE"
expect_file "$REDCC_REPORT"
unset REDCC_REPORT
end

begin "REDCC_STRICT"
printf '%s' "$source_text" >x.c
export REDCC_STRICT=1
"$redcc_cc" x.c -o p 2>messages || fail "$case_name: a build in which all goes well"
expect_empty messages
for trouble in "FAKE_STATUS=1" "FAKE_STATUS=2" "FAKE_BREAK=1" "REDCC_OPTS=--bad"; do
  env "$trouble" "$redcc_cc" -c x.c -o "no.o" 2>messages && fail "$case_name: $trouble"
  expect_match messages "error: x.c: not translated \(REDCC_STRICT\): "
  expect_no_file no.o
done
"$redcc_cc" -ftrapv -c x.c -o no.o 2>messages && fail "$case_name: -ftrapv"
expect_match messages "error: x.c: not translated .*an option that redcc cannot follow"
expect_no_file no.o
REDCC_STRICT=0 FAKE_STATUS=1 "$redcc_cc" -c x.c 2>messages || fail "$case_name: REDCC_STRICT=0"
unset REDCC_STRICT
end

begin "--redcc-summary"
cat >report <<'END'
{"redcc":"1","file":"a.c","loops":[{"verdict":"transformed","reason":null},{"verdict":"refused","reason":{"id":"R104","slug":"update-value-used"}}]}
{"redcc":"1","file":"b.c","loops":[{"verdict":"refused","reason":{"id":"R104","slug":"update-value-used"}},{"verdict":"refused","reason":{"id":"R001","slug":"first"}}]}
{"redcc":"1","file":"c.c","loops":[],"left_alone":"it has \"verdict\":\"transformed\" in it"}
END
"$redcc_cc" --redcc-summary report >actual || fail "$case_name"
cat >expected <<'END'
redcc-cc: files: 3, 1 with a loop made parallel, 1 left alone; irregular reductions: 1 parallel, 3 refused
  refused: R104 update-value-used: 2
  refused: R001 first: 1
  left alone: it has "verdict":"transformed" in it: 1
END
expect_same expected actual
echo 'no report' >>report
"$redcc_cc" --redcc-summary report >actual 2>messages && fail "$case_name: a wrong line"
expect_match messages "error: report:4: expected a JSON object"
expect_empty actual
"$redcc_cc" --redcc-summary nowhere 2>messages && fail "$case_name: no file"
expect_match messages "cannot read 'nowhere'"
"$redcc_cc" --redcc-summary 2>messages; expect_equal "$case_name" 2 $?
end

begin "companions are found from the program's own place"
printf '%s' "$source_text" >x.c
unset REDCC_ROOT
make_root "$work/my prefix"
cp "$redcc_cc" "$work/my prefix/bin/redcc-cc"
mkdir links && ln -s "$work/my prefix/bin/redcc-cc" links/redcc-cc
for program in "$work/my prefix/bin/redcc-cc" links/redcc-cc; do
  "$program" x.c -o p || fail "$case_name"
  expect_equal "$case_name" "translated ran" "$(./p | paste -sd' ')"
done
(PATH="$work/my prefix/bin:$PATH" && redcc-cc x.c -o p) || fail "$case_name"
expect_equal "$case_name" "translated ran" "$(./p | paste -sd' ')"
rm "$work/my prefix/lib/libredcc_rt.a"
(cd "$work/my prefix/lib" && printf '#include <stdio.h>\nvoid redcc_run(void) { puts("translated"); }\n' |
  cc -shared -fPIC -x c - -o libredcc_rt.so)
"$work/my prefix/bin/redcc-cc" x.c -o p || fail "$case_name"
expect_equal "$case_name: shared" "translated ran" "$(./p | paste -sd' ')"
rm -rf "$work/my prefix"
end

finish
