/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
static double of_thread[8];
#pragma omp threadprivate(of_thread)
#define WEAK _Pragma("weak maybe_other")
WEAK
