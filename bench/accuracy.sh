# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What each order and each sum costs in time and buys in accuracy (bench/accuracy.c): a table, the
# figures of each way as CSV, and, where gnuplot is installed, a plot of one against the other.
. bench/common.sh
cmake --build --preset release --target bench_accuracy >/dev/null
accuracy=$(find "$build" -name bench_accuracy -type f)
csv=$results/accuracy.csv
load_note
"$accuracy" "$(nproc)" >"$csv"

# time: seconds over the sequential loop's of the same process, over those of order any, auto
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
# One panel for each mesh: time over any across, largest error up. Shape and colour are the order, the
# number is the method, filled is badly conditioned; * where results differ between runs or with the
# thread count.
panel() { # rows: gnuplot commands, their data in $work
  local order sum method number=0 line="" colour shape style at
  for values in well ill; do
    awk -F, -v r="$1" -v v="$values" '
      NR > 1 && $3 == "any" && $5 == "auto" && $1 == r && $2 == v {base = $7 / $8}
      NR > 1 && $1 == r && $2 == v {
        printf "%s %s %s %g %g %s\n", $3, $4, $5, $7 / $8 / base, ($9 > 1e-17 ? $9 : 1e-17),
               ($13 > 1 ? "*" : "-")
      }' "$csv" >"$work/$1-$values"
  done
  while read -r order sum method _; do
    case $order:$sum in
      any:*) colour=1 shape=6 ;;
      fixed:*) colour=2 shape=4 ;;
      *:plain) colour=3 shape=8 ;;
      *) colour=4 shape=12 ;;
    esac
    at="every ::$number::$number using 4:5"
    number=$((number + 1))
    style="linetype $colour pointsize 1.5"
    [ "$sum" = plain ] || method="$method, $sum"
    line="$line, '$work/$1-well' $at with points $style pointtype $shape title '$number  $order, $method'"
    line="$line, '$work/$1-ill' $at with points $style pointtype $((shape + 1)) notitle"
    for values in well ill; do
      line="$line, '$work/$1-$values' $at:(strcol(6) eq '*' ? '$number*' : '$number') with labels"
      line="$line offset 0,$((number % 2 * 2 - 1)) font ',9' notitle"
    done
  done <"$work/$1-well"
  echo "set title '$1 rows; filled: 1e-12 of the parts is left; *: results differ with runs or threads'"
  echo "plot ${line#, }"
}
if ! command -v gnuplot >/dev/null; then
  echo "no plot: gnuplot (Debian's gnuplot-nox) is not installed"
else
  {
    echo "set terminal pngcairo size 1200,900 font ',10'"
    echo "set output '$plot'"
    echo "set multiplot layout 2,1 title 'Largest error of a sum, relative to the exact one, and time over order any ($(nproc) threads)'"
    echo "set logscale xy; set format y '10^{%L}'; set grid; set key outside right top Left reverse font ',9'"
    echo "set offsets graph 0.05, graph 0.05, 0, 0; set yrange [1e-17:1]"
    echo "set xlabel 'time over any'; set ylabel 'largest error'"
    panel sorted
    panel shuffled
  } >"$work/plot"
  gnuplot "$work/plot" && echo "plotted: $plot"
fi
echo "kept: $csv"
