# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Measures nothing: pools all runs of `script/bench methods` in the git history. For each loop it prints the median,
# minimum and maximum of the runs' medians, the number of runs, and the oldest and newest commit. Runs of older code are
# included, so the figures show what a user may expect, not the best case.
set -euo pipefail
cd "$(dirname "$0")/.."
for results in bench/results/*/methods.csv; do
  echo "$results"
  for commit in $(git log --format=%h -- "$results"); do
    git show "$commit:$results" | awk -F, -v commit="$commit" '
      NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
      column["speed_up"] && $column["order"] == "serial" && $3 ~ /^auto/ {
        print $1 "," $2 "," commit "," $column["speed_up"] }'
  done | sort -t, -k1,1 -k2,2 -k4,4n | awk -F, '
    function finish() { if (n) printf "%s, %s: median %.2f, from %.2f to %.2f, %d runs\n", loop, mesh,
        n % 2 ? v[(n + 1) / 2] : (v[n / 2] + v[n / 2 + 1]) / 2, v[1], v[n], n }
    $1 != loop || $2 != mesh { finish(); n = 0; loop = $1; mesh = $2 }
    { v[++n] = $4 }
    END { finish() }'
done
