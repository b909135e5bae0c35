/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What was done with each loop, and why not more: the same verdicts in several forms. */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include "analysis/analysis.h"
#include "support/buffer.h"

typedef enum report_form { REPORT_TEXT, REPORT_JSON, REPORT_SARIF, REPORT_YAML } report_form;

/** Why a loop that runs in parallel has no form for several iterations at once. */
typedef struct lanes_remark {
    bool is_asked;    /* it is to have one */
    const char *slug; /* NULL: it has one */
    const char *message;
    ir_range range; /* of what stands in the way */
} lanes_remark;

typedef struct report_input {
    const ir_unit *unit;
    const analysis_result *analysis;
    const char *version;       /* of redcc */
    const char *order;         /* as --order takes it */
    const lanes_remark *lanes; /* of each verdict; NULL: no such form was asked for */
    bool all;                  /* also what needs no review: SARIF's results of kind `pass` */
    /** What docs/reasons.md says of a reason, in the arena; NULL for none. SARIF's rules have it.
     */
    const char *(*explain)(arena *a, const char *reason);
    /** Where that can be read, a URI in the arena; NULL: nowhere. */
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
