#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# redcc-cc --redcc-html: reports joined as pages. Reports and sources are written here, so that each value
# that is to be found on a page is known. Pages are checked as XML.
. "$(dirname "$0")/library.sh"
redcc_cc=$REDCC_CC_PROGRAM
unset REDCC_BUILD_REPORT REDCC_REPORT

refused() { # LINE FUNCTION ID SLUG MESSAGE
  printf '{"line":%d,"column":5,"function":"%s","verdict":"refused","reason":{"id":"%s","slug":"%s","message":"%s","line":%d,"column":9},"arrays":[],"guards":[]}' \
    "$1" "$2" "$3" "$4" "$5" $(($1 + 1))
}
parallel() { # LINE FUNCTION
  printf '{"line":%d,"column":5,"function":"%s","verdict":"transformed","reason":null,"arrays":[{"name":"h","operator":"+","type":"double"}],"guards":["no-overlap(h, <w>)"]}' "$1" "$2"
}
build() { # FILE LOOP...
  local file=$1 IFS=,
  shift
  printf '{"directory":"%s","redcc":"1","schema":1,"file":"%s","order":"serial","loops":[%s]}\n' "$PWD" "$file" "$*"
}
ran() { # FILE LINE FUNCTION SEQUENTIAL-SECONDS EXECUTE-SECONDS SPEEDUP [FALLBACKS [ADVICE]]
  printf '{"file":"%s","line":%d,"function":"%s","method":"localwrite","mode":"reused","rule":"faster","threads":2,"calls":7,"plans_built":1,"plans_reused":4,"plans_lost":1,"changed":[{"array":"key","count":1}],"inspect_seconds":0,"execute_seconds":%s,"sequential_seconds":%s,"speedup":%s,"modelled_speedup":1.9,"why_sequential":%s,"fallbacks":[%s]}' \
    "$1" "$2" "$3" "$5" "$4" "$6" "${8:-null}" "${7:-}"
}
run_report() { local IFS=,; printf '{"process": 1, "seconds": 4.0,\n "loops": [%s]}\n' "$*"; }

