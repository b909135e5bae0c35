# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
table = 'preconditioner'
names = preconditioners
heading = 'Preconditioners'
load plots.'against-time.gnuplot'
