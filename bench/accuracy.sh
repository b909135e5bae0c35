# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Time and accuracy of each order and each sum (bench/accuracy.c): a table, all figures as CSV and, if gnuplot is
# installed, a plot of accuracy against time.
. bench/common.sh
cmake --build --preset release --target bench_accuracy >/dev/null
accuracy=$(find "$build" -name bench_accuracy -type f)
csv=$results/accuracy.csv
load_note
"$accuracy" "$(nproc)" >"$csv"

# The column "time over any" has the time relative to the sequential loop of the same process, divided by that of
# order `any` with method auto.
table() {
  awk -F, 'NR > 1 {
      relative = $7 / $8
      if ($3 == "any" && $5 == "auto") base = relative
      printf "%s,%s,%s,%s,%s,%.2f,%.2f,%s,%s,%s,%s,%s\n", $1, $2, $3, $4, $5, $8 / $7,
             relative / base, $9, $10, $11, $13, $14
    }' "$csv"
}
{
  echo "rows,values,order,sum,method,speed-up,time over any,largest error,median error,results of 20 runs,of all threads,spread"
  table
} | column -s, -t

plot=$results/accuracy.png
# One panel for each kind of rows, one line for each variant. The horizontal axis is the time divided by that of order
# `any`. Each point is labelled with the largest error, and * if results differ between runs or thread counts.
panel() { # ROWS: prints gnuplot commands; their data are in $work
  awk -F, -v r="$1" '
    NR > 1 && $1 == r && $3 == "any" && $5 == "auto" {base[$2] = $7 / $8}
    NR > 1 && $1 == r {
      way = $3 " " $5 ($4 == "plain" ? "" : " " $4)
      if (!(way in row)) row[way] = ++rows
      printf "%d,%s,%s,%g,%.0e%s\n", row[way], way, $2, $7 / $8 / base[$2], $9, ($13 > 1 ? "*" : "")
    }' "$csv" >"$work/$1"
  echo "set title '$1 rows'"
  echo "plot '$work/$1' using 4:(-\$1):ytic(2) with points pointtype 0 linecolor 'white', \
    '' using (strcol(3) eq 'well' ? \$4 : NaN):(-\$1 + 0.2) with points linetype 1 pointtype 6 pointsize 1.2, \
    '' using (strcol(3) eq 'well' ? \$4 : NaN):(-\$1 + 0.2):5 with labels left offset 1,0 font ',9', \
    '' using (strcol(3) eq 'ill' ? \$4 : NaN):(-\$1 - 0.2) with points linetype 2 pointtype 7 pointsize 1.2, \
    '' using (strcol(3) eq 'ill' ? \$4 : NaN):(-\$1 - 0.2):5 with labels left offset 1,0 font ',9'"
}
if ! command -v gnuplot >/dev/null; then
  echo "no plot: gnuplot (Debian's gnuplot-nox) is not installed"
else
  {
    echo "set terminal pngcairo size 1200,700 font ',11'; set datafile separator ','"
    echo "set output '$plot'"
    echo "set multiplot layout 1,2 title 'Time over order any ($(nproc) threads), and the largest relative error of a sum (*: runs differ; filled: 1e-12 of the parts is left)'"
    echo "set logscale x; set grid x; set border 3; set tics nomirror; unset key; set xrange [0.3:300]"
    echo "set yrange [-12.7:-0.3]; set xlabel 'time over any'"
    panel sorted
    panel shuffled
  } >"$work/plot"
  gnuplot "$work/plot" && echo "plotted: $plot"
fi
echo "kept: $csv"
