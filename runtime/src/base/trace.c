/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/trace.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>

const char *const redcc_trace_names[TRACES] = {
#define REDCC_TRACE(id, name) name,
    REDCC_TRACE_LIST(REDCC_TRACE)
#undef REDCC_TRACE
};

unsigned redcc_traced;

void redcc_trace(enum trace subject, const redcc_loop *loop, const char *format, ...) {
    assert(loop && format);
    if (!redcc_traces(subject))
        return;
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    fprintf(stderr, "redcc: %s: %s:%d (%s): %s\n", redcc_trace_names[subject], loop->file,
            loop->line, loop->function, text);
}
