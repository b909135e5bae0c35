# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
set terminal pngcairo size 1200,480 font 'sans,11'
set logscale x
set output 'mesh.png'
stats 'mesh.csv' skip 1 using 1 nooutput
set xrange [STATS_min / 1.5 : STATS_max * 1.5]
set multiplot layout 1,2 title 'Finer meshes: '.scene
set xlabel 'vertices'
set offsets 0, 0, graph 0.1, graph 0.1
set ylabel 'lowest point at the end, mm'
plot 'mesh.csv' skip 1 using 1:($5 * 1e3):xtic(1) with linespoints lw 2 pt 7 lc rgb color(1)
set logscale y
set ylabel 'CPU time of the run, s'
plot 'mesh.csv' skip 1 using 1:4:xtic(1) with linespoints lw 2 pt 7 lc rgb color(2)
unset multiplot
