/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The file that $REDCC_REPORT names: one JSON object a line, from many compilers at a time. */
#ifndef DRIVER_REPORT_LOG_H
#define DRIVER_REPORT_LOG_H

#include <stdbool.h>

#include "support/arena.h"

/** Appends the JSON text in the file `report` to the file `log`, on a line of its own, under a
 * lock. Returns false where one cannot be read or the other not written. */
bool report_log_append(arena *a, const char *report, const char *log);

#endif
