/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Declares redcc_run: the function through which an object with loops of redcc/loop.h or
 * redcc/parallel.h calls the runtime. */
#ifndef REDCC_ENTRY_H
#define REDCC_ENTRY_H

#include <redcc/structures.h>

/** The version of the interface that this file, structures.h and parallel_steps.h share with the
 *  runtime. */
enum { REDCC_INTERFACE = 8 };

/** A transformed loop. There is one static object for each; only the runtime writes to it. */
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
    const redcc_linkage *linkage; /* functions on which the translation relies; 0: none */
    /* Operands of scalar updates: each iteration stores its own, and the caller uses them after the
     * loop. */
    redcc_u32 operand_count;
    const redcc_size *operand_bytes; /* [operand_count] the size of one operand */
    void **operands; /* [operand_count], set by the runtime before any thread begins; if redcc_run
                        returned 1, the caller frees them (series->release) */
    redcc_u32 series_count;
    redcc_series **series; /* [series_count] variable numbers of operands per iteration
                              (redcc/series.h); set and freed in the same way as `operands` */
    int threads; /* REDCC_TEAM: the number of threads that the program requests; 0: no request */
    const redcc_extent *sections; /* [array_count] for REDCC_SECTIONED: each array's section in
                                     OpenMP's clause `reduction`; else 0 */
    redcc_int *made; /* with REDCC_CONTINUES: the number of iterations that were executed. It is
                        `trip` before redcc_run, which lowers it if an iteration leaves the loop */
} redcc_attempt;

/** The function that each thread calls. It inspects, and later executes, the chunks of iterations
 * that the runtime hands out to the thread. */
typedef void redcc_member(redcc_worker *worker, const redcc_attempt *attempt, const void *context);

#ifdef __cplusplus
extern "C" {
#endif
/** Executes a loop. REDCC_DONE: the loop is done. REDCC_DONE_IN_BLOCKS: it is done in a fixed order
 * that is not its own (REDCC_SECTIONED, redcc_binned.is_unordered). 0: nothing was written, and the
 * sequential loop must run. `version` is the caller's REDCC_INTERFACE. If `attempt` is 0, it
 * executes nothing and only sets site->calls. Thread-safe. */
int redcc_run(redcc_u32 version, redcc_site *site, const redcc_attempt *attempt,
              redcc_member *member, const void *context);
#ifdef __cplusplus
}
#endif

/** A scratch row, into which the body writes its contributions to a row of an array; redcc_rows_end
 * applies them. Used with bins, locks and compensated sums. */
typedef struct redcc_kept_row {
    redcc_u32 array;
    redcc_u32 bytes;
    void *row;    /* the row's address in the array */
    void *values; /* the body's contributions */
} redcc_kept_row;

#endif
