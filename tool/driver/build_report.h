/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The report of a build, $REDCC_BUILD_REPORT: one JSON object a line for each C file that was
 * analysed or left alone. Several redcc-cc append to it at once.
 */
#ifndef DRIVER_BUILD_REPORT_H
#define DRIVER_BUILD_REPORT_H

#include <stdbool.h>
#include <stdio.h>

#include "support/arena.h"

/** Where the report of this build goes: $REDCC_BUILD_REPORT, else $REDCC_REPORT (*by_run is then
 * set: that is the name of the run's report); NULL: nowhere. */
const char *build_report_file(bool *by_run);

/** Appends what a JSON file holds, on a line of its own, as a whole, with a member "directory": the
 *  current folder. False where either file cannot
 *  be read or written. */
bool build_report_append(arena *a, const char *json_file, const char *report);

/** Appends {"redcc": VERSION, "file": ..., "loops": [], "left_alone": why}, and "directory". */
bool build_report_append_left_alone(const char *file, const char *why, const char *report);

/** Prints what a build's report comes to: files translated, analysed and left alone, loops made
 *  parallel, and the reasons for which others were not, most frequent first. Returns 0; 1 with a
 *  message on standard error where the report cannot be read or a line is none of its objects. */
int build_report_summarise(const char *report, FILE *out);

#endif
