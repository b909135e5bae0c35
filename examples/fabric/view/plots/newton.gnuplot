# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
set logscale xy
set output 'newton.png'
set yrange [*:100]
set format xy '10^{%L}'
set title "Error of Newton's method alone (solid), and of the whole (dashed): ".scene
set xlabel "tolerance of Newton's method"
set ylabel 'error at the end, mm (root mean square)'
set xrange [0.3 : 2e-9]
plot for [n=2:4] 'newton.csv' skip 1 using 6:(is(word(integrators, n)) && $14 > 0 ? $14 * 1e3 : NaN) \
        with linespoints lw 2 pt 7 lc rgb color(n), \
    for [n=2:4] '' skip 1 using 6:(is(word(integrators, n)) && $14 > 0 ? $12 * 1e3 : NaN) \
        with linespoints lw 2 dt 2 pt 6 lc rgb color(n), \
    for [n=2:4] '' skip 1 using ($6 == 1e-6 ? $6 : NaN):(is(word(integrators, n)) ? $12 * 1e3 : NaN):(say(word(integrators, n))) with labels center offset 0,(n == 4 ? -0.9 : 0.7) tc rgb color(n)
