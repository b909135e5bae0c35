/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A reduction method: how the iterations of a loop are shared out, given the access summary. One
 * file for each in methods/, one list of them in methods/list.c; docs/methods.md describes them.
 *
 * A method decides what each thread executes (prepare) and whether threads write to copies; the
 * executor (execute/executor.c) does the rest for all of them: chunks, stages, barriers, merges.
 */
#ifndef REDCC_METHOD_H
#define REDCC_METHOD_H

#include "base/share.h"
#include "base/way.h"
#include "ownership/partition.h"
#include "ownership/summary.h"

struct levels;
struct plan;

/** What is known of a loop once all its iterations were inspected. */
struct evidence {
    const struct partition *partition;
    const struct summary *const *summary; /* [threads] of consecutive shares of the iterations */
    const struct range *const *seen;      /* [threads][array_count] what each share touches */
    int threads;
    redcc_int trip;
    const struct levels *levels; /* where the method is in_levels */
    bool every_iteration; /* those that touch nothing are to be executed as well; asked only of
                             methods that keep the order serial */
};

enum copy_kind {
    COPY_NONE,
    COPY_WHOLE,   /* each thread has a copy of all that is touched */
    COPY_TOUCHED, /* each thread has a copy of the range that its iterations touch */
    COPY_TEAM,    /* each team but the first, which writes in place, has a copy of all */
    COPY_SHARE    /* each of `parameter` equal shares of the iterations has a copy of all */
};

struct method {
    const char *name;      /* the literature's; what REDCC_METHOD says */
    const char *alias;     /* OPTIONAL; what REDCC_METHOD may say as well: an older name */
    const char *parameter; /* "a|b", "N": what may follow after a colon; NULL: nothing */

    /* Promises */
    redcc_order keeps;     /* the strongest order that results have: SERIAL also means that each
                              element's contributions are added in the order of the loop, which
                              loops with REDCC_ORDER_NEEDED ask for; a method that keeps FIXED is
                              used by one thread as well */
    enum copy_kind copies; /* anything but COPY_NONE needs an element_rule for each array */

    bool by_graph;  /* the plan comes from what each iteration touches, all of it kept
                       (inspect/logging.c), where that can be done: owners are cut from it
                       (ownership/graph/divide.h; else, as without it, by address), */
    bool in_levels; /* or the iterations are put in levels (ownership/graph/levels.h) */
    bool locks;     /* each unit is locked while it is updated */
    bool in_bins;   /* it needs neither inspection nor plan: updates are recorded, and applied bin
                       by bin (bins/binning.h) */
    bool selects;   /* its threads find their iterations while they execute (execute/select.h): the
                       loop must have REDCC_SELECTS */
    bool steals; /* REDCC_STEALABLE stealable owners go with each thread's own: who finishes early
                    executes what is theirs. (`owners` is not asked) */

    /** REQUIRED with parameter: its value from the text after the colon; 0: no such one. */
    int (*parse)(const char *text);
    /** OPTIONAL; that text, of a value that is neither a number nor a letter. */
    const char *(*spell)(int parameter);
    /** The value without a colon. */
    int usual;

    /** OPTIONAL; the number of teams that threads form, 1 to `threads`. Without it: 1. */
    int (*teams)(int threads, int parameter);
    /** OPTIONAL; how many owners the arrays are cut for. Without it: `threads`. */
    uint32_t (*owners)(int threads, int parameter);
    /** OPTIONAL; how many flags its tasks wait for each other by. */
    uint32_t (*flags)(uint32_t owners);
    /** What `thread` executes, into plan->schedule[thread]; where it steals the schedules are those
     * of owners, and it fills those of its own and the stealable ones behind it. Called by all
     * threads at once. False: no memory. NULL: the method is the sequential loop itself,
     *  or in_bins. */
    bool (*prepare)(struct plan *plan, const struct evidence *evidence, int thread);
};

/** The way of auto's that a method is. */
static inline enum way redcc_way_of(const struct method *method) {
    if (method->copies != COPY_NONE)
        return WAY_COPIES;
    if (method->selects)
        return WAY_DIRECT;
    return method->by_graph || method->in_levels ? WAY_GRAPH : WAY_INDEX;
}

#define METHOD(name) extern const struct method redcc_method_##name;
#include "plan/methods.def"
#undef METHOD

/** All methods; the last entry is NULL. */
extern const struct method *const redcc_methods[];

/** Is it the sequential loop itself? NULL, auto, is not. */
static inline bool redcc_is_serial(const struct method *method) {
    return method && !method->prepare && !method->in_bins;
}

/** Do the first `length` letters of `text` name the method? */
bool redcc_method_is_named(const struct method *method, const char *text, size_t length);

/** Does the last iteration touch nothing? Somebody executes it all the same, for the last values of
 *  the variables that it sets. */
static inline bool redcc_last_touches_nothing(const struct evidence *evidence) {
    for (int thread = evidence->threads - 1; thread >= 0; thread--) {
        const struct summary *summary = evidence->summary[thread];
        if (summary->span_count > 0)
            return summary->span[summary->span_count - 1].set == 0;
    }
    return false;
}

#endif