line_of() { xmllint --xpath "string(//*[@id='L$2'])" "$1"; } # PAGE LINE: what is shown there
check_pages() { # FOLDER: every page is XML, no name stands twice, and every link leads somewhere
  local page target name
  for page in "$1"/*.html; do
    xmllint --noout "$page" 2>xml || { fail "$case_name: $page is no XML: $(head -n 3 xml)"; continue; }
    name=$(grep -o ' id="[^"]*"' "$page" | sort | uniq -d)
    [ -z "$name" ] || fail "$case_name: $page has twice: $name"
    grep -o ' href="[^"]*"' "$page" | cut -d '"' -f 2 | sort -u | while read -r target; do
      name=${target%%#*}
      name=${name:-$(basename "$page")}
      if [ ! -f "$1/$name" ]; then
        fail "$case_name: $page leads to $target"
      elif [ "$target" != "${target#*#}" ]; then
        grep -qF " id=\"${target#*#}\"" "$1/$name" || fail "$case_name: $page leads to $target"
      fi
    done
    expect_no_match "$page" '<script|https?://[^w]|src='
  done
}

begin "sources and names that HTML would misread"
mkdir 'a & <b>'
odd='a & <b>/it'\''s "x" é.c'
printf 'void f(void) { /* </script> & <b> &amp; "q" '\''s'\'' */\r\n\tfor (;;)  x  = "\xc3\xa9";\r\n\n  end\t\x01\x0c' >"$odd"
printf 'latin \xe9\xff\n    for (;;)\n        ;\n' >latin.c
{
  build "${odd//\"/\\\"}" "$(refused 2 'f<&>' R104 update-value-used 'a \"message\" with <b> & more')"
  build latin.c "$(parallel 2 g)"
  printf '{"redcc":"1","file":"c.c","loops":[],"left_alone":"it has <omp> & more"}\n'
} >build.jsonl
"$redcc_cc" --redcc-html pages build.jsonl || fail "$case_name"
check_pages pages
odd_page=pages/1-it_s__x____.c.html
expect_equal "$case_name: line 1" "1void f(void) { /* </script> & <b> &amp; \"q\" 's' */" "$(line_of "$odd_page" 1)"
expect_equal "$case_name: line 2" $'2\tfor (;;)  x  = "é";' "$(line_of "$odd_page" 2)"
expect_equal "$case_name: line 3" 3 "$(line_of "$odd_page" 3)"
expect_equal "$case_name: line 4" $'4  end\t��' "$(line_of "$odd_page" 4)"
expect_equal "$case_name: Latin-1" '1latin éÿ' "$(line_of pages/*latin.c.html 1)"
expect_match "$odd_page" 'a &quot;message&quot; with &lt;b&gt; &amp; more \(<a href="#L3">line 3'
expect_match "$odd_page" 'What to change: Split the loop'
expect_match "$odd_page" '<pre class="example">out\[place\[key\[t\]\]\+\+\]'
expect_match "$odd_page" '<code>f&lt;&amp;&gt;</code>'
expect_match pages/*latin.c.html 'no-overlap\(h, &lt;w&gt;\)'
expect_match pages/index.html 'left alone: it has &lt;omp&gt; &amp; more'
expect_match pages/index.html 'name them|No run.s report was given'
end

begin "runs are joined, and loops are in the order of the time lost"
printf 'l%s\n' $(seq 60) >x.c
cp x.c y.c
{
  build x.c "$(parallel 10 slow)" "$(parallel 20 good)" "$(refused 30 no R106 array-read 'reads h')"
  build y.c "$(parallel 10 slow)"
  build x.c "$(parallel 10 slow)" "$(parallel 20 good)" "$(refused 30 no R201 may-alias 'may alias')"
} >build.jsonl
# slow: 1 s sequential on 2 threads loses half; good: 1 s in parallel at 1.8 loses a tenth; strange is in no build
run_report "$(ran x.c 20 good 0 1 1.8)" "$(ran x.c 10 slow 1 0 null '{"slug":"little-work","reason":"too little <work>","count":3}' '"raise the <work>"')" "$(ran z.c 5 strange 0 0.5 2)" >one.json
run_report "$(ran x.c 20 good 0 1 1.8)" >two.json
"$redcc_cc" --redcc-html pages one.json build.jsonl two.json || fail "$case_name"
check_pages pages
expect_equal "$case_name: order" "x.c:10 x.c:20 z.c:5 x.c:30 x.c:30 y.c:10" \
  "$(sed -n 's/^<tr><td><span class="place">//p' pages/index.html | sed 's/<a [^>]*>//; s/<.*//' | head -n 6 | paste -sd ' ')"
tr -d '\n' <pages/index.html | sed 's/<tr>/\n/g' >rows
expect_match rows 'x\.c:10.*>500\.0 ms<.*>1\.00 s<.*width:25\.0%.*<span class="soft">-</span>.*localwrite.*kept 4 of 5'
expect_match rows 'x\.c:20.*>200\.0 ms<.*>2\.00 s<.*width:25\.0%.*>1\.80<.*kept 8 of 10'
expect_match rows 'z\.c:5<.*not in the build'
expect_match rows 'y\.c:10.*<span class="soft">-</span>'
expect_match pages/index.html '<b>2</b> runs'
expect_match pages/index.html '<b>3</b> parallel loops'
expect_match pages/1-x.c.html 'line 10, in 2 compilations'
expect_match pages/1-x.c.html '3 &#215; too little &lt;work&gt;'
expect_match pages/1-x.c.html 'Advice<.*raise the &lt;work&gt;'
expect_match pages/1-x.c.html 'built: 1, kept: 4 executions; lost: 1, as this had changed: <code>key</code>'
for loop in 10 20 30; do expect_match pages/1-x.c.html "<span id=\"L$loop\" class=\"(parallel|refused)\">"; done
cp -r pages before
"$redcc_cc" --redcc-html pages/ one.json build.jsonl two.json && diff -r before pages >&2 || fail "$case_name: twice is not the same"
REDCC_BUILD_REPORT=$PWD/build.jsonl REDCC_REPORT=$PWD/one.json "$redcc_cc" --redcc-html usual || fail "$case_name: by the environment"
expect_match usual/index.html '<b>1</b> run<'
end

begin "long, missing and changed sources"
for line in $(seq 10000); do echo "int v$line;"; done >long.c
printf 'one\ntwo\n' >short.c
{
  build long.c "$(parallel 9999 f)"
  build short.c "$(parallel 2 f)" "$(refused 7 g R104 update-value-used m)" "$(parallel 7 h)"
  build gone.c "$(refused 7 g R104 update-value-used m)"
} >build.jsonl
"$redcc_cc" --redcc-html pages build.jsonl || fail "$case_name"
check_pages pages
expect_equal "$case_name: lines" 10000 "$(grep -c '<span id="L' pages/*long.c.html)"
expect_match pages/*short.c.html 'has changed since it was compiled'
expect_match pages/*gone.c.html 'cannot be read'
expect_equal "$case_name: notes" 3 "$(grep -c '<section class="note' pages/*short.c.html)"
end

begin "what is wrong is said, and nothing is changed"
build x.c "$(parallel 1 f)" >build.jsonl
echo old >kept
complain() { # STATUS PATTERN ARGUMENTS...
  local status=$1 pattern=$2
  shift 2
  "$redcc_cc" --redcc-html "$@" 2>messages
  expect_equal "$case_name: $*" "$status" $?
  expect_match messages "$pattern"
}
complain 2 'needs a folder for the pages' 
complain 2 'needs a folder for the pages' pages
complain 1 "cannot read 'none': No such file" pages build.jsonl none
printf '{"redcc":"1","file":"x.c","loops":[]}\n\nnot JSON\n' >bad
complain 1 "bad:3: error: expected a JSON object" pages bad
printf '{"redcc":"1","file":"x.c","loops":[3]}\n' >bad
complain 1 "bad:1: error: expected" pages bad
complain 1 "none of the files is a build's report" pages <(run_report "$(ran x.c 1 f 1 1 1)")
expect_no_file pages
complain 1 "'kept' exists, and is no folder" kept build.jsonl
mkdir mine && echo mine >mine/notes.txt
complain 1 "'mine' holds 'notes.txt'" mine build.jsonl
complain 1 'cannot create' none/pages build.jsonl
expect_equal "$case_name" "mine old" "$(cat mine/notes.txt kept | paste -sd ' ')"
expect_equal "$case_name: nothing else" "bad build.jsonl kept messages mine" "$(ls | paste -sd ' ')"
end

finish
