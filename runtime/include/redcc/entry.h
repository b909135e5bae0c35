/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** An object with loops of redcc/parallel.h calls the runtime through one function, redcc_run. */
#ifndef REDCC_ENTRY_H
#define REDCC_ENTRY_H

#include <redcc/structures.h>

/** The version of the interface that this file, structures.h and parallel_steps.h share with the
 *  runtime. */
enum { REDCC_INTERFACE = 5 };

/** A loop in a file. Only the runtime writes to it. */
typedef struct redcc_site {
    redcc_binned binned;
    const redcc_calls *calls; /* set by the first redcc_run */
} redcc_site;

/** The arguments of one execution. */
typedef struct redcc_attempt {
    redcc_int trip;
    redcc_int first;
    void *const *bases;
    const redcc_extent *known;
    const redcc_word *key;
    const redcc_linkage *linkage; /* 0: the translation relies on no function of another file */
    /* Operands of each iteration, which the caller uses afterwards. */
    redcc_u32 operand_count;
    const redcc_size *operand_bytes; /* [operand_count] */
    void **operands; /* [operand_count], set by the runtime before any thread begins; if the loop is
                      * done, the caller frees them (series->release) */
    redcc_u32 series_count;
    redcc_series **series;        /* [series_count], of redcc/series.h; likewise */
    int threads;                  /* REDCC_TEAM: the number that the program requests; 0: none */
    const redcc_extent *sections; /* REDCC_SECTIONED: [array_count] */
} redcc_attempt;

/** The function that each thread calls: it inspects and executes the chunks that it is handed. */
typedef void redcc_member(redcc_worker *worker, const redcc_attempt *attempt, const void *context);

#ifdef __cplusplus
extern "C" {
#endif
/** Executes a loop. 1: it is done. 0: nothing was written, and the sequential loop must run.
 *  `version`: the caller's REDCC_INTERFACE. If attempt is 0, it only sets site->calls. Thread-safe.
 */
int redcc_run(redcc_u32 version, redcc_site *site, const redcc_attempt *attempt,
              redcc_member *member, const void *context);
#ifdef __cplusplus
}
#endif

/** A scratch row that redcc_rows_end adds to its array: used with bins, locks and compensated sums.
 */
typedef struct redcc_kept_row {
    redcc_u32 array;
    redcc_u32 bytes;
    void *row;    /* the row's address in the array */
    void *values; /* the body's contributions */
} redcc_kept_row;

#endif
