/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of the C library that only compute a value. */
#ifndef ANALYSIS_LIBRARY_H
#define ANALYSIS_LIBRARY_H

#include "ir/ir.h"

/** Whether the name without __builtin_ is the C library's as well: a program may define a function
 *  of a name that no standard reserves. */
typedef enum library_standard {
    LIBRARY_C89,
    LIBRARY_C99,    /* reserved from C99 on (C17 7.1.3) */
    LIBRARY_GNU,    /* the C library's if a system header declares it */
    LIBRARY_BUILTIN /* never: only the name with __builtin_ is the compiler's */
} library_standard;

typedef struct library_function {
    const char *name;
    bool sets_errno; /* on failure */
    bool is_exact;   /* the result is exact and equal in all implementations, not an
                      * approximation */
    library_standard standard;
    bool has_variants; /* for float and long double: the same name with the suffix f or l */
} library_function;

enum { LIBRARY_NAME_SIZE = 32 };

/** The C library's name of a function that the compiler or fortified headers name otherwise:
 *  __builtin_memcpy, __memcpy_chk and __builtin___memcpy_chk are memcpy. Other names
 *  are copied. False: the name is longer than any that matters. */
bool library_plain_name(const char *name, char plain[LIBRARY_NAME_SIZE]);

/** Is this a call of a function that returns the tables of <ctype.h>? They are the calling
 *  thread's, and only setlocale and uselocale replace them (glibc). */
bool library_is_locale_table(const ir_node *call);

/** May two threads get different results with the same arguments and the same memory? For a
 *  function with an unknown body, decided by its declaration. */
bool library_depends_on_thread(const ir_function *function);

/** Is a function that is declared pure or const, with an unknown body, the compiler's, or one of
 *  the C library's that read no thread-local data? */
bool library_is_same_in_threads(const ir_function *function);

/** Is it a function of MPI? Decided by its name, which the standard reserves (MPI 4.0, 2.5: MPI_,
 *  PMPI_), without a body here. A program may allow only the thread that initialised MPI to call it
 *  (MPI_THREAD_FUNNELED). */
bool library_is_message_passing(const ir_function *function);

/** The function of the C library, or of the compiler, that this declaration refers to; NULL: it is
 *  the program's own, or another one. `unit` is the one that declares it. */
const library_function *library_find(const ir_unit *unit, const ir_function *function);

#endif
