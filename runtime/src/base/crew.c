/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/crew.h"

#include "base/memory.h"
#include "base/team.h"
#include "base/wait.h"

#include <assert.h>
#include <stdatomic.h>

enum { LINE = 64 };

struct redcc_crew {
    int threads;
    int level; /* nesting level of the crew's region */
    /* the crew that the first thread leads in the enclosing region; NULL: it leads none there */
    struct redcc_crew *outer;
    atomic_int users; /* number of threads that may still read this memory */
    /* The current task is a region that the first thread opens: */
    region_work *work; /* NULL: the loop has ended */
    void *shared;
    int threads_at_work;
    atomic_uint tasks;               /* number of tasks so far */
    atomic_int idle;                 /* number of threads that sleep until the next task */
    _Alignas(LINE) atomic_uint left; /* number of threads that have not finished the task */
    atomic_int asleep;
};

static _Thread_local struct redcc_crew *crew __attribute__((__tls_model__("initial-exec")));

#define WEAK __attribute__((__weak__))
extern int omp_get_level(void) WEAK;
extern int omp_get_num_threads(void) WEAK;
extern int omp_get_thread_num(void) WEAK;

redcc_crew *redcc_crew_new(void) {
    if (redcc_region_is_own() || !omp_get_level)
        return NULL;
    redcc_memory_exempt(true); /* the memory limit must not prevent a crew: without one the loop may
                                  give other bits */
    struct redcc_crew *it = redcc_memory_alloc_zeroed(1, sizeof *it);
    redcc_memory_exempt(false);
    if (!it)
        return NULL;
    it->threads = omp_get_num_threads();
    it->level = omp_get_level();
    atomic_store(&it->users, it->threads);
    return it;
}

static void leave(struct redcc_crew *it) {
    if (atomic_fetch_sub(&it->users, 1) == 1)
        redcc_memory_free(it);
}

static void begin(struct redcc_crew *it, int threads, region_work *work, void *shared) {
    it->work = work;
    it->shared = shared;
    it->threads_at_work = threads;
    atomic_store(&it->left, (unsigned)it->threads - 1);
    atomic_fetch_add(&it->tasks, 1);
    redcc_wake(&it->tasks, &it->idle);
}

static void arrive(struct redcc_crew *it) {
    if (atomic_fetch_sub(&it->left, 1) == 1)
        redcc_wake(&it->left, &it->asleep);
}

void redcc_crew_arrive(void) {
    if (omp_get_thread_num && omp_get_thread_num() > 0)
        redcc_team_note_member();
}

int redcc_crew_help(redcc_crew *it) {
    const int number = omp_get_thread_num();
    if (number == 0) {
        if (it->threads > 1) {
            it->outer = crew;
            crew = it;
        }
        return 0;
    }
    redcc_crew_arrive();
    for (unsigned seen = 0;; seen++) {
        redcc_wait_while(&it->tasks, seen, &it->idle, it->threads);
        if (!it->work)
            break;
        if (number < it->threads_at_work)
            it->work(number, it->threads_at_work, it->shared);
        arrive(it);
    }
    leave(it);
    return 1;
}

void redcc_crew_end(redcc_crew *it) {
    if (it->threads > 1) {
        assert(crew == it);
        crew = it->outer;
        begin(it, 0, NULL, NULL);
    }
    leave(it);
}

int redcc_crew_threads(void) {
    return crew && omp_get_level() == crew->level ? crew->threads : 0;
}

void redcc_crew_run(int threads, region_work *work, void *shared) {
    struct redcc_crew *const it = crew;
    assert(it && threads > 1 && threads <= it->threads && atomic_load(&it->left) == 0);
    begin(it, threads, work, shared);
    work(0, threads, shared);
    for (unsigned left; (left = atomic_load(&it->left)) > 0;)
        redcc_wait_while(&it->left, left, &it->asleep, it->threads);
}
