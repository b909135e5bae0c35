/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One OpenMP directive: which construct, with which clauses (OpenMP 4.5, chapter 2). */
#ifndef ANALYSIS_OPENMP_DIRECTIVE_H
#define ANALYSIS_OPENMP_DIRECTIVE_H

#include "analysis/base/facts.h"

typedef enum openmp_construct {
    OPENMP_PARALLEL_FOR, /* parallel for */
    OPENMP_FOR,          /* for, by the team of a region around it */
    OPENMP_PARALLEL,     /* such a region */
    OPENMP_ATOMIC,       /* atomic [update] */
    OPENMP_CRITICAL,
    OPENMP_OTHER
} openmp_construct;

typedef enum openmp_clause_kind {
    OPENMP_PRIVATE,
    OPENMP_FIRSTPRIVATE,
    OPENMP_LASTPRIVATE,
    OPENMP_REDUCTION,
    OPENMP_IF,
    OPENMP_NUM_THREADS,
    OPENMP_SCHEDULE,
    OPENMP_SHARING,     /* shared, default */
    OPENMP_OF_REGION,   /* proc_bind, copyin, allocate: of the threads, not of the loop */
    OPENMP_COLLAPSE,    /* collapse(2): openmp_nest.h */
    OPENMP_NOWAIT,      /* of `for` */
    OPENMP_OTHER_CLAUSE /* only the directive itself has its effect */
} openmp_clause_kind;

/** One name of a clause's list, or the whole of a clause that has none. */
typedef struct openmp_item {
    openmp_clause_kind kind;
    reduction_operator op; /* OPENMP_REDUCTION; NONE: by && or || */
    const char *text;      /* the name, without its section; of a clause without a list the text in
                            * its parentheses; of OPENMP_OTHER_CLAUSE the whole clause */
    const char *section; /* the text in the name's brackets, "][" between two; NULL: it has none */
    const char *word;    /* the clause's name; of OPENMP_REDUCTION the operator */
} openmp_item;

typedef struct openmp_directive {
    openmp_construct construct;
    unsigned item_count;
    const openmp_item *items;
    const char *kept; /* why it must be kept: the part that is not understood; NULL: none */
} openmp_directive;

/** How the clause `schedule` assigns iterations to threads. */
typedef enum openmp_schedule {
    OPENMP_NO_SCHEDULE, /* no clause */
    OPENMP_STATIC,      /* it fixes the thread; `runtime` and `auto` may do so */
    OPENMP_BY_TURNS     /* dynamic, guided: the next free thread gets a chunk */
} openmp_schedule;

openmp_schedule openmp_schedule_of(const openmp_directive *d);

/** Is it spelled `#pragma omp ...` or `_Pragma("omp ...")`? */
bool directive_is_openmp_pragma(const ir_directive *d);

/** Parses one for which directive_is_openmp_pragma holds. Macros that the file defines as numbers
 * are replaced by these; any other macro is not understood. The result lives in the arena. */
openmp_directive openmp_read(arena *a, const ir_unit *unit, const ir_directive *d);

/** The next identifier, number or other byte of `text`, without blanks before it; its length is 0
 *  where the text ends. */
const char *openmp_token(const char *text, size_t *length);

/** Is the token at `at` of `text` a name, and not a member's? */
bool openmp_is_name(const char *text, const char *at);

/** The directive with its lines joined, and blanks for comments. */
const char *openmp_plain_text(arena *a, const char *text);

#endif
