/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** REDCC_METHOD: the method of all loops, and of single ones, FILE:LINE=METHOD. */
#ifndef REDCC_NAMED_H
#define REDCC_NAMED_H

#include "plan/method.h"

#include <stdatomic.h>

struct reported;
struct settings;

/** A method and its parameter; no method: auto. */
struct named_method {
    const struct method *method;
    int parameter;
};

/** A loop that has a method by name of its own. */
struct named_loop {
    struct named_loop *next;
    char *file; /* as the user wrote it */
    int line;
    struct named_method as;
    struct settings *settings; /* for that loop, once they are read; NULL: no memory for them */
    atomic_int met;            /* such a loop was executed */
};

/** What REDCC_METHOD says. */
struct named {
    struct named_method all;
    struct named_loop *loops; /* owned, for good */
};

/** Reads `value` (NULL: nothing is said) into *named. What is wrong with it goes to
 *  redcc_complain. */
void redcc_named_read(struct named *named, const char *value);

/** The entry of REDCC_METHOD for the loop, which has then been met; NULL: there is none.
 *  Thread-safe. */
const struct named_loop *redcc_named_find(const struct named *named, const redcc_loop *loop);

/** Says on standard error which loops of REDCC_METHOD were never met, and which of those in the
 *  report is the nearest. */
void redcc_named_note_unmet(const struct named *named, const struct reported *reported);

#endif
