# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
set terminal pngcairo size 1200,480 font 'sans,11'
set output 'sum.png'
set multiplot layout 1,2 title 'Orders of reduction, at 1, 2 and 3 threads: '.scene
row(n) = 6 - floor(n / 3)
line(n, k) = row(n) + 0.25 * (2 - k)
way(n) = strcol(1).', '.strcol(2).(strcol(3) eq 'plain' ? '' : ', '.strcol(3))
set yrange [0.4:6.6]
set lmargin at screen 0.26
set rmargin at screen 0.58
set xlabel 'CPU time of the run, s'
set logscale x
set offsets graph 0.1, graph 0.1, 0, 0
set xtics @nice
plot 'sum.csv' skip 1 using 6:(row($0)):ytic(way(0)) with points pt 0 lc rgb 'white', \
    '' skip 1 using 6:(line($0, $4)) with points pt 7 ps 1.5 lc rgb color(1), \
    '' skip 1 using 6:(line($0, $4)):4 with labels left offset 1,0
set lmargin at screen 0.64
set rmargin at screen 0.97
set format x '10^{%L}'
set xtics autofreq
set xlabel 'largest distance from the first, m (left: none)'
set ytics ('' 1, '' 2, '' 3, '' 4, '' 5, '' 6)
distance(d) = d > 1e-17 ? d : 1e-17
plot 'sum.csv' skip 1 using (distance($7)):(line($0, $4)) with points pt 7 ps 1.5 lc rgb color(2), \
    '' skip 1 using (distance($7)):(line($0, $4)):4 with labels left offset 1,0
unset multiplot
