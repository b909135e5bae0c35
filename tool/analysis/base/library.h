/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of the C library that compute a value and touch nothing else. */
#ifndef ANALYSIS_LIBRARY_H
#define ANALYSIS_LIBRARY_H

#include "ir/ir.h"

/** Whose name it is without __builtin_ before it: a program may define what nobody reserved. */
typedef enum library_standard {
    LIBRARY_C89,
    LIBRARY_C99,    /* reserved from C99 on (C17 7.1.3) */
    LIBRARY_GNU,    /* the C library's where one of the system's headers declares it */
    LIBRARY_BUILTIN /* never: only __builtin_clz is the compiler's */
} library_standard;

typedef struct library_function {
    const char *name;
    bool sets_errno; /* where it fails */
    bool is_exact;   /* one result is right, and all implementations give it: no approximation */
    library_standard standard;
    bool has_variants; /* for float and long double: the same name with f or l behind it */
} library_function;

/** Is this a call of a function through which <ctype.h> finds its tables, which are the calling
 *  thread's and which nothing but setlocale and uselocale exchange (glibc)? */
bool library_is_locale_table(const ir_node *call);

/** May two threads get other results, with the same arguments and the same memory? Of a function
 *  without a known body, by what it is declared to be. */
bool library_tells_of_thread(const ir_function *function);

/** Of a function that is declared pure or const, and whose body is not known: is it the compiler's,
 *  or one of the C library that reads nothing which a thread has for itself? */
bool library_is_same_in_threads(const ir_function *function);

/** Is it MPI's? By its name, which the standard reserves (MPI 4.0, 2.5: MPI_ and PMPI_), and
 * without a body here. A program may let only the thread that began MPI call it
 * (MPI_THREAD_FUNNELED). */
bool library_is_message_passing(const ir_function *function);

/** The function of the C library, or of the compiler, that is called by this declaration; NULL: it
 *  is the program's own, or another one. `unit` is the one that declares it. */
const library_function *library_find(const ir_unit *unit, const ir_function *function);

#endif
