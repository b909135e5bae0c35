# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
table = 'precision'
names = precisions
heading = 'Precision of the solver'
load plots.'against-time.gnuplot'
