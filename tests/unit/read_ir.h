/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads units from IR text, for tests. The test fails with the message if the text is invalid. */
#ifndef UNIT_READ_IR_H
#define UNIT_READ_IR_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "ir_reader/ir_read.h"

static inline ir_unit *read_ir(arena *a, const char *text) {
    const char *message = NULL;
    ir_unit *unit = ir_read(a, text, strlen(text), &message);
    if (unit == NULL)
        fail_msg("%s", message);
    const char *problem = ir_check(a, unit);
    if (problem != NULL)
        fail_msg("%s", problem);
    return unit;
}

#endif
