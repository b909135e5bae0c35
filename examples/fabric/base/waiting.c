/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/waiting.h"

#include <stdlib.h>
#include <unistd.h>

void waiting_is_short(char **argv) {
#ifdef _OPENMP
    /* About 80 us, which is what waking a thread costs: neither choice wastes much more. */
    static const char spins[] = "4000";
    if (!getenv("OMP_WAIT_POLICY") && !getenv("GOMP_SPINCOUNT") &&
        setenv("GOMP_SPINCOUNT", spins, 1) == 0)
        execv("/proc/self/exe", argv);
#else
    (void)argv;
#endif
}
