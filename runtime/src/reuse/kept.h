/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Kept plans: a loop keeps its last few plans, each with a record of the call for which it was
 * built. A later call reuses one if the record matches, the overlap guard holds at the arrays'
 * current addresses, and the subscripts' fingerprints are unchanged.
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

/** The record of a source. */
struct source_record {
    bool known;            /* each call gives the source's range */
    bool anchored;         /* known[].first is an address to which `extent` is relative */
    struct offsets extent; /* if known: {0, its length} */
    struct fingerprint fingerprint;
    uint64_t sampled; /* hash of a few of its words */
    struct tracking tracking;
};

struct kept_plan {
    struct plan *plan;
    redcc_word *key;                    /* [key_count] */
    struct float_control float_control; /* of the thread that entered, because subscripts may depend
                                         * on the rounding mode */
    struct source_record *source;       /* [source_count] */
    uint64_t sampled;                   /* the value of reuse->sampled at its construction */
    uint64_t last_use;
    bool stale; /* the subscripts were found changed, and the plan was not used since */
};

/** A loop's plans. */
struct plan_cache {
    struct kept_plan *kept[REDCC_PLANS]; /* NULL: a free slot */
    uint64_t clock;
    struct back_off back_off; /* back-off after write tracking that did not pay (tracking.c) */
};

/** One call's search for a plan; shared by all threads. */
struct reuse {
    struct plan_cache *cache;
    const struct call *call;
    struct hasher *const *hasher; /* [threads] */
    struct barrier *barrier;
    struct kept_plan *found; /* the candidate, or the plan in use; NULL: none */
    struct range *sources;   /* [source_count] the sources' ranges in this call */
    struct range *written;   /* [array_count] ranges that the plan's groups would write now */
    long skipped_calls;      /* calls before this one that auto executed sequentially */
    double earned;           /* seconds that auto has saved by the plan, minus its construction */
    uint64_t sampled;        /* a hash of a few words of the subscripts; 0: not sampled */
    bool same;               /* so far the subscripts are unchanged */
    int changed_source;      /* the source whose change invalidated a plan in this call; -1: none */
};

/** A hash of some words of each subscript whose range the call gives, for reuse->sampled; 0: the
 * call gives no range. */
uint64_t redcc_reuse_sample(const redcc_loop *loop, const redcc_extent *known);

/** Hashes all subscripts; false if the range of one is unknown, or if the time limit in seconds is
 *  exceeded. */
bool redcc_reuse_fingerprint(const redcc_loop *loop, const redcc_extent *known, double seconds,
                             struct fingerprint *all);

/** Searches for a plan of this strategy (SEQUENTIAL: of any) for the call and number of threads.
 *  Compares everything except the subscripts' contents, which are only sampled, and checks the
 *  overlap guard. Queries write tracking. Sets reuse->found and reuse->sources. */
void redcc_reuse_find(struct reuse *reuse, int threads, enum way way);

/** Sets a bit for each strategy: in *fits if redcc_reuse_find would find a plan of it, in *changed
 * if only the sample rules its plan out. If no plan fits, and the sample now rules out the one used
 * last, sets reuse->changed_source. */
void redcc_reuse_survey(struct reuse *reuse, int threads, unsigned *fits, unsigned *changed);

/** Are the subscripts of the plan found unchanged? Every thread calls it with its hasher and gets
 *  the same answer. If not, sets reuse->changed_source. */
bool redcc_reuse_verify(struct reuse *reuse, struct hasher *hasher);

/** Frees the plan found, because its subscripts have changed or memory may have several
 * addresses. */
void redcc_reuse_drop_found(struct reuse *reuse);

/** The number of sources of the plan found that were not read in this call. */
uint32_t redcc_reuse_skipped_sources(const struct reuse *reuse);

/** Is a plan for this call worth keeping, because a later call could verify it? sources
 * [source_count] are the ranges read. */
bool redcc_is_reusable(const struct request *request, const struct range *sources);

/** Takes ownership of `plan` and records the call, with the hashers' fingerprints. Replaces the
 *  least recently used plan in the cache. False: out of memory, and the caller still owns the plan.
 */
bool redcc_reuse_keep(struct reuse *reuse, struct plan *plan);

/** Frees all plans to make memory available for another. */
void redcc_cache_drop_all(struct plan_cache *cache);

#endif
