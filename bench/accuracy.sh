# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What each order and each sum costs in time and buys in accuracy (bench/accuracy.c): a table, the
# figures of each way as CSV, and, where gnuplot is installed, a plot of both.
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
      printf "%s,%s,%s,%s,%s,%.2f,%.2f,%s,%s,%s,%s\n", $1, $2, $3, $4, $5, $8 / $7,
             relative / base, $9, $10, $11, $13
    }' "$csv"
}
{
  echo "rows,values,order,sum,method,speed-up,time over any,largest error,median error,results of 20 runs,of all threads"
  table
} | column -s, -t

plot=$results/accuracy.png
if ! command -v gnuplot >/dev/null; then
  echo "no plot: gnuplot (Debian's gnuplot-nox) is not installed"
else
  for values in well ill; do
    awk -F, -v v="$values" 'NR > 1 && $1 == "shuffled" && $2 == v {
        error = $9 > 1e-17 ? $9 : 1e-17
        printf "\"%s %s%s\" %g %g %g\n", $3, $5, $4 == "plain" ? "" : " compensated", error, $14, $7 / $8
      }' "$csv" >"$work/$values"
  done
  gnuplot <<EOF
set terminal pngcairo size 1100,900 font ",11"
set output "$plot"
set multiplot layout 2,1
set lmargin 10
set rmargin 18
set style data histograms
set style histogram clustered gap 1
set style fill solid 0.8 border -1
set xtics rotate by -25 font ",9"
set grid ytics
set logscale y
set format y "10^{%L}"
set yrange [1e-17:1]
set key top right
set title "Largest error of an element's sum, relative to the exact sum (shuffled rows)"
plot "$work/well" using 2:xtic(1) title "well conditioned", \
     "$work/ill" using 2 title "1e-12 of the parts is left", \
     "$work/ill" using (\$3 > 1e-17 ? \$3 : 1e-17) title "of these: spread over thread counts"
unset logscale y
set format y "%g"
set yrange [0:*]
set title "Time, over the sequential loop's, $(nproc) threads"
plot "$work/ill" using 4:xtic(1) notitle
EOF
  echo "plotted: $plot"
fi
echo "kept: $csv"
