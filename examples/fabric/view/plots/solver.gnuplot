# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
set terminal pngcairo size 1200,520 font 'sans,11'
set output 'solver.png'
set logscale xy
set multiplot layout 1,3 title 'Direct against iterative: '.scene
stats 'solver.csv' skip 1 using ($11 / $7 * 1e3) nooutput
least = STATS_min / 2
most = STATS_max * 2
set xrange [0.7:300]
set xtics (1, 3.3, 10, 33)
set xlabel 'step, ms'
set ylabel 'CPU time of a step, ms'
ways = '"gauss-seidel to 1e-2" "gauss-seidel to 1e-6" direct'
do for [p=0:2] {
  undefine STATS_*
  set autoscale
  stats 'solver.csv' skip 1 using (floor($0 / 12) == p ? $3 : 1/0) nooutput
  if (exists('STATS_records') && STATS_records > 0) {
    size = STATS_max
    set xrange [0.7:300]
    set yrange [least:most]
    set title sprintf('%d vertices', size)
    plot for [n=1:3] 'solver.csv' skip 1 using ($3 == size && is(word(ways, n)) ? $5 * 1e3 : NaN):($11 / $7 * 1e3) with linespoints lw 2 pt 7 lc rgb color(n), \
    for [n=1:3] '' skip 1 using ($3 == size && $5 > 0.03 && is(word(ways, n)) ? $5 * 1e3 : NaN):($11 / $7 * 1e3):(word('"to 1e-2" "to 1e-6" direct', n)) with labels left offset 1,(n == 3 ? 0.5 : -0.4) tc rgb color(n)
  }
}
unset multiplot
