/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The reports of a build and of runs, read and joined: each loop's verdict and its times. */
#ifndef HTML_REPORTS_H
#define HTML_REPORTS_H

#include <jansson.h>
#include <stdbool.h>

#include "support/arena.h"
#include "support/vector.h"

/** The times of a loop in all runs. */
typedef struct loop_time {
    unsigned runs;      /**< the number of runs that report the loop */
    const json_t *last; /**< the loop's object in the last of them */
    double seconds;     /**< seconds of inspections, executions, and the original loop if it was
                         * timed */
    double process;     /**< total seconds of the processes of these runs */
    double lost;        /**< seconds beyond the sequential loop's time divided by the threads */
    json_int_t built, reused, plans_lost, calls;
} loop_time;

typedef struct report_file report_file;

/** One loop with one verdict. A source that is compiled twice may have several. */
typedef struct report_loop {
    const report_file *file; /**< NULL: only a run reports the loop */
    const char *name;        /**< the file's name, as reported */
    const json_t *verdict;   /**< the loop's object in the build's report, or NULL if only a run
                              * reports it */
    const char *function;
    json_int_t line;
    unsigned compilations; /**< the number of compilations with this verdict */
    loop_time time;
} report_loop;

/** One source, however often it was compiled. */
struct report_file {
    const char *name;       /**< name as reported */
    const char *path;       /**< where its text is expected */
    const char *left_alone; /**< why it was not translated, or NULL if it was */
    VECTOR(report_loop *) loops;
    unsigned parallel, refused;
};

typedef struct reports {
    arena *memory;
    VECTOR(report_file *) files; /**< sorted by name */
    VECTOR(report_loop *) loops; /**< sorted by time lost, then by time, then by place */
    unsigned runs;
    VECTOR(json_t *) owned; /**< JSON objects to which the other members point */
} reports;

/** Reads the files. Each JSON object in them that has the member "process" is the report of a run;
 *  any other belongs to the report of a build. Returns NULL, or a message in the arena, with file
 *  and line. */
const char *reports_read(reports *r, unsigned count, char *const *paths);
void reports_free(reports *r);

/** Returns the text of a member; "" if the object has no such member, or the member is not text. */
const char *json_word(const json_t *object, const char *name);
bool loop_is_parallel(const report_loop *loop);

#endif
