/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The inputs of one call of a loop, and its settings. */
#ifndef REDCC_CALL_H
#define REDCC_CALL_H

#include "base/float_control.h"
#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>

struct method;

/** The arguments of redcc_enter. The loop's state owns copies of the arrays, except of
 * `sections`. */
struct request {
    const redcc_loop *loop;
    redcc_int trip;
    redcc_int asked; /* the trip count of redcc_enter. `trip` is smaller once a dry run has found an
                        iteration that leaves the loop */
    void **bases;    /* [array_count] */
    redcc_extent *known; /* [source_count] */
    redcc_word *key;     /* [key_count] */
    /* [array_count] the sections that OpenMP's clause names, if shares of them are executed without
     * an inspection (choose/sections.h); otherwise NULL */
    const redcc_extent *sections;
};

/** Which order a call keeps. With all but the first, the program leaves the order of the updates
 * open, and the iterations are executed in shares, whose number does not depend on threads. All
 * threads together, or a single thread, give the same bits. */
enum kept_order {
    KEEPS_ORDER_OF_METHOD,   /* the loop's own, or the one that the named method keeps */
    KEEPS_ORDER_OF_SECTIONS, /* OpenMP's clause names the sections that are updated: shares with
                                copies of these (choose/sections.h) */
    KEEPS_ORDER_OF_SHARES    /* shares, each with a private copy of the rows (bins/shares.h) */
};

struct call {
    struct request request;
    enum kept_order keeps; /* determined at entry (call_settings.h) */
    /* The settings of this call. */
    const struct method *method; /* the named method, or the one that keeps the order; NULL: auto */
    int parameter;               /* the method's parameter */
    bool in_bins; /* binning was named, or chosen for this call. Then there is no plan, and an
                     inspection only with REDCC_BINS_CHECKED */
    redcc_order order;
    bool compensated;
    bool validate;
    int prefetch;        /* an enum prefetch_setting, REDCC_PREFETCH */
    int lanes;           /* an enum lanes_setting, REDCC_LANES */
    bool tracks;         /* track writes to subscripts, if possible (REDCC_WATCH) */
    size_t memory_limit; /* in bytes; 0: no limit */
    /* The threads of this call. */
    bool one_will_do; /* a plan may be executed by a single thread */
    int asked;        /* number of threads requested */
    int started;      /* how many of the requested threads must be started for this region */
    int threads;      /* number of threads in the region */
    int planned;      /* number of threads for which a plan would be built; more than `threads` if a
                         single thread takes a sample */
    struct float_control float_control; /* state of the thread that entered the loop */
    double entered;                     /* time of the entry in seconds */
    int error_before;                   /* errno of the thread that entered the loop */
};

/** Is the loop executed in shares of the sections that OpenMP's clause names? */
static inline bool redcc_in_sections(const struct call *call) {
    return call->keeps == KEEPS_ORDER_OF_SECTIONS;
}

/** Is the loop executed in shares, each with a private copy of the rows? */
static inline bool redcc_in_shares(const struct call *call) {
    return call->keeps == KEEPS_ORDER_OF_SHARES;
}

/** Is the order of the updates fixed, but not the loop's own, without a method that was named? */
static inline bool redcc_is_fixed(const struct call *call) {
    return call->keeps != KEEPS_ORDER_OF_METHOD;
}

/** What the threads do with operands of scalars while they execute the loop in the order that the
 * call keeps (redcc_variant.operands). Iterations that are executed in order, or repeated for
 * validation, have REDCC_OPERANDS_ONE_BY_ONE. */
static inline int redcc_call_operands(const struct call *call) {
    return redcc_is_fixed(call) ? REDCC_OPERANDS_IN_BLOCKS : REDCC_OPERANDS_ONE_BY_ONE;
}

#endif
