/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Work in processes of its own: what crashes takes nothing else down, and several run at once. */
#ifndef WORKERS_H
#define WORKERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct workers {
    unsigned count;     /* pieces of work, numbered from 0 */
    unsigned at_once;   /* processes; 0: the caller's own, which is to end as the work does */
    size_t result_size; /* bytes of a result: no pointers in it */
    bool keeps_output;  /* show what a piece prints only after the pieces before it, each at once */
    /** May be NULL; else output is kept. In the caller's process, in order, before `done`: gets
     * what a piece printed on standard output, in place of its being shown there. `output` is at
     * its beginning, and closed afterwards. Not with at_once 0. */
    void (*take)(unsigned number, FILE *output, void *context);
    /** In a process of its own: does the piece and fills in *result, which is zeroed before. */
    void (*work)(unsigned number, void *result, void *context);
    /** In the caller's process, in order: `ended_by` is 0, or the signal that ended the process, or
     *  -1 where it failed otherwise. */
    void (*done)(unsigned number, const void *result, int ended_by, void *context);
    /** May be NULL. In the caller's process, as pieces end, in any order. */
    void (*progress)(unsigned finished, void *context);
    void *context;
} workers;

/** Returns false where no process or memory can be had; all that was begun is waited for. */
bool workers_run(const workers *w);

/** Says on standard error that the process of this file did not end well; `ended_by` as for done.
 */
void workers_explain(const char *path, int ended_by);

#endif
