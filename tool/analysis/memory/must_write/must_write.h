/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * May a variable be private to each iteration of a loop?
 *
 * The proof: every byte of it that an iteration may read was written before, on every path, in the
 * same iteration. The method: abstract interpretation of the body with the set of bytes definitely
 * written so far. Loops whose trip counts are known are executed; writes in other loops count after
 * them only for reads in loops with the same header. Pointers into the variable are followed
 * through local variables and into callees with known bodies. A construct that cannot be followed
 * makes the answer "unknown".
 */
#ifndef ANALYSIS_MUST_WRITE_H
#define ANALYSIS_MUST_WRITE_H

#include "analysis/base/facts.h"
#include "ir/ir.h"

/** The prover of one unit, which caches results about callees. Not thread-safe. */
typedef struct must_write must_write;

/** Allocated in the arena. `options` (may be NULL) names the functions that the user calls pure. */
must_write *must_write_new(arena *a, const ir_unit *unit, const analysis_options *options);

typedef enum private_verdict {
    PRIVATE_PROVED,            /* each iteration may have its own, uninitialised copy */
    PRIVATE_READ_BEFORE_WRITE, /* an iteration may read a byte that it did not write */
    PRIVATE_UNKNOWN            /* escapes, not a local variable, too large, too expensive ... */
} private_verdict;

typedef struct private_result {
    private_verdict verdict;
    const ir_node *node; /* the cause, inside of the body if possible; NULL: none, or the variable
                          * itself */
    const char *why;     /* a clause without full stop: "its address is stored"; NULL if proved */
    bool is_written;     /* an iteration may write some byte of it */
    /** Every byte (except padding) is definitely assigned when an iteration ends: the copy of the
     *  last iteration has the value that the sequential loop leaves. */
    bool assigned_at_end;
} private_result;

/**
 * Analyses `variable` for iterations that execute `body` (a loop's body; `continue` ends the
 * iteration). The caller must know that the loop's header neither reads nor writes the variable. A
 * variable declared inside of the body is private by its scope: PROVED, not assigned at the end.
 */
private_result must_write_check(must_write *prover, const ir_node *body,
                                const ir_variable *variable);

/** The effect of a call on the target of a pointer parameter, for any object. */
typedef struct parameter_effect {
    bool keeps_address; /* may store the address, return it, or pass it to unknown code */
    bool is_known;      /* the address is not stored, and all accesses lie in [0, end) from it;
                         * otherwise the fields below are invalid */
    int64_t end;        /* bytes from the pointer on that a call may read or write */
    bool may_read;      /* reads bytes that the call itself has not written before */
    bool may_write;
    bool writes_all; /* [0, end) is definitely written when the call returns */
} parameter_effect;

/** The effect through parameter `index` of a function with a known body. Memoised. */
parameter_effect must_write_parameter(must_write *prover, const ir_function *function,
                                      unsigned index);

#endif
