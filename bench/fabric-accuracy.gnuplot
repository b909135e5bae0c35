# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Draws the opening figure of docs/accuracy.md from the saved table of bench/fabric-accuracy.sh: error against CPU
# time, without contact and with it. gnuplot -e "table = 'CSV'; picture = 'PNG'" bench/fabric-accuracy.gnuplot
set terminal pngcairo size 1200,560 font 'sans,13'
set output picture
set datafile separator ','
set datafile missing NaN
unset key
set border 3
set tics nomirror
set grid lc rgb '#dddddd'
set logscale xy
set format '%g'
set xtics (0.05, 0.1, 0.2, 0.5, 1, 2)
set xrange [0.04:2.2]
set yrange [0.03:40]
set xlabel 'CPU time of the run, s'
integrators = 'linear-euler euler bdf2 midpoint'
names = '"linearised Euler" "Euler, Newton''s method" BDF2 midpoint'
color(n) = word('#0072b2 #d55e00 #009e73 #aa3399', n)
scenes = 'flap hanging'
titles = '"without contact: flap, 2602 vertices" "with contact: hanging, and a cylinder that pushes it"'
set multiplot layout 1,2 title 'What accuracy costs in time (grey: the front; square: as the scene is)'
do for [p = 1:2] {
  of = word(scenes, p)
  set title word(titles, p)
  set ylabel (p == 1 ? 'error at the end, mm (root mean square)' : '')
  is(k) = strcol(2) eq of && strcol(4) eq k
  last(n) = $7 == (n <= 2 ? 8 : 64)
  plot table skip 1 using (strcol(2) eq of && $15 == 1 ? $11 : NaN):($12 * 1e3) smooth unique \
         with lines lw 12 lc rgb '#cccccc', \
       for [n = 1:4] '' skip 1 using (is(word(integrators, n)) ? $11 : NaN):($12 * 1e3) \
         with linespoints lw 2 pt 7 lc rgb color(n), \
       for [n = 1:4] '' skip 1 using (is(word(integrators, n)) && $7 == (n <= 2 ? 8 : 64) ? $11 : NaN) \
         :($12 * 1e3):(word(names, n)) with labels left \
         offset (n == 1 ? (p == 1 ? 0.8 : -1) : 0.8),(n == 1 ? (p == 1 ? 0.6 : -1.2) : n == 2 ? 0.8 : n == 3 ? (p == 1 ? 0.5 : -0.9) : -0.3) \
         tc rgb color(n), \
       '' skip 1 using (is('default') ? $11 : NaN):($12 * 1e3) with points pt 4 ps 2.5 lw 2 lc 'black'
}
unset multiplot
