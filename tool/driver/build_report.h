/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The report of a build, $REDCC_BUILD_REPORT: one JSON object per line for each source that was
 * analysed or compiled unchanged. Several redcc-cc processes may append to it at once.
 */
#ifndef DRIVER_BUILD_REPORT_H
#define DRIVER_BUILD_REPORT_H

#include <stdbool.h>
#include <stdio.h>

#include "support/arena.h"

/** The file for the report of this build: $REDCC_BUILD_REPORT, else $REDCC_REPORT (then *by_run is
 * set: the variable also names the run's report), or NULL if there is none. */
const char *build_report_file(bool *by_run);

/** Appends the contents of a JSON file as one line, atomically, with a member "directory": the
 * current folder. Returns false if either file cannot be read or written. */
bool build_report_append(arena *a, const char *json_file, const char *report);

/** Appends {"redcc": VERSION, "file": ..., "loops": [], "left_alone": why}, and "directory". */
bool build_report_append_left_alone(const char *file, const char *why, const char *report);

/** Prints a summary of a build's report: the numbers of files that were translated, analysed, and
 * compiled unchanged; the number of loops made parallel; and the reasons for the other loops and
 * files, most frequent first. Returns 0, or 1 with a message on standard error if the report
 * cannot be read or a line is invalid. */
int build_report_summarise(const char *report, FILE *out);

#endif
