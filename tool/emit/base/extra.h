/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Values of the translator's own that slice or body get, beside the user's variables. */
#ifndef EMIT_BASE_EXTRA_H
#define EMIT_BASE_EXTRA_H

/** A value that slice or body need and that is no variable of the user's. */
typedef struct extra_value {
    const char *name;
    const char *declaration; /* of a parameter, with the name */
    const char *given;       /* what it is at the call, for the context; NULL: it is not in it, */
    const char *made;        /* but each thread has this for it; NULL: it has it by its macros */
} extra_value;

#endif
