/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Values that redcc passes to slice or body (docs/glossary.md) in addition to the user's
 * variables. */
#ifndef EMIT_BASE_EXTRA_H
#define EMIT_BASE_EXTRA_H

typedef struct extra_value {
    const char *name;
    const char *declaration; /* declaration of the parameter, with its name */
    const char *given; /* the expression whose value the caller stores in the context, or NULL if
                        * the value is not in the context */
    const char *made;  /* if `given` is NULL: the expression by which each thread computes the
                        * value, or NULL if the runtime's macros provide it */
} extra_value;

#endif
