/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads REDCC_METHOD, which names the method of all loops, or of single loops as FILE:LINE=METHOD.
 */
#ifndef REDCC_NAMED_H
#define REDCC_NAMED_H

#include "plan/method.h"

#include <stdatomic.h>

struct reported;
struct settings;

/** A method and its parameter. No method means auto. */
struct named_method {
    const struct method *method;
    int parameter;
};

/** A loop for which REDCC_METHOD names a method. */
struct named_loop {
    struct named_loop *next;
    char *file; /* the file's name as the user wrote it */
    int line;
    struct named_method as;
    struct settings *settings; /* the settings for that loop, once the environment was read; NULL:
                                  out of memory */
    atomic_int met;            /* the loop was executed */
};

/** The contents of REDCC_METHOD. */
struct named {
    struct named_method all;
    struct named_loop *loops; /* owned, never freed */
};

/** Parses `value` (NULL: unset) into *named. Reports errors by redcc_complain. */
void redcc_named_read(struct named *named, const char *value);

/** Finds the entry of REDCC_METHOD for the loop, and marks it as executed. NULL: there is no entry.
 * Thread-safe. */
const struct named_loop *redcc_named_find(const struct named *named, const redcc_loop *loop);

/** For each loop of REDCC_METHOD that was never executed, prints a line to standard error, with the
 * nearest loop of the report. */
void redcc_named_note_unmet(const struct named *named, const struct reported *reported);

#endif
