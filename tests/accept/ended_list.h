/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A list whose end an element tells, for tests of loops without a bound. Nothing after its end can be read. */
#ifndef ENDED_LIST_H
#define ENDED_LIST_H

#include <sys/mman.h>
#include <unistd.h>

#include "case.h"

enum { ENDED_MOST = 3000 };

/* Returns a list of `count` elements in 0 ... below - 1, and -1 after them. This end is the last element before a page
 * that cannot be read. */
static inline int *ended_list(int count, int below) {
    static char *memory;
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    const size_t bytes = ((ENDED_MOST + 1) * sizeof(int) / page + 1) * page;
    if (!memory) {
        memory = mmap(NULL, bytes + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        mprotect(memory + bytes, page, PROT_NONE);
    }
    int *list = (int *)(void *)(memory + bytes) - count - 1;
    for (int i = 0; i < count; i++)
        list[i] = case_below(below);
    list[count] = -1;
    return list;
}

#endif
