/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/memory.h"

#include <stdlib.h>
#include <sys/resource.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

double memory_peak(void) {
    struct rusage used;
    getrusage(RUSAGE_SELF, &used); /* cannot fail with these arguments */
    return (double)used.ru_maxrss * 1024;
}

double memory_allocated(void) {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 all = mallinfo2();
    return (double)all.uordblks + (double)all.hblkhd;
#else
    return -1;
#endif
}
