/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The translator's own values that slice or body get, in addition to the user's variables. */
#ifndef EMIT_BASE_EXTRA_H
#define EMIT_BASE_EXTRA_H

/** A value that slice or body need and that is not a variable of the user's. */
typedef struct extra_value {
    const char *name;
    const char *declaration; /* of a parameter, with the name */
    const char *given;       /* its value at the call, stored in the context; NULL: not in the
                              * context, */
    const char *made;        /* but each thread computes it as this; NULL: the macros provide it */
} extra_value;

#endif
