#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Options by which a program means something else than what is judged, or by which floating-point
# operations may be rounded otherwise in each copy: the same after --, and through -p. (redcc-cc:
# tests/driver/compilers.sh.)
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >x.c <<'END'
void sums(int n, const int *s, const double *restrict x, double *h) {
    for (int t = 0; t < n; t++)
        h[s[t]] += x[t];
}
void counts(int n, const int *restrict s, int *h) {
    for (int t = 0; t < n; t++)
        h[s[t]]++;
}
END
cat >integers.c <<'END'
void counts(int n, const int *restrict s, int *h) {
    for (int t = 0; t < n; t++)
        h[s[t]]++;
}
END
source=x.c
verdicts() { # REDCC-ARGUMENTS: of the source's loops, a word each
    "$ATTACK_REDCC" --analyze $source --report=json "$@" |
        jq -r '[.loops[] | if .verdict == "transformed" then "transformed" else .reason.slug end] | join(" ")'
}
expect() { # WORDS OPTION [WORDS of -p]
    local found
    found=$(verdicts -- -O2 "$2")
    [ "$found" = "$1" ] || { echo "-- $2: expected '$1', found '$found'" >&2; exit 1; }
    set -- "${3:-$1}" "$2"
    jq -n --arg folder "$work" --arg option "$2" \
        --arg source $source \
        '[{directory: $folder, file: $source, arguments: ["gcc", "-O2", $option, "-c", $source, "-o", "x.o"]}]' \
        >compile_commands.json
    found=$(verdicts -p .)
    [ "$found" = "$1" ] || { echo "-p $2: expected '$1', found '$found'" >&2; exit 1; }
}
for option in -fwrapv-pointer -ftrapv -fno-strict-overflow -frounding-math -funsigned-bitfields \
    -fno-signed-bitfields -fsingle-precision-constant -fpack-struct=1 -fshort-wchar -ffreestanding -m32 \
    -mlong-double-128 -Wp,-isystem,x -undef; do
    expect "option option" "$option"
done
# Liberties of the compiler: a build's translated files are compiled without them.
for option in -ffast-math -Ofast -funsafe-math-optimizations -fassociative-math -freciprocal-math \
    -fno-signed-zeros -ffinite-math-only -mrecip -fcx-limited-range; do
    expect "inexact-option inexact-option" "$option" "transformed transformed"
    source=integers.c expect "transformed" "$option"
done
for option in -mfpmath=387 -mfpmath=both -mfpmath=sse,387 -ffp-model=fast -fdenormal-fp-math=preserve-sign; do
    expect "inexact-option inexact-option" "$option"
    source=integers.c expect "transformed" "$option"
done
for option in -O3 -fwrapv -fno-math-errno -fno-trapping-math -mfpmath=sse -fPIC -ffp-contract=off -g -Wall -fno-plt; do
    expect "transformed transformed" "$option"
done
# with the bits given up the loop is translated
[ "$(verdicts --order=any -- -ffast-math)" = "transformed transformed" ]
