# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The first row is the scene as it is (`default`); most plots choose other rows by name.
stats 'dt.csv' skip 1 using (is('midpoint') ? $5 : NaN) nooutput
fine = STATS_min
coarse = STATS_max
stats 'dt.csv' skip 1 using 11 nooutput
fast = STATS_min
slow = STATS_max
stats 'dt.csv' skip 1 using ($12 > 0 ? $12 * 1e3 : NaN) nooutput
small = STATS_min
large = STATS_max
set logscale xy
set output 'dt-time.png'
set title 'Error against CPU time: '.scene.'; grey: the front; square: as the scene is'
set xlabel 'CPU time of the run, s'
set ylabel 'error at the end, mm (root mean square)'
set xrange [fast / 1.5 : slow * 3]
set yrange [small / 2 : large * 2]
set xtics @nice
plot 'dt.csv' skip 1 using ($15 == 1 ? $11 : NaN):($12 * 1e3) smooth unique with lines lw 12 lc rgb '#cccccc', \
    for [n=1:4] '' skip 1 using (is(word(integrators, n)) ? $11 : NaN):($12 * 1e3) \
        with linespoints lw 2 pt 7 lc rgb color(n), \
    '' skip 1 using (is('linear-euler') && $5 == coarse ? $11 : NaN):($12 * 1e3):(say('linear-euler')) \
        with labels left offset 1,0.6 tc rgb color(1), \
    '' skip 1 using (is('euler') && $5 == coarse ? $11 : NaN):($12 * 1e3):(say('euler')) \
        with labels left offset 0.5,0.9 tc rgb color(2), \
    for [n=3:4] '' skip 1 using (is(word(integrators, n)) && $5 == fine ? $11 : NaN):($12 * 1e3):(say(word(integrators, n))) with labels left offset 1,(n == 3 ? 0.7 : 0) tc rgb color(n), \
    '' skip 1 using (is('default') ? $11 : NaN):($12 * 1e3) with points pt 4 ps 2.5 lw 2 lc 'black'
set output 'dt-step.png'
set title 'Error against step: '.scene
set xlabel 'step, ms'
set xrange [fine * 700 : coarse * 3000]
slope(x, n, k) = large * k * (x / (1e3 * coarse))**n
set label 1 'slope 1' at 1e3 * fine, slope(1e3 * fine, 1, 2) right offset -0.5,0 tc rgb '#777777'
set label 2 'slope 2' at 1e3 * fine, slope(1e3 * fine, 2, 0.1) right offset -0.5,0 tc rgb '#777777'
set yrange [small / 4 : large * 4]
plot sample [1e3 * fine : 1e3 * coarse] '+' using 1:(slope($1, 1, 2)) with lines dt 2 lc rgb '#777777', \
    [1e3 * fine : 1e3 * coarse] '+' using 1:(slope($1, 2, 0.1)) with lines dt 2 lc rgb '#777777', \
    for [n=1:4] 'dt.csv' skip 1 using (is(word(integrators, n)) ? $5 * 1e3 : NaN):($12 * 1e3) \
        with linespoints lw 2 pt 7 lc rgb color(n), \
    for [n=1:4] '' skip 1 using (is(word(integrators, n)) && $5 == coarse ? $5 * 1e3 : NaN):($12 * 1e3):(say(word(integrators, n))) with labels left offset 1,0 tc rgb color(n)
unset label
set terminal pngcairo size 1200,480 font 'sans,11'
set output 'dt-measures.png'
amount(p) = column(20 + p) > 0 ? column(20 + p) * 1e3**p : NaN
set xrange [*:*]
set yrange [*:*]
measures = ''
do for [p=0:2] {
  undefine STATS_*
  stats 'dt.csv' skip 1 using (amount(p)) nooutput
  if (exists('STATS_records') && STATS_records > 0) { measures = measures.p.' ' }
}
panels = words(measures)
set multiplot layout 1,panels title scene.': other errors at the end of the run, by CPU time'
set xlabel 'CPU time, s'
set xrange [fast / 3 : slow * 1.5]
set format y '10^{%L}'
unset title
titles = '"strain of the triangle stretched most" "energy, mJ" "depth in a body, um"'
do for [k in measures] {
  p = int(k)
  set ylabel word(titles, p + 1)
  plot for [n=1:4] 'dt.csv' skip 1 using (is(word(integrators, n)) ? $11 : NaN):(amount(p)) \
        with linespoints lw 2 pt 7 lc rgb color(n), \
    for [n=1:4] '' skip 1 using (is(word(integrators, n)) && $5 == coarse ? $11 : NaN):(amount(p)):(word('"linearised Euler" Euler BDF2 midpoint', n)) with labels right offset -1,(n == 3 ? -0.6 : 0) tc rgb color(n)
}
unset multiplot
