/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Proves that a variable may be private to each iteration of a loop.
 *
 *  The proof shows that every byte of the variable that an iteration may read was written earlier
 *  in the same iteration, on every path. The method is abstract interpretation of the body with the
 *  set of bytes that have definitely been written. Loops with known trip counts are interpreted
 *  iteration by iteration. Writes in other loops count afterwards only for reads in loops with the
 *  same header. Pointers into the variable are followed through local variables and into callees
 *  with known bodies. If a construct cannot be followed, the result is PRIVATE_UNKNOWN. */
#ifndef ANALYSIS_MUST_WRITE_H
#define ANALYSIS_MUST_WRITE_H

#include "analysis/base/facts.h"
#include "ir/ir.h"

/** The prover for one unit. It caches results about callees. Not thread-safe. */
typedef struct must_write must_write;

/** Creates a prover in the arena. `options` names functions without a body here that have no side
 *  effects; it may be NULL. */
must_write *must_write_new(arena *a, const ir_unit *unit, const analysis_options *options);

typedef enum private_verdict {
    PRIVATE_PROVED,            /* each iteration may have its own, uninitialised copy */
    PRIVATE_READ_BEFORE_WRITE, /* an iteration may read a byte that it has not written */
    PRIVATE_UNKNOWN            /* the variable escapes, is not local or is too large, or the proof
                                * fails or is too expensive */
} private_verdict;

typedef struct private_result {
    private_verdict verdict;
    const ir_node *node; /* the cause, inside the body if possible; NULL if there is none, or if
                          * it is the variable itself */
    const char *why;     /* the reason as a clause without a full stop, such as "its address is
                          * stored"; NULL if proved */
    bool is_written;     /* an iteration may write some byte of the variable */
    /** Every byte except padding is definitely assigned when an iteration ends. The last
     *  iteration's copy then has the value that the sequential loop leaves. */
    bool assigned_at_end;
} private_result;

/** Analyses `variable` for iterations that execute `body`, the body of a loop, in which `continue`
 *  ends the iteration. The caller must make sure that the loop's header neither reads nor writes
 *  the variable. A variable declared inside the body is private by its scope: PRIVATE_PROVED, not
 *  assigned at the end. */
private_result must_write_check(must_write *prover, const ir_node *body,
                                const ir_variable *variable);

/** How a call uses the target of a pointer parameter, whatever object that is. */
typedef struct parameter_effect {
    bool keeps_address; /* the call may store the address, return it, or pass it to unknown
                         * code */
    bool is_known;      /* the address is neither stored nor returned, and all accesses are in bytes
                         * [0, end) from it. If false, the fields below are invalid */
    int64_t end;        /* number of bytes behind the pointer within which a call reads and
                         * writes */
    bool may_read;      /* it may read bytes that it has not written before */
    bool may_write;
    bool writes_all; /* all of [0, end) has definitely been written when the call returns */
} parameter_effect;

/** How a function with a known body uses the target of its parameter `index`. Results are
 *  cached. */
parameter_effect must_write_parameter(must_write *prover, const ir_function *function,
                                      unsigned index);

#endif
