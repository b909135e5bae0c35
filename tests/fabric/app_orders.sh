#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# fabric accuracy sum on the parallel program: every order by a method of its own, the serial order
# with the sequential loops' bits, the fixed order with the same bits at any thread count.
# Arguments: PARALLEL SCENES FOLDER.
export OMP_WAIT_POLICY=passive
export TSAN_OPTIONS=ignore_noninstrumented_modules=1
source "$(dirname "$0")/app_common.sh"

expect 0 "tables and plots are in sum" "$program" accuracy sum -o sum --quick --most-steps 16
rows() { awk -F, -v o="$1" -v m="$2" '$1 == o && $2 == m {print $5}' sum/sum.csv | sort -u; }
holds "five ways at three thread counts" test "$(wc -l <sum/sum.csv)" -eq 16
holds "localwrite gives the sequential bits" test "$(rows serial localwrite)" = 0
holds "the fixed order does not see the threads" test "$(rows fixed expansion-fixed | wc -l)" -eq 1
holds "any order is the same cloth" awk -F, 'NR > 1 && $5 > 1e-9 {exit 1}' sum/sum.csv
finish
