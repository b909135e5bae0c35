/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A reduction method: distributes the iterations of a loop among threads, given the access summary.
 * methods/ has one file per method, methods/list.c the list; docs/methods.md describes them.
 *
 * A method determines what each thread executes (its function `prepare`) and whether threads write
 * to copies. For all methods with a plan, the executor (execute/executor.c) hands out chunks, waits
 * between stages, and merges copies.
 */
#ifndef REDCC_METHOD_H
#define REDCC_METHOD_H

#include "base/share.h"
#include "base/way.h"
#include "ownership/partition.h"
#include "ownership/summary.h"

struct levels;
struct plan;

/** The results of inspecting all iterations, from which a method builds a plan. */
struct evidence {
    const struct partition *partition;
    /* [threads] the access summaries of consecutive shares of the iterations */
    const struct summary *const *summary;
    const struct range *const *seen; /* [threads][array_count] for each share of the iterations, the
                                        range of each group that it touches */
    int threads;
    redcc_int trip;
    const struct levels *levels; /* set if the method sets in_levels */
    bool every_iteration;        /* iterations that touch nothing must be executed, too */
};

enum copy_kind {
    COPY_NONE,
    COPY_WHOLE,   /* each thread writes to a copy of everything that the loop touches */
    COPY_TOUCHED, /* each thread has a copy of the range that its iterations touch */
    COPY_TEAM,  /* each team has a copy of everything that the loop touches, except the first team,
                   which writes to the arrays */
    COPY_SHARE, /* the iterations are divided into `parameter` equal shares, each with a copy of
                   everything that the loop touches */
    COPY_LATER  /* as COPY_SHARE, but the first share writes to the arrays. All memory between
                   touched elements must belong to the arrays. If there is only one thread, it uses
                   one copy for all shares after the first */
};

struct method {
    const char *name;      /* the method's name in the literature and in REDCC_METHOD */
    const char *alias;     /* OPTIONAL; a second name that REDCC_METHOD also accepts */
    const char *parameter; /* the form of the parameter that may follow a colon in REDCC_METHOD,
                              such as "a|b" or "N"; NULL: the method has no parameter */

    /* What the method promises and needs: */
    /* the strongest order that the method's results satisfy. SERIAL also means that each element's
     * contributions are added in the order of the loop, as REDCC_ORDER_NEEDED requires. A method
     * with FIXED is used even if there is only one thread */
    redcc_order keeps;
    enum copy_kind copies; /* if not COPY_NONE, each array needs an element_rule */

    bool by_graph;  /* owners are chosen by partitioning the graph of a complete access log
                       (inspect/logging.c, ownership/graph/divide.h) or, if that is impossible, by
                       address */
    bool in_levels; /* iterations are assigned to levels, by a complete access log
                       (ownership/graph/levels.h) */
    bool locks;     /* a thread locks a row (without rows, an element) while it updates it */
    bool in_bins;   /* the method needs no plan, and an inspection only with REDCC_BINS_CHECKED:
                       updates are recorded and later applied bin by bin (bins/binning.h) */
    bool selects;   /* threads find their iterations during execution (execute/select.h): the
                     * loop must have REDCC_SELECTS */
    bool tiles;     /* threads execute tiles of a loop over pairs (execute/tiles.h): the loop must
                     * have REDCC_TILES */
    bool steals;    /* each thread's owner also has REDCC_STEALABLE stealable blocks, which threads
                       that finish early execute. A method with this has no function `owners` */

    /** REQUIRED with `parameter`; parses the text after the colon. Returns 0 if it is invalid. */
    int (*parse)(const char *text);
    /** OPTIONAL; the text of a parameter that is neither a number nor a letter. */
    const char *(*spell)(int parameter);
    /** The parameter's default value. */
    int usual;

    /** OPTIONAL; the number of teams of threads, 1 to `threads`. Default: 1. */
    int (*teams)(int threads, int parameter);
    /** OPTIONAL; the number of owners for which the arrays are cut. Without this function there are
     * `threads` owners and, with `steals`, their stealable blocks. */
    uint32_t (*owners)(int threads, int parameter);
    /** OPTIONAL; the number of flags by which the method's tasks synchronise. */
    uint32_t (*flags)(uint32_t owners);
    /** Puts the iterations of `thread` into plan->schedule[thread]. With `steals`, schedules belong
     * to owners, and the function fills those of the thread's owner and its stealable blocks.
     * Called by all threads concurrently. Returns false if out of memory. The pointer is NULL if
     * the method is the sequential loop itself, or in_bins. */
    bool (*prepare)(struct plan *plan, const struct evidence *evidence, int thread);
};

/** Do the method's threads find their work during execution? Then the plan has no schedules. */
static inline bool redcc_goes_without_schedules(const struct method *method) {
    return method->selects || method->tiles;
}

/** The strategy of `auto` to which a method belongs. */
static inline enum way redcc_way_of(const struct method *method) {
    if (method->copies != COPY_NONE)
        return WAY_COPIES;
    if (redcc_goes_without_schedules(method))
        return WAY_DIRECT;
    return method->by_graph || method->in_levels ? WAY_GRAPH : WAY_INDEX;
}

#define METHOD(name) extern const struct method redcc_method_##name;
#include "plan/methods.def"
#undef METHOD

/** The method `sections` (choose/sections.h). REDCC_METHOD does not accept it, because few loops
 * have sections. */
extern const struct method redcc_method_sections;

/** As `sections`, for updates that OpenMP's `atomic` or `critical` protects (bins/shares.h). */
extern const struct method redcc_method_shares;

/** All methods; the last entry is NULL. */
extern const struct method *const redcc_methods[];

/** Is this method the sequential loop itself? False for NULL, which means auto. */
static inline bool redcc_is_serial(const struct method *method) {
    return method && !method->prepare && !method->in_bins;
}

/** Are the first `length` characters of `text` the method's name or alias? */
bool redcc_method_is_named(const struct method *method, const char *text, size_t length);

/** Does the loop's last iteration touch nothing? One thread must execute it nevertheless, because
 * variables that are used after the loop get their values there. */
static inline bool redcc_last_touches_nothing(const struct evidence *evidence) {
    for (int thread = evidence->threads - 1; thread >= 0; thread--) {
        const struct summary *summary = evidence->summary[thread];
        if (summary->span_count > 0)
            return summary->span[summary->span_count - 1].set == 0;
    }
    return false;
}

#endif
