/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Processes made by fork, in which a parallel region may wait for threads that are not there. */
#ifndef REDCC_FORKED_H
#define REDCC_FORKED_H

#include <stdatomic.h>
#include <stdbool.h>

/** Had the process, or one it descends from, several threads when it forked? Only the one that
 * forked is in the child, while GCC's OpenMP goes on waiting for the others. Of a process made by
 * _Fork or clone, which tell nobody, threads are assumed. (A child that shares its parent's memory,
 * as vfork's, is not told apart: it may do nothing but execute another program.) To be asked before
 * the runtime's memory is used. Any thread may ask. */
static inline bool redcc_is_forked(void);

/** A page of memory, zero, that the system makes zero again in a child; NULL: it cannot. */
void *redcc_wiped_page(void);

/* Its first byte is 1 in the process that has been seen, and 0 in a new one; NULL: it cannot be
 * told so. */
extern atomic_char *redcc_process_mark;
extern atomic_bool redcc_had_threads;

/** Sees to it that the process is one that has been seen. */
void redcc_see_process(void);

static inline bool redcc_is_forked(void) {
    const atomic_char *mark = redcc_process_mark;
    if (!mark || atomic_load_explicit(mark, memory_order_relaxed) == 0)
        redcc_see_process();
    return atomic_load_explicit(&redcc_had_threads, memory_order_relaxed);
}

#endif
