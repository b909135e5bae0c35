# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
set terminal pngcairo size 900,760 font 'sans,11'
set output 'robustness.png'
set logscale xy
set palette defined (0 '#009e73', 1 '#e69f00', 2 '#d50000')
set cbrange [0:2]
unset colorbox
set multiplot layout 2,2 title 'What step and stiffness each survives: '.scene
set label 1 'finished' at screen 0.32, 0.955 tc rgb '#009e73'
set label 2 'steps halved' at screen 0.45, 0.955 tc rgb '#b87f00'
set label 3 'gave up' at screen 0.62, 0.955 tc rgb '#d50000'
set xlabel 'step, ms'
set ylabel 'stretch, N/m'
set format y '10^{%L}'
do for [k in integrators] { set title say(k) offset 0,-0.7
plot [0.5:200] [3:3e6] 'robustness.csv' skip 1 using (strcol(1) eq k ? $2 * 1e3 : NaN):3:4 with points pt 5 ps 3 palette }
unset multiplot
