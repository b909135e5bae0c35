/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Detects processes that were created by fork. In such a process a parallel region may wait for
 * threads that do not exist. */
#ifndef REDCC_FORKED_H
#define REDCC_FORKED_H

#include <stdatomic.h>
#include <stdbool.h>

/** Did an ancestor of the process have several threads when it forked? A child has only the thread
 * that forked, but GCC's OpenMP would wait for the others. After _Fork or clone, which call no fork
 * handlers, always true. (A child of vfork shares its parent's memory and is not detected; it may
 * only call exec or _exit.) Must be called before the runtime's memory is used. Thread-safe. */
static inline bool redcc_is_forked(void);

/** Returns a page of zeros that the system clears in a child process. NULL: the system does not
 * support this. */
void *redcc_wiped_page(void);

/* The first byte of a page from redcc_wiped_page: 1 in a process that redcc_note_process has
 * registered; 0 in a new process, because the system has cleared it. NULL: not supported. */
extern atomic_char *redcc_process_mark;
extern atomic_bool redcc_had_threads;

/** Registers the current process if it is new. */
void redcc_note_process(void);

static inline bool redcc_is_forked(void) {
    const atomic_char *mark = redcc_process_mark;
    if (!mark || atomic_load_explicit(mark, memory_order_relaxed) == 0)
        redcc_note_process();
    return atomic_load_explicit(&redcc_had_threads, memory_order_relaxed);
}

#endif
