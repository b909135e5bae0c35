/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One report on many files: each file's, made in a process of its own, put together. */
#ifndef JOINED_REPORT_H
#define JOINED_REPORT_H

#include <jansson.h>
#include <stdio.h>

#include "redcc/options.h"
#include "support/buffer.h"

typedef struct joined_report {
    report_form form;
    const char *path; /* where it goes; "-": standard output */
    buffer text;      /* of the forms in which one report follows the other */
    json_t *log;      /* SARIF: the first file's, with the runs of the others in its run */
} joined_report;

/** Must the reports on the files be put together (and not printed one by one)? A SARIF log is one
 * for all, and a file is written once. */
bool joined_report_is_needed(const options *o);

/** What the processes of the files are told: the same options, with the report on standard output.
 */
options joined_report_of_one(const options *o);

/** Begins one; joined_report_end gives its memory back. */
joined_report joined_report_begin(const options *o);

/** Adds what the process of a file printed; nothing where it printed none. */
void joined_report_add(joined_report *joined, FILE *printed);

/** Writes the report, and gives back its memory. Returns NULL, or in the arena why it could not be
 *  written. */
const char *joined_report_end(arena *a, joined_report *joined);

#endif
