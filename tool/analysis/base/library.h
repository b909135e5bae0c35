/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Lists the functions of the C library that only compute a value, with their properties. */
#ifndef ANALYSIS_LIBRARY_H
#define ANALYSIS_LIBRARY_H

#include "ir/ir.h"

/** Says under which standard the plain name (without __builtin_) also belongs to the C library. A
 *  program may define a function with a name that no standard reserves. */
typedef enum library_standard {
    LIBRARY_C89,
    LIBRARY_C99,    /* reserved from C99 on (C17 7.1.3) */
    LIBRARY_GNU,    /* belongs to the C library if a system header declares it */
    LIBRARY_BUILTIN /* never; only the name with __builtin_ belongs to the compiler */
} library_standard;

typedef struct library_function {
    const char *name;
    bool sets_errno; /* sets errno on failure */
    bool is_exact;   /* the result is exact, and therefore equal in all implementations */
    library_standard standard;
    bool has_variants; /* has variants for float and long double, named with the suffix f or l */
} library_function;

enum { LIBRARY_NAME_SIZE = 32 };

/** Stores the C library's name of a function for which the compiler or fortified headers have
 *  another name: __builtin_memcpy, __memcpy_chk and __builtin___memcpy_chk are memcpy. Other names
 *  are copied. Returns false if the name is longer than any that matters. */
bool library_plain_name(const char *name, char plain[LIBRARY_NAME_SIZE]);

/** Does the call return a table of <ctype.h>? These tables belong to the calling thread, and in
 *  glibc only setlocale and uselocale replace them. */
bool library_is_locale_table(const ir_node *call);

/** May two threads get different results with the same arguments and the same memory? Meant for
 *  functions with an unknown body; decided by the declaration. */
bool library_depends_on_thread(const ir_function *function);

/** Is the result the same in all threads? Meant for a function with an unknown body that is
 *  declared pure or const. True if it is a builtin of the compiler, or a function of the C library
 *  that is known to read no thread-local data. */
bool library_is_same_in_threads(const ir_function *function);

/** Is it a function of MPI (Message Passing Interface)? It is if it has no body here and its name
 *  begins with MPI_ or PMPI_, which the standard reserves (MPI 4.0, 2.5). A program may restrict
 *  MPI calls to the thread that initialised MPI (MPI_THREAD_FUNNELED). */
bool library_is_message_passing(const ir_function *function);

/** The table's entry for the function of the C library or compiler to which this declaration of
 *  `unit` refers. NULL if it is the program's own function, or not in the table. */
const library_function *library_find(const ir_unit *unit, const ir_function *function);

#endif
