/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/affinity.h"

#if defined(__linux__)

#include "base/system.h"

int redcc_processors_here(void) {
    enum {
        WORDS = 8192 / (8 * sizeof(unsigned long))
    }; /* Linux supports at most 8192 processors */
    unsigned long word[WORDS] = {0};
    const long bytes = redcc_system(SYS_sched_getaffinity, 0, sizeof word, word);
    int count = 0;
    for (long at = 0; at < bytes / (long)sizeof *word; at++)
        count += __builtin_popcountl(word[at]);
    return count > 0 ? count : 1;
}

#else

#include <unistd.h>

int redcc_processors_here(void) {
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count > 0 ? (int)count : 1;
}

#endif
