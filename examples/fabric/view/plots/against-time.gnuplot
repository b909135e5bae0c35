# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Plots the error of the linear algebra against time, from `table`, with a line for each value in `names` of the
# fourth column.
hue(k) = strstrt(names, k) ? color(words(names[1:strstrt(names, k)])) : color(1)
stats table.'.csv' skip 2 using 11 nooutput
fast = STATS_min
slow = STATS_max
set logscale xy
set output table.'.png'
set title heading.', to 1e-2, 1e-4, 1e-6, 1e-8: '.scene
set xlabel 'CPU time of the run, s'
set xtics @nice
set ylabel 'error of the algebra alone, mm (root mean square)'
set format y '10^{%L}'
set xrange [fast / 1.5 : slow * 2]
stats table.'.csv' skip 2 using ($6 > 0 ? $6 : NaN) nooutput
finest = STATS_min
stats table.'.csv' skip 2 using ($14 > 0 ? $14 * 1e3 : NaN) nooutput
set yrange [STATS_min / 10 : STATS_max * 10]
at(k) = k eq 'gauss-seidel' ? 1e-4 : strstrt('none double float', k) ? 1e-6 : 1e-8
named(k) = is(k) && $6 == (at(k) < finest ? finest : at(k))
plot for [k in names] table.'.csv' skip 2 using 11:(is(k) ? $14 * 1e3 : NaN) with linespoints lw 2 pt 7 lc rgb hue(k), \
    for [k in 'none jacobi double'] '' skip 2 using (named(k) ? $11 : NaN):($14 * 1e3):(k) \
        with labels left offset 1,(k eq 'jacobi' ? -0.9 : 0.4) tc rgb hue(k), \
    for [k in 'gauss-seidel float mixed'] '' skip 2 using (named(k) ? $11 : NaN):($14 * 1e3):(k) \
        with labels right offset -0.7,-0.7 tc rgb hue(k), \
    for [k in 'block-jacobi incomplete-cholesky'] '' skip 2 using (named(k) ? $11 : NaN):($14 * 1e3):(k) \
        with labels center offset (k eq 'block-jacobi' ? 3 : 0),(k eq 'block-jacobi' ? -2.2 : -0.9) tc rgb hue(k), \
    '' skip 2 using (is('direct') ? $11 : NaN):($14 * 1e3):('direct') with labels left offset 1,0
