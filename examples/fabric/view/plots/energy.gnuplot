# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
stats 'energy.csv' skip 1 using 2 nooutput
end = STATS_max
set output 'energy.png'
set xlabel 'time, s'
set ylabel 'change of total energy, mJ'
set title 'Energy without damping and drag: '.scene
set xrange [0 : end * 1.4]
set offsets 0, 0, graph 0.05, graph 0.1
plot for [n=1:4] 'energy.csv' skip 1 using 2:(strcol(1) eq word(integrators, n) ? $3 * 1e3 : NaN) \
        with lines lw 2 lc rgb color(n), \
    for [n=1:4] '' skip 1 using (strcol(1) eq word(integrators, n) && $2 == end ? $2 : NaN):($3 * 1e3):(say(word(integrators, n))) with labels left offset 1,(n == 1 ? -0.7 : n == 2 ? 0.4 : n == 3 ? -0.4 : 0.4) tc rgb color(n)
