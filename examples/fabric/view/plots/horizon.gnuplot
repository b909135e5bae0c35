# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
stats 'horizon.csv' skip 1 using 1 nooutput
end = STATS_max
set output 'horizon.png'
set logscale y
set format y '10^{%L}'
set title 'Where chaos ends what accuracy buys: '.scene
set xlabel 'time, s'
set ylabel 'distance from the run that was not moved, mm'
set xrange [0 : end]
set yrange [* : 1e3]
set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead dt 2 lc 'black'
set label 1 '1 mm' at graph 0.99, first 1 right offset 0,0.7
set label 2 'each of 16 runs whose starts are 1e-6 mm apart' at graph 0.98, graph 0.08 right tc rgb '#777777'
set label 3 'mean of all' at graph 0.98, graph 0.15 right tc rgb color(2)
plot for [r=1:16] 'horizon.csv' skip 1 every 17::r using ($3 > 0 ? $1 : NaN):($3 * 1e3) with lines lc rgb '#bbbbbb', \
    '' skip 1 using ($2 > 0 && $3 > 0 ? $1 : NaN):($3 * 1e3) smooth unique with lines lw 4 lc rgb color(2)
