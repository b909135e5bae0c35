#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# 12-letters-in-a-locale.c with a locale that has letters above 127, which few systems bring along.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
localedef -c -i de_DE -f ISO-8859-1 "$work/de_DE" 2>messages || [ -d "$work/de_DE" ] || {
    echo "no locale can be made here: skipped"
    exit 0
}
export LOCPATH=$work
"$ATTACK_REDCC" "$here/12-letters-in-a-locale.c" -o parallel.c -- -O2 2>remarks
cc -w -O2 "$here/12-letters-in-a-locale.c" -o sequential
cc -w -O2 -Wl,-u,redcc_run -idirafter "$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -lm -o parallel
./sequential >expected
[ "$(sort -u expected | cut -d' ' -f2 | sort -u | wc -l)" -gt 1 ] || { echo "all locales are alike" >&2; exit 1; }
for threads in 1 2 3 7; do
    for method in auto localwrite localwrite-steal; do
        REDCC_METHOD=$method OMP_NUM_THREADS=$threads ./parallel >found
        cmp expected found || { echo "$method, $threads threads: other letters" >&2; exit 1; }
    done
done
