# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Measures nothing: pools all runs of `script/bench methods` in the git history. For each loop and method it prints the
# median, minimum and maximum of the runs' medians, and the number of runs. Runs of older code are included, so the
# figures show what a user may expect, not the best case. Equal measurements are one run, which several commits may
# hold, also under other names of methods. The oldest file, without a column `order`, is left out: its loops were timed
# without the seconds of executions before.
set -euo pipefail
cd "$(dirname "$0")/.."
for results in bench/results/*/methods.csv; do
  echo "$results"
  for commit in $(git log --format=%h -- "$results"); do
    git show "$commit:$results" | awk -F, '
      BEGIN { OFS = "," }
      NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
      !column["order"] { exit }
      $3 ~ /^auto/ && $column["order"] == "serial" { name = "redcc" }
      $3 ~ /^omp-/ { name = $3 }
      name { print $1, $2, name, $column["serial_seconds"], $column["seconds"], $column["speed_up"]; name = "" }'
  done | sort -u | sort -t, -k1,3 -k6,6n | awk -F, '
    function finish() { if (n) printf "%s: median %.2f, from %.2f to %.2f, %d runs\n", loop,
        n % 2 ? v[(n + 1) / 2] : (v[n / 2] + v[n / 2 + 1]) / 2, v[1], v[n], n }
    $1 ", " $2 ", " $3 != loop { finish(); n = 0; loop = $1 ", " $2 ", " $3 }
    { v[++n] = $6 }
    END { finish() }'
done
