/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Kept plans: a loop keeps its last few plans, each with what is remembered of the call that it was
 * made for. A call uses one again where all of that fits, the overlap guard holds at the places
 * where the arrays are now, and the subscripts' fingerprints are what they were.
 */
#ifndef REDCC_KEPT_H
#define REDCC_KEPT_H

#include "base/barrier.h"
#include "base/call.h"
#include "base/way.h"
#include "plan/plan.h"
#include "reuse/hashing.h"
#include "reuse/tracking.h"

enum { REDCC_PLANS = 4 };

/** What is remembered of a source. */
struct source_record {
    bool known;            /* its extent comes with each call */
    bool anchored;         /* known[].first is there to move with */
    struct offsets extent; /* known: {0, its length}; else relative to the anchor */
    struct fingerprint fingerprint;
    uint64_t sampled; /* a hash of a few of its words */
    struct tracking tracking;
};

struct kept_plan {
    struct plan *plan;
    redcc_word *key;                    /* [key_count] */
    struct float_control float_control; /* of the thread that entered: subscripts may be rounded */
    struct source_record *source;       /* [source_count] */
    uint64_t sampled;                   /* of its subscripts, as reuse->sampled */
    uint64_t last_use;
    bool lost; /* found changed, and not used since */
};

/** A loop's plans. */
struct plan_cache {
    struct kept_plan *kept[REDCC_PLANS]; /* NULL: a free place */
    uint64_t clock;
    struct back_off rest; /* of tracking that did not pay (tracking.c) */
};

/** One call's search for a plan; what all threads share. */
struct reuse {
    struct plan_cache *cache;
    const struct call *call;
    struct hasher *const *hasher; /* [threads] */
    struct barrier *barrier;
    struct kept_plan *found; /* the one that may serve, or serves; NULL: none */
    struct range *sources;   /* [source_count] where they lie in this call */
    struct range *written;   /* [array_count] what its groups would write in this call */
    long skipped_calls;      /* that auto left to the sequential loop before this one */
    double earned;           /* seconds that auto has saved by the plan, less its set-up */
    uint64_t sampled;        /* a hash of a few words of the subscripts; 0: none is taken */
    bool same;               /* so far the subscripts are unchanged */
    int changed_source;      /* that a plan was lost by, in this call; -1: none was */
};

/** A hash of some words of each of the subscripts that are where the call says, reuse->sampled; 0:
 * there are none such. */
uint64_t redcc_reuse_sample(const redcc_loop *loop, const redcc_extent *known);

/** Of all subscripts, as far as it is known where they lie; false: of some array nothing is, or it
 *  takes longer than so many seconds. */
bool redcc_reuse_fingerprint(const redcc_loop *loop, const redcc_extent *known, double seconds,
                             struct fingerprint *all);

/** Looks for a plan of that way (SEQUENTIAL: of any) that may serve the call by so many threads, if
 *  its subscripts are what they were: everything is compared but these, of which only the sample
 * is, and the guard is asked. Asks which of its subscripts the system shows to be unmodified. Sets
 *  reuse->found and reuse->sources. */
void redcc_reuse_find(struct reuse *reuse, int threads, enum way way);

/** Of which ways there are plans that redcc_reuse_find would find: as bits, into *fits; and such
 *  that only the sample forbids, into *changed. Where no plan is left so for the first time, sets
 *  reuse->changed_source. */
void redcc_reuse_survey(struct reuse *reuse, int threads, unsigned *fits, unsigned *changed);

/** Are the subscripts of the plan found what they were? Every thread calls it with its hasher and
 *  gets the same answer. If not, sets reuse->changed_source. */
bool redcc_reuse_verify(struct reuse *reuse, struct hasher *hasher);

/** Frees the plan found: its subscripts have changed. */
void redcc_reuse_drop_found(struct reuse *reuse);

/** How many sources of the plan found were not read in this call. */
uint32_t redcc_reuse_skipped_sources(const struct reuse *reuse);

/** May a plan for this call be kept for others at all? sources [source_count] is what is read. */
bool redcc_is_reusable(const struct request *request, const struct range *sources);

/** Owns `plan`, and remembers the call; the fingerprints are those that the hashers have. Takes the
 *  least recently used place in the cache. False: no memory, and the plan is the caller's. */
bool redcc_reuse_keep(struct reuse *reuse, struct plan *plan);

/** Frees all plans, so that there is memory for another. */
void redcc_cache_drop_all(struct plan_cache *cache);

#endif
