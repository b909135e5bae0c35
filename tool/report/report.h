/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The report: the verdict on each loop and its reason, in several forms. */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include "analysis/analysis.h"
#include "support/buffer.h"

typedef enum report_form { REPORT_TEXT, REPORT_JSON, REPORT_SARIF, REPORT_YAML } report_form;

/** Says for a parallel loop whether a form that executes several iterations at once (in vector
 *  lanes) was generated, or why not. */
typedef struct lanes_remark {
    bool is_asked;    /* such a form was requested for the loop */
    const char *slug; /* NULL: the loop has such a form */
    const char *message;
    ir_range range; /* the reason's place in the file */
} lanes_remark;

typedef struct report_input {
    const ir_unit *unit;
    const analysis_result *analysis;
    const char *version;         /* version of redcc */
    const char *order;           /* value of --order */
    const lanes_remark *lanes;   /* indexed by verdict, or NULL if such a form was requested for no
                                  * loop */
    const char *const *in_order; /* indexed by verdict: why updates that OpenMP leaves unordered
                                  * keep the order of the loop, or NULL; NULL as a whole: unknown */
    bool all;                    /* SARIF: include loops that need no review (kind `pass`) */
    /** The text of docs/reasons.md on a reason, in the arena; NULL for none. Used in SARIF's
     *  rules. */
    const char *(*explain)(arena *a, const char *reason);
    /** A URI of that text, in the arena, or NULL if there is none. */
    const char *(*link)(arena *a, const char *reason);
} report_input;

/**
 * Appends the report on one file.
 *   text   remarks as clang prints them, with notes at the accesses concerned
 *   json   one object, as docs/report.md describes it
 *   sarif  one SARIF 2.1.0 log
 *   yaml   LLVM optimization records, as -fsave-optimization-record writes them
 */
void report_write(arena *a, buffer *out, report_form form, const report_input *input);

#endif
