# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Settings of all plots of a study. Labels are next to their lines, in the same colours.
set terminal pngcairo size 900,560 font 'sans,12'
set datafile separator ','
set datafile missing NaN
unset key
set grid lc rgb '#dddddd'
set border 3
set tics nomirror
set format '%g'
integrators = 'linear-euler euler bdf2 midpoint'
preconditioners = 'none jacobi block-jacobi gauss-seidel incomplete-cholesky direct'
precisions = 'double float mixed'
color(n) = word('#0072b2 #d55e00 #009e73 #aa3399 #996600 #000000', n)
say(k) = k eq 'linear-euler' ? 'linearised Euler' : k eq 'euler' ? "Euler, Newton's method" : k eq 'bdf2' ? 'BDF2' : k
nice = '(1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)'
is(k) = strcol(4) eq k
