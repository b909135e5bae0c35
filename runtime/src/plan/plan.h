/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A plan says which iterations each thread executes, and whether the thread writes to the arrays or
 * to copies. All addresses in it are relative to the arrays' first elements. So it is also valid
 * for other arrays, if the subscripts are the same.
 */
#ifndef REDCC_PLAN_H
#define REDCC_PLAN_H

#include "base/barrier.h"

#include "base/flags.h"
#include "ownership/partition.h"
#include "plan/copies.h"
#include "plan/method.h"
#include "plan/schedule.h"
#include <assert.h>

struct divide;
struct rounding;

/** Teams of threads, which synchronise after each stage. */
struct teams {
    int count;
    uint32_t *stages;        /* [count] number of stages of each team */
    struct barrier *barrier; /* [count] */
};

struct plan {
    const struct method *method;
    int parameter;
    int threads;
    struct teams teams;
    redcc_int trip;
    uint32_t array_count;
    uint32_t owners;
    uint32_t *group_of; /* [array_count] as in struct partition */
    ptrdiff_t *shift;   /* [array_count] distance in bytes from the base of the array's group to the
                           array's own base */
    struct offsets
        *touched; /* [array_count] the touched range of each group, relative to the group's base */
    /* [array_count * (owners + 1)] In group g, owner o has the bytes from bound[k] to before
     * bound[k + 1], relative to the group's base; k is g * (owners + 1) + o. Unused with a map */
    ptrdiff_t *bound;
    struct owner_map map;
    struct schedule
        *schedule; /* [schedules] one for each thread; with stealable blocks, one for each owner */
    uint32_t schedules;
    struct flags *flags; /* flags of tasks; NULL: there are none */
    unsigned round;      /* number of the execution: the value of a raised flag */
    /* [array_count] rounding errors of each group, for compensated sums; or NULL */
    struct rounding *rounding;
    struct copies copies;
    /* number of executed iterations; each counts once per thread that executes it */
    redcc_int executed;
    redcc_int length; /* the makespan, in iterations (length.h) */
};

/** The index of a thread's own schedule; its stealable schedules, if any, follow. */
static inline uint32_t redcc_own_schedule(const struct plan *plan, int thread) {
    assert(0 <= thread && thread < plan->threads);
    return (uint32_t)thread * (plan->method->steals ? 1 + REDCC_STEALABLE : 1);
}

/** The stealable schedule that is taken after `claimed` others; UINT32_MAX if all are taken. The
 * first stealable schedules of all threads, which are the largest, are taken before the second
 * ones. */
static inline uint32_t redcc_stealable_schedule(const struct plan *plan, uint32_t claimed) {
    const uint32_t threads = (uint32_t)plan->threads;
    if (claimed >= plan->schedules - threads)
        return UINT32_MAX;
    return redcc_own_schedule(plan, (int)(claimed % threads)) + 1 + claimed / threads;
}

/** The number of a team's first thread; the number of threads if `team` equals `teams`. */
static inline int redcc_team_first(int threads, int teams, int team) {
    assert(0 <= team && team <= teams && teams <= threads);
    return (int)((long)threads * team / teams);
}

/** The team to which a thread belongs. */
int redcc_team_of(int threads, int teams, int thread);

/** Makes an empty plan for `trip` iterations and the partition. touched[g] is the range in which
 * group g is touched. If `compensated` is set, the plan has storage for rounding errors. Returns
 * NULL if out of memory. */
struct plan *redcc_plan_new(const struct method *method, int parameter, int threads, redcc_int trip,
                            const struct partition *partition, const struct range *touched,
                            bool compensated);

/** Takes over the map of `divide`, which assigns an owner to each unit. False: out of memory. */
bool redcc_plan_take_map(struct plan *plan, const struct partition *partition,
                         struct divide *divide);

/** As redcc_plan_take_map, for the partition's map. Does nothing if the partition has no map, or if
 * the map cannot be extended to the touched ranges. */
void redcc_plan_take_votes(struct plan *plan, struct partition *partition,
                           const struct range *touched);

/** Called after an execution in which threads found their iterations themselves. Keeps the
 * partition, with the plan's map, for later executions. Does not keep it if arrays overlap, or if
 * the share of the most loaded thread has grown by more than a 16th. */
void redcc_plan_keep_owners(struct plan *plan, struct partition *partition);

/** Frees a plan; NULL does nothing. */
void redcc_plan_free(struct plan *plan);

/** Called once, when all threads' schedules are complete. Renumbers the stages without the empty
 * ones, adds up the executed iterations, and computes the makespan. */
void redcc_plan_finish(struct plan *plan);

/** The size of the plan in bytes, including copies. */
size_t redcc_plan_bytes(const struct plan *plan);

/** The largest number of stages of a team. */
uint32_t redcc_plan_stages(const struct plan *plan);

#endif
