/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Kept plans: a loop keeps its last few plans, each with a record of the call for which the plan
 * was built. A later call reuses a plan if three conditions hold. The record matches the call, the
 * overlap guard finds no overlap at the arrays' current addresses, and the subscripts' fingerprints
 * are unchanged.
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

/** The data recorded of a source when a plan is built. */
struct source_record {
    bool known;            /* each call gives the source's range */
    bool anchored;         /* request.known[].first is an address to which `extent` is relative */
    struct offsets extent; /* the source's range; if `known`, it is {0, length} */
    struct fingerprint fingerprint;
    uint64_t sampled; /* a hash of a few words of the source */
    struct tracking tracking;
};

struct kept_plan {
    struct plan *plan;
    redcc_word *key;                    /* [key_count] */
    struct float_control float_control; /* settings of the thread that entered the loop; subscripts
                                           may depend on its rounding mode */
    struct source_record *source;       /* [source_count] */
    uint64_t sampled;                   /* the value of reuse->sampled when the plan was built */
    uint64_t last_use;
    bool stale; /* the subscripts were found changed, and the plan was not used since */
};

/** The plans that a loop keeps. */
struct plan_cache {
    struct kept_plan *kept[REDCC_PLANS]; /* NULL: a free slot */
    uint64_t clock;
    /* back-off after write tracking that did not save what it cost (tracking.c) */
    struct back_off back_off;
};

/** One call's search for a plan. All threads share it. */
struct reuse {
    struct plan_cache *cache;
    const struct call *call;
    struct hasher *const *hasher; /* [threads] the threads' hashers */
    struct barrier *barrier;
    struct kept_plan *found; /* the plan that may be reused or is in use; NULL: none */
    struct range *sources;   /* [source_count] the sources' ranges in this call */
    /* [array_count] the ranges that the plan's groups would write in this call */
    struct range *written;
    long skipped_calls; /* number of calls before this one that auto executed sequentially */
    double earned;      /* seconds that auto has saved by the plan, minus its construction */
    uint64_t sampled;   /* a hash of a few words of the subscripts; 0: not sampled */
    bool same;          /* the subscripts compared so far are unchanged */
    int changed_source; /* the source whose change made a plan invalid in this call; -1: none */
};

/** A hash of some words of each subscript array whose range the call gives, for reuse->sampled; 0:
 * none could be sampled. */
uint64_t redcc_reuse_sample(const redcc_loop *loop, const redcc_extent *known);

/** Hashes all subscripts into *all. Returns false if the loop lacks REDCC_VERIFIABLE, if the range
 * of a subscript array is unknown, or if hashing takes more than `seconds`. */
bool redcc_reuse_fingerprint(const redcc_loop *loop, const redcc_extent *known, double seconds,
                             struct fingerprint *all);

/** Searches for a plan of strategy `way` (WAY_SEQUENTIAL: of any strategy) for the call and for
 * `threads` threads. It checks the overlap guard and compares everything except subscripts, for
 * which it compares only a sample. Drops a plan that it finds if memory may have several addresses;
 * otherwise counts a new round of the plan, and queries or begins write tracking. Sets
 * reuse->found, reuse->sources and reuse->written. */
void redcc_reuse_find(struct reuse *reuse, int threads, enum way way);

/** Sets the bit of a strategy in *fits if redcc_reuse_find would find a plan of this strategy. Sets
 * the bit in *changed if the strategy has a plan that only the sample rules out. If no plan fits,
 * sets reuse->changed_source for the plan, among those that only the sample rules out, that was
 * used last; but only once for each change. */
void redcc_reuse_survey(struct reuse *reuse, int threads, unsigned *fits, unsigned *changed);

/** Are the subscripts of reuse->found unchanged? Every thread calls this function with its hasher
 * and gets the same answer. If they have changed, sets reuse->changed_source. */
bool redcc_reuse_verify(struct reuse *reuse, struct hasher *hasher);

/** Frees reuse->found, because its subscripts have changed or the memory may have several
 * addresses. */
void redcc_reuse_drop_found(struct reuse *reuse);

/** The number of sources of reuse->found that need not be read in this call, because write tracking
 * shows that they are unmodified. */
uint32_t redcc_reuse_skipped_sources(const struct reuse *reuse);

/** Is a plan for this call worth keeping? False if no later call could verify it.
 * sources[source_count] has the ranges that are read. */
bool redcc_is_reusable(const struct request *request, const struct range *sources);

/** Takes ownership of `plan`, and records the call with the fingerprints that the hashers computed.
 * If the cache is full, replaces the least recently used plan. Returns false if out of memory; the
 * caller then still owns the plan. */
bool redcc_reuse_keep(struct reuse *reuse, struct plan *plan);

/** Frees all plans, so that there is memory for another. */
void redcc_cache_drop_all(struct plan_cache *cache);

#endif
