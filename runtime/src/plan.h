/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A plan: who executes which iterations of a loop, and where they write. All places in it are
 * relative to the arrays' first elements, so that it holds for other arrays at the same subscripts.
 */
#ifndef REDCC_PLAN_H
#define REDCC_PLAN_H

#include "barrier.h"
#include "copies.h"
#include "fingerprint.h"
#include "flags.h"
#include "float_control.h"
#include "method.h"
#include "schedule.h"
#include "vouch.h"

struct divide;
struct lost;

/** What one call brings; the pointers are owned by the loop's state. */
struct request {
    const redcc_loop *loop;
    redcc_int trip;
    void **bases;                       /* [array_count] */
    redcc_extent *known;                /* [source_count] */
    redcc_word *key;                    /* [key_count] */
    struct float_control float_control; /* of the thread that entered: subscripts may be rounded */
};

/** What a plan remembers of a source. */
struct source_record {
    bool known;            /* its extent comes with each call */
    bool anchored;         /* known[].first is there to move with */
    struct offsets extent; /* known: {0, its length}; else relative to the anchor */
    struct fingerprint fingerprint;
    struct vouch vouch;
};

/** Where the owners of a group's units stand in a plan's map. */
struct group_map {
    ptrdiff_t first; /* of the units, relative to the group's base */
    uint32_t begin;  /* in the map */
    uint32_t count;  /* of units */
    uint32_t bytes;  /* of a unit */
};

struct plan {
    const struct method *method;
    int parameter;
    int threads;
    int teams;
    redcc_int trip;
    uint32_t array_count;
    uint32_t source_count;
    uint32_t owners;
    redcc_word *key;                    /* [key_count] */
    struct float_control float_control; /* as the request's */
    uint32_t *group_of;                 /* [array_count] as partition.group_of */
    ptrdiff_t *shift;                   /* [array_count] bytes from its group's base to its own */
    struct offsets *touched;            /* [array_count] of each group, relative to its base */
    ptrdiff_t *bound;             /* [array_count * (owners + 1)] owner o of group g writes from
                                     bound[g * (owners + 1) + o] up to the next, relative to its base;
                                     not where there is a map */
    unsigned char *map;           /* the owner of each unit of all groups; NULL: none */
    struct group_map *mapped;     /* [array_count] of each group; with the map */
    struct source_record *source; /* [source_count] */
    struct schedule *schedule;    /* [schedules] of each thread; with spares of each owner */
    uint32_t schedules;
    uint32_t *stages;             /* [teams] */
    struct barrier *team_barrier; /* [teams] */
    struct flags *flags;          /* of tasks; NULL: there are none */
    unsigned round;               /* of this execution: what a flag that is up holds */
    struct lost *lost;            /* [array_count] of each group, of compensated sums; or NULL */
    struct copies copies;
    redcc_int executed; /* iterations, replicated ones counted */
    redcc_int length;   /* how long its threads take, in iterations (length.h) */
    uint64_t last_use;
};

/** The schedule that a thread begins with; the spare ones behind it, where there are any, it fills
 *  as well. */
static inline uint32_t redcc_own_schedule(const struct plan *plan, int thread) {
    return (uint32_t)thread * (plan->method->spares ? 1 + REDCC_SPARES : 1);
}

/** The spare schedule that is claimed after `claimed` others: of all threads the first, which are
 *  the largest, then the second. UINT32_MAX: they are all claimed. */
static inline uint32_t redcc_spare_schedule(const struct plan *plan, uint32_t claimed) {
    const uint32_t threads = (uint32_t)plan->threads;
    if (claimed >= plan->schedules - threads)
        return UINT32_MAX;
    return redcc_own_schedule(plan, (int)(claimed % threads)) + 1 + claimed / threads;
}

/** The first thread of a team; team == teams: the number of threads. */
static inline int redcc_team_first(int threads, int teams, int team) {
    return (int)((long)threads * team / teams);
}

/** The team of a thread. */
int redcc_team_of(int threads, int teams, int thread);

/** An empty plan for what the partition says, group g being touched in touched[g] and source s
 *  read in sources[s]. NULL: no memory. */
struct plan *redcc_plan_new(const struct method *method, int parameter, int threads,
                            const struct request *request, const struct partition *partition,
                            const struct range *touched, const struct range *sources);

/** From now on the owners are those of units, as they were divided; the map in `divide` becomes the
 *  plan's. False: no memory. */
bool redcc_plan_take_map(struct plan *plan, const struct partition *partition,
                         struct divide *divide);

/** Gives back a plan; NULL does nothing. */
void redcc_plan_free(struct plan *plan);

/** To be called once when all threads' schedules are there: numbers the stages that are not empty
 *  and adds up what is executed. */
void redcc_plan_finish(struct plan *plan);

/** May this plan serve this request, if its subscripts are what they were? Everything is compared
 *  but the subscripts' contents, and the guard is asked at the places where the arrays now are.
 *  Sets sources [source_count] to where the sources are. */
bool redcc_plan_fits(const struct plan *plan, const struct request *request, int threads,
                     struct range *sources);

/** May a plan for this request be kept for other calls at all? sources [source_count] is what is
 *  read. */
bool redcc_plan_reusable(const struct request *request, const struct range *sources);

/** Bytes it takes, copies included. */
size_t redcc_plan_bytes(const struct plan *plan);

/** The most stages that a team goes through. */
uint32_t redcc_plan_stages(const struct plan *plan);

#endif
