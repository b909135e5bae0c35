/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/region.h"

#include "base/affinity.h"
#include "base/crew.h"
#include "base/pool.h"
#include "base/system.h"
#include "base/team.h"

#include <assert.h>
#include <limits.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Both GNU's and LLVM's OpenMP libraries export these functions. The references are weak, so that
 * programs without an OpenMP library link. */
#define WEAK __attribute__((__weak__))
extern void GOMP_parallel(void (*)(void *), void *, unsigned, unsigned) WEAK;
extern int omp_get_max_threads(void) WEAK;
extern int omp_get_num_threads(void) WEAK;
extern int omp_get_thread_num(void) WEAK;
extern int omp_in_parallel(void) WEAK;

bool redcc_region_is_own(void) {
    return !GOMP_parallel || !omp_get_max_threads || !omp_get_num_threads || !omp_get_thread_num ||
           !omp_in_parallel;
}

/* The number at the beginning of an environment variable such as OMP_NUM_THREADS. Returns
 * `otherwise` if there is no positive number, or in a setuid program. */
static int number_of(const char *variable, int otherwise) {
    const char *text = redcc_system_is_privileged() ? NULL : getenv(variable);
    char *end = NULL;
    const long value = text ? strtol(text, &end, 10) : 0;
    return value >= 1 && value <= INT_MAX && end != text ? (int)value : otherwise;
}

int redcc_region_threads(void) {
    const int crew = redcc_crew_threads();
    if (crew > 0)
        return crew;
    if (!redcc_region_is_own())
        return omp_get_max_threads();
    static atomic_int known; /* 0: not computed yet */
    int threads = atomic_load_explicit(&known, memory_order_relaxed);
    if (threads == 0) {
        const int most = number_of("OMP_THREAD_LIMIT", INT_MAX);
        threads = number_of("OMP_NUM_THREADS", redcc_processors_here());
        threads = threads < most ? threads : most;
        atomic_store_explicit(&known, threads, memory_order_relaxed);
    }
    return threads;
}

bool redcc_region_is_nested(void) {
    return redcc_within || (omp_in_parallel && omp_in_parallel() && redcc_crew_threads() == 0);
}

struct region {
    region_work *work;
    void *shared;
};

static void work_in_openmp(void *given) {
    const struct region *region = given;
    if (omp_get_thread_num() > 0)
        redcc_team_note_member();
    region->work(omp_get_thread_num(), omp_get_num_threads(), region->shared);
}

void redcc_region_run(int threads, region_work *work, void *shared) {
    assert(threads >= 1);
    const int crew = threads > 1 ? redcc_crew_threads() : 0;
    if (threads == 1)
        work(0, 1, shared);
    else if (crew > 0)
        redcc_crew_run(threads < crew ? threads : crew, work, shared);
    else if (redcc_region_is_own())
        redcc_pool_run(threads, work, shared);
    else
        GOMP_parallel(work_in_openmp, &(struct region){work, shared}, (unsigned)threads, 0);
}
