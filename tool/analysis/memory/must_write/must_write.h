/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * May a variable be private to each iteration of a loop?
 *
 * The proof: every byte of it that an iteration may read was written before, on every path, in the
 * same iteration. The method: abstract interpretation of the body with the set of bytes definitely
 * written so far; loops with constant bounds are executed, other loops count for nothing after
 * them; pointers into the variable are followed through straight-line code and into the callees
 * whose bodies are known. What cannot be followed makes the answer "unknown", never a wrong one.
 */
#ifndef ANALYSIS_MUST_WRITE_H
#define ANALYSIS_MUST_WRITE_H

#include "analysis/base/facts.h"
#include "ir/ir.h"

/** The prover of one unit: keeps what it has learnt of callees. Not for several threads at once. */
typedef struct must_write must_write;

/** Lives in the arena. `options` (may be NULL) names the functions that the user calls pure. */
must_write *must_write_new(arena *a, const ir_unit *unit, const analysis_options *options);

typedef enum private_verdict {
    PRIVATE_PROVED,            /* each iteration may have its own, uninitialised copy */
    PRIVATE_READ_BEFORE_WRITE, /* an iteration may read what it did not write */
    PRIVATE_UNKNOWN /* escapes, not a local variable, too large, too expensive to tell ... */
} private_verdict;

typedef struct private_result {
    private_verdict verdict;
    const ir_node *node; /* what is in the way, inside the body where it can be; NULL: nothing or
                            the variable itself */
    const char *why;     /* a clause without full stop: "its address is stored"; NULL if proved */
    bool is_written;     /* an iteration may write some byte of it */
    /** Every byte (padding apart) is definitely assigned when an iteration ends: the copy of the
     *  last iteration is what the sequential loop leaves. */
    bool assigned_at_end;
    /** Weaker: the bytes that iterations write are written by each of them. The others keep the
     *  value from before the loop, so a last value must be merged into a copy of that. */
    bool assigned_same_bytes;
} private_result;

/**
 * Analyses `variable` for iterations that execute `body` (a loop's body; `continue` ends the
 * iteration). The loop's own header is not looked at: that it neither reads nor writes the
 * variable is the caller's to know. A variable declared inside the body is private by its scope:
 * PROVED, not assigned at the end.
 */
private_result must_write_check(must_write *prover, const ir_node *body,
                                const ir_variable *variable);

/** What a call does with the memory its pointer parameter points to, whatever the object is. */
typedef struct parameter_effect {
    bool keeps_address; /* may store the address, hand it back, or pass it to what is not known */
    bool is_known;      /* the address is not kept, and all accesses lie in [0, end) from it; if
                           false, nothing below may be used */
    int64_t end;        /* bytes from the pointer on that a call may read or write */
    bool may_read;      /* reads bytes that the call itself has not written before */
    bool may_write;
    bool writes_all; /* [0, end) is definitely written when the call returns */
} parameter_effect;

/** The effect through parameter `index` of a function with a known body. Memoised. */
parameter_effect must_write_parameter(must_write *prover, const ir_function *function,
                                      unsigned index);

#endif
