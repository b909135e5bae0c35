#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Loops in the headers of a project of several sources: each source's report lists them, and what is
# said of the whole build counts them once. BUILD is the build folder.
. "$(dirname "$0")/library.sh"
export REDCC_ROOT=$BUILD OMP_WAIT_POLICY=passive
redcc_cc=$REDCC_CC_PROGRAM
redcc=$BUILD/tool/redcc

make_sources() {
  mkdir -p src include vendor
  cat >include/kernel.h <<'END_OF_FILE'
#ifndef KERNEL_H
#define KERNEL_H
static inline void deposit(int n, const int *s, const double *e, double *h)
{
    for (int t = 0; t < n; t++)
        h[s[t]] += e[t];
}
static inline void not_used(int n, const int *s, double *h)
{
    for (int t = 0; t < n; t++)
        h[s[t]] += 2;
}
#endif
END_OF_FILE
  cat >vendor/vendor.h <<'END_OF_FILE'
static inline void of_others(int n, const int *s, double *h)
{
    for (int t = 0; t < n; t++)
        h[s[t]] += 3;
}
END_OF_FILE
  for name in a b c; do
    cat >src/$name.c <<END_OF_FILE
#include "../include/kernel.h"
#include <vendor.h>
void $name(int n, const int *s, const double *e, double *h)
{
    deposit(n, s, e, h);
    of_others(n, s, h);
    for (int t = 0; t < n; t++)
        h[s[t]] -= e[t];
}
END_OF_FILE
  done
}
in_headers='.loops[] | select(.file != null) | [(.file | sub(".*/"; "")), .line, .function, .verdict, .reason.slug]'

begin "a project"
make_sources
export REDCC_BUILD_REPORT=$PWD/report
for name in a b c; do
  "$redcc_cc" -O2 -isystem vendor -c src/$name.c || fail "$case_name: $name.c"
done
unset REDCC_BUILD_REPORT
expect_equal "$case_name: each source lists it" 3 \
  "$(jq -c "$in_headers" report | grep -cx '\["kernel.h",5,"deposit","refused","in-header"\]')"
expect_equal "$case_name: and no other" 3 "$(jq -c "$in_headers" report | wc -l)"
"$redcc_cc" --redcc-summary report >summary || fail "$case_name: no summary"
expect_match summary 'irregular reductions: 3 parallel, 1 refused'
expect_match summary 'refused: R518 in-header: 1$'
"$redcc_cc" --redcc-html pages report || fail "$case_name: no pages"
expect_equal "$case_name: pages" 4 "$(ls pages/*.c.html pages/*.h.html | wc -l)"
expect_match pages/*kernel.h.html 'which is included'
expect_match pages/*kernel.h.html 'h\[s\[t\]\] \+= 2'
end

begin "the advice is followed: the function moves to a source"
make_sources
{ echo '#include "../include/kernel.h"'; sed -n '/void deposit/,/^}/p' include/kernel.h; } |
  sed 's/static inline //' >src/kernel.c
sed -i '/void deposit/,/^}/d; 2a void deposit(int n, const int *s, const double *e, double *h);' include/kernel.h
"$redcc" --analyze --report=json src/kernel.c >moved || fail "$case_name"
expect_equal "$case_name" '["deposit","transformed"]' "$(jq -c '.loops[] | [.function, .verdict]' moved)"
end

begin "a folder of commands"
make_sources
for name in a b c; do
  jq -n --arg d "$PWD" --arg f src/$name.c \
    '{directory: $d, file: $f, arguments: ["cc", "-isystem", "vendor", "-c", $f, "-o", ($f + ".o")]}'
done | jq -s . >compile_commands.json
"$redcc" --analyze -p . --report=sarif >log 2>counts || fail "$case_name: redcc"
expect_match counts '^ +in-header +1$'
expect_equal "$case_name: results" 1 "$(jq '[.runs[0].results[] | select(.ruleId == "R518")] | length' log)"
"$redcc" --analyze -p . >/dev/null 2>remarks || fail "$case_name: redcc"
expect_match remarks 'kernel\.h:5:5: remark: loop in .deposit. stays sequential: R518'
expect_match remarks 'kernel\.h:5:5: note: move the function to a source file'
expect_no_match remarks 'vendor\.h'
end

finish
