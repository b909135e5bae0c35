/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/waiting.h"

#include <stdlib.h>
#include <unistd.h>

void waiting_is_short(char **argv) {
#ifdef _OPENMP
    /* libgomp's own value when there are more threads than cores. */
    static const char spins[] = "1000";
    if (!getenv("OMP_WAIT_POLICY") && !getenv("GOMP_SPINCOUNT") &&
        setenv("GOMP_SPINCOUNT", spins, 1) == 0)
        execv("/proc/self/exe", argv);
#else
    (void)argv;
#endif
}
