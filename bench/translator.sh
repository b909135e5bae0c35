# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The time of redcc's analysis relative to clang-19 -fsyntax-only, run in turn on the same file. The files are a small
# one with many headers; generated ones, each twice as long as the preceding one; functions with many loops; and the
# file named by REDCC_BENCH_SOURCE, such as SQLite's amalgamation.
. bench/common.sh
redcc=$build/tool/redcc
cc -O1 -o "$work/measure" bench/measure.c
csv=$results/translator.csv
rounds=${ROUNDS:-7}
echo "file,lines,clang_seconds,redcc_seconds,ratio,redcc_megabytes" >"$csv"

headers() {
  for h in stdio stdlib string math complex unistd pthread signal time netdb locale wchar setjmp \
    sys/socket sys/stat sys/mman sys/wait netinet/in jansson immintrin; do
    echo "#include <$h.h>"
  done
  one_function 0
}

one_function() { # NUMBER
  cat <<C
struct part$1 { double x, f; int next; };
static int clamped$1(int k, int n) { return k < 0 ? 0 : k < n ? k : n - 1; }
double step$1(int n, const int *restrict k, const double *restrict w, double *restrict h,
              struct part$1 *restrict p) {
    double sum = 0;
    for (int t = 0; t < n; t++) {
        const int i = clamped$1(k[t], n);
        h[i] += w[t] * 0.5;
        if (w[t] > 1.0)
            p[i].f -= w[t] * p[i].x;
    }
    for (int t = 0; t < n; t++)
        sum += h[t] * $1;
    for (struct part$1 *q = p; q->next >= 0; q += q->next)
        q->x = q->f / (sum + 1);
    switch (n % 3) {
    case 0:
        return sum;
    case 1:
        sum = sum * sum - n;
        break;
    default:
        sum /= 2;
    }
    return h[n / 2] > sum ? h[n / 2] - sum : p[n / 2].f + sum;
}
C
}

functions() { for ((i = 0; i < $1; i++)); do one_function "$i"; done; }

loops_in_one_function() {
  echo "void all(int n, const int *restrict k, const double *restrict w, double *restrict h) {"
  for ((i = 0; i < $1; i++)); do
    printf '    for (int t = 0; t < n; t++)\n        h[k[t]] += w[t] * %d;\n' "$i"
  done
  echo "}"
}

compare() { # NAME FILE
  local i lines clang_time redcc_time
  : >"$work/clang"; : >"$work/redcc"
  for ((i = 0; i < rounds; i++)); do
    "$work/measure" clang-19 -w -fsyntax-only "$2" >>"$work/clang"
    "$work/measure" "$redcc" --analyze "$2" >>"$work/redcc"
  done
  lines=$(wc -l <"$2")
  clang_time=$(cut -d' ' -f1 "$work/clang" | median)
  redcc_time=$(cut -d' ' -f1 "$work/redcc" | median)
  awk -v n="$1" -v l="$lines" -v a="$clang_time" -v b="$redcc_time" \
    -v m="$(cut -d' ' -f2 "$work/redcc" | maximum)" -v csv="$csv" 'BEGIN {
      printf "%-24s %7d lines: clang %.3f s, redcc %.3f s, ratio %.2f, %d MB\n", n, l, a, b, b / a, m / 1024
      printf "%s,%d,%.4f,%.4f,%.3f,%d\n", n, l, a, b, b / a, m / 1024 >>csv
    }'
}

load_note
headers >"$work/headers.c"
compare headers "$work/headers.c"
for count in 250 500 1000 2000 4000; do
  functions $count >"$work/functions.c"
  compare "functions-$count" "$work/functions.c"
done
for count in 250 500 1000 2000; do
  loops_in_one_function $count >"$work/loops.c"
  compare "loops-$count" "$work/loops.c"
done
if [ -n "${REDCC_BENCH_SOURCE:-}" ]; then
  compare "$(basename "$REDCC_BENCH_SOURCE")" "$REDCC_BENCH_SOURCE"
fi
echo "kept: $csv"
