/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Merges the reports of separate processes, each on one file, into one report. */
#ifndef JOINED_REPORT_H
#define JOINED_REPORT_H

#include <jansson.h>
#include <stdio.h>

#include "redcc/options.h"
#include "support/buffer.h"

typedef struct joined_report {
    report_form form;
    const char *path; /* the output file; "-": standard output */
    buffer text;      /* for forms whose reports are concatenated */
    json_t *log;   /* SARIF: the first file's log, to whose run the results of others are added */
    json_t *known; /* SARIF: the texts of the results so far */
} joined_report;

/** Must the reports on the files be merged (and not printed one by one)? A SARIF log covers all
 *  files, and a file is written once. */
bool joined_report_is_needed(const options *o);

/** The options for the process of one file: those of `o`, with the report on standard output. */
options joined_report_of_one(const options *o);

/** Begins a report; joined_report_end frees it. */
joined_report joined_report_begin(const options *o);

/** Adds the output of a file's process, if any. */
void joined_report_add(joined_report *joined, FILE *printed);

/** Writes the report and frees it. Returns NULL, or a message in the arena. */
const char *joined_report_end(arena *a, joined_report *joined);

#endif
