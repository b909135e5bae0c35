# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
stats 'cg.csv' skip 1 every ::0::0 using ($12 * 1e3) nooutput
floor = STATS_min
stats 'cg.csv' skip 2 using ($14 * 1e3 < 0.1 * floor ? $6 : NaN) nooutput
worth = STATS_max
set terminal pngcairo size 900,760 font 'sans,12'
set output 'cg.png'
set logscale xy
set multiplot layout 2,1 title 'What the tolerance of the linear systems costs and buys: '.scene
set xrange [0.2 : 5e-9]
set ytics @nice
set lmargin 11
set format x '10^{%L}'
set object 1 rectangle from worth, graph 0 to 5e-9, graph 1 behind fc rgb '#eeeeee' fs noborder
set label 1 'wasted: the algebra is below a tenth of the error of the step' at 6e-9, graph 0.08 right tc rgb '#777777'
set ylabel 'CPU time of the run, s'
plot 'cg.csv' skip 2 using 6:11 with linespoints lw 2 pt 7 lc rgb color(1)
unset label 1
unset object 1
set object 2 rectangle from graph 0, graph 0 to graph 1, first floor behind fc rgb '#eeeeee' fs noborder
set label 2 sprintf('the error of the step, %.3g mm: no tolerance gets below', floor) at 6e-9, floor right offset 0,-0.9 tc rgb '#777777'
set xlabel 'tolerance'
set ytics autofreq
set ylabel 'error at the end, mm (root mean square)'
plot 'cg.csv' skip 2 using 6:($12 * 1e3) with linespoints lw 2 pt 7 lc rgb color(1), \
    '' skip 2 using 6:($14 * 1e3) with linespoints lw 2 pt 7 lc rgb color(2), \
    '' skip 2 using ($6 == 1e-2 ? $6 : NaN):($12 * 1e3):('of the whole') with labels left offset 1,0.9 tc rgb color(1), \
    '' skip 2 using ($6 == 1e-4 ? $6 : NaN):($14 * 1e3):('of the algebra alone') \
        with labels left offset 2,0.5 tc rgb color(2)
unset multiplot
