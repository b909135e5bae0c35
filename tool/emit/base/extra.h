/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Values of the translator that slice or body get, in addition to the user's variables. */
#ifndef EMIT_BASE_EXTRA_H
#define EMIT_BASE_EXTRA_H

typedef struct extra_value {
    const char *name;
    const char *declaration; /* of a parameter, with the name */
    const char *given; /* the expression whose value the caller stores in the context; NULL: the
                        * value is not in the context */
    const char *made;  /* `given` is NULL: the expression by which each thread computes the
                        * value; NULL: the runtime's macros provide it */
} extra_value;

#endif
