/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Parses one OpenMP directive: its construct and its clauses (OpenMP 4.5, chapter 2;
 *  `allocate`, and `relaxed` and `hint` of `atomic`, are from OpenMP 5.0). */
#ifndef ANALYSIS_OPENMP_DIRECTIVE_H
#define ANALYSIS_OPENMP_DIRECTIVE_H

#include "analysis/base/facts.h"

typedef enum openmp_construct {
    OPENMP_PARALLEL_FOR, /* parallel for */
    OPENMP_FOR,          /* for: distributes the loop over the threads of an enclosing parallel
                          * region */
    OPENMP_PARALLEL,     /* parallel: begins such a region */
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
    OPENMP_SHARING,     /* shared, default; of atomic and critical: update, relaxed, hint. None of
                         * them needs a check */
    OPENMP_OF_REGION,   /* proc_bind, copyin, allocate: they concern the threads, not the loop */
    OPENMP_COLLAPSE,    /* collapse(N), with N from 1 to 9 (openmp_nest.h) */
    OPENMP_NOWAIT,      /* nowait, a clause of `for` */
    OPENMP_OTHER_CLAUSE /* any other clause; the loop may not run without it */
} openmp_clause_kind;

/** One name in a clause's list; or a whole clause, if it has no list. */
typedef struct openmp_item {
    openmp_clause_kind kind;
    reduction_operator op; /* for OPENMP_REDUCTION; REDUCTION_NONE for the operators && and || */
    const char *text;      /* the name without its array section. For a clause without a list, the
                            * text in its parentheses; for OPENMP_OTHER_CLAUSE, the whole
                            * clause */
    const char *section;   /* the text inside the name's brackets, with "][" between two pairs; NULL
                            * if it has none */
    const char *word;      /* the clause's name; for OPENMP_REDUCTION, the operator */
} openmp_item;

typedef struct openmp_directive {
    openmp_construct construct;
    unsigned item_count;
    const openmp_item *items;
    const char *kept; /* the part that is not understood, so that the directive must be kept; NULL
                       * if there is none */
} openmp_directive;

/** How the clause `schedule` assigns iterations to threads. */
typedef enum openmp_schedule {
    OPENMP_NO_SCHEDULE, /* there is no such clause */
    OPENMP_STATIC,      /* any schedule except the next: the clause determines the thread of each
                         * iteration (`runtime` and `auto` may do so) */
    OPENMP_BY_TURNS     /* dynamic or guided: each thread gets another chunk of iterations when it
                         * has finished one */
} openmp_schedule;

openmp_schedule openmp_schedule_of(const openmp_directive *d);

/** Is it spelled `#pragma omp ...` or `_Pragma("omp ...")`? */
bool directive_is_openmp_pragma(const ir_directive *d);

/** Parses a directive for which directive_is_openmp_pragma is true. Macros that the file defines as
 *  numbers are replaced by these numbers; other macros are not understood. The result is in the
 *  arena. */
openmp_directive openmp_read(arena *a, const ir_unit *unit, const ir_directive *d);

/** The next token of `text` after blanks: an identifier, a number, or a single other byte. Its
 *  length is 0 at the end of the text. */
const char *openmp_token(const char *text, size_t *length);

/** Is the token at `at` a name, but not that of a member (after . or ->)? */
bool openmp_is_name(const char *text, const char *at);

/** The directive's text with its lines joined and each comment replaced by a blank. */
const char *openmp_plain_text(arena *a, const char *text);

#endif
