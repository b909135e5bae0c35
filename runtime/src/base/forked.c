/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Detects forked processes. pthread_atfork handlers detect fork. _Fork and clone do not call these
 * handlers; their children are detected by a page that the system clears in a child.
 */
#define _GNU_SOURCE /* for struct statx and MADV_WIPEONFORK */
#include "base/forked.h"

#include "base/memory.h"
#include "base/system.h"
#include "base/team.h"

#include <fcntl.h>
#include <stdatomic.h>
#include <sys/mman.h>
#include <sys/stat.h>

/* did the process have several threads just before fork? read by the child */
static bool had_threads;
atomic_bool redcc_had_threads; /* written while there is only one thread */
atomic_char *redcc_process_mark;
static long process; /* if there is no such page: the id of the process registered last */

#if defined(__linux__)

/* Does the process have several threads? Its task directory has one subdirectory per thread. The
 * number of the directory's links is 2 plus the number of subdirectories. Also true if there is no
 * /proc. */
static bool has_threads(void) {
    struct statx tasks;
    return redcc_system(SYS_statx, AT_FDCWD, "/proc/self/task", 0, STATX_NLINK, &tasks) != 0 ||
           tasks.stx_nlink > 3;
}

void *redcc_wiped_page(void) {
    const size_t bytes = redcc_page_size();
    void *page = redcc_system_map(bytes);
    if (page && redcc_system(SYS_madvise, page, bytes, MADV_WIPEONFORK) != 0) {
        redcc_system_unmap(page, bytes);
        return NULL;
    }
    return page;
}

#else

static bool has_threads(void) {
    return true;
}

void *redcc_wiped_page(void) {
    return NULL;
}

#endif

/* Registers the calling process, which is new. */
static void begin_process(bool with_threads) {
    if (with_threads)
        atomic_store(&redcc_had_threads, true);
    redcc_memory_forked();
    redcc_team_forked();
    if (redcc_process_mark)
        atomic_store(redcc_process_mark, 1);
    process = redcc_process_mark ? 0 : redcc_system_process();
}

static void before(void) {
    had_threads = has_threads();
}

static void in_child(void) {
    begin_process(had_threads);
}

#if defined(__GLIBC__)
/* The function that glibc's pthread_atfork calls. Its name is reserved, so the program cannot
 * define it. */
extern int __register_atfork(void (*)(void), void (*)(void), void (*)(void), void *);
extern void *__dso_handle __attribute__((__visibility__("hidden")));

static bool register_handlers(void) {
    return __register_atfork(before, NULL, in_child, &__dso_handle) == 0;
}
#else
#include <pthread.h>

static bool register_handlers(void) {
    return pthread_atfork(before, NULL, in_child) == 0;
}
#endif

/* Registers the handlers at program start, because the program may open parallel regions of its own
 * before its first loop. */
__attribute__((constructor)) static void watch(void) {
    redcc_process_mark = redcc_wiped_page();
    begin_process(!register_handlers());
}

/* If the process is new although no handler has run, the number of threads that its parent had at
 * the fork is unknown. */
void redcc_note_process(void) {
    if (redcc_process_mark ? atomic_load(redcc_process_mark) == 0
                           : redcc_system_process() != process)
        begin_process(true);
}
