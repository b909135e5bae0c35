/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** REDCC_TRACE: prints events of the runtime to standard error as they occur. */
#ifndef REDCC_TRACE_H
#define REDCC_TRACE_H

#include "redcc/runtime.h"

/** The subjects of traces, and their names in REDCC_TRACE. */
#define REDCC_TRACE_LIST(X)                                                                        \
    X(TRACE_CHOICE, "choice")         /* the mode that was chosen, and the rule */                 \
    X(TRACE_PLAN, "plan")             /* plans built and reused */                                 \
    X(TRACE_EXECUTION, "execution")   /* each parallel execution */                                \
    X(TRACE_VALIDATION, "validation") /* each comparison with the sequential loop */

enum trace {
#define REDCC_TRACE(id, name) id,
    REDCC_TRACE_LIST(REDCC_TRACE)
#undef REDCC_TRACE
        TRACES
};

extern const char *const redcc_trace_names[TRACES];

/** Bit s is set if subject s is traced. Set when the settings are read. */
extern unsigned redcc_traced;

static inline int redcc_traces(enum trace subject) {
    return (int)(redcc_traced >> subject & 1);
}

/** Prints one line about `loop` if the subject is traced. Thread-safe. */
void redcc_trace(enum trace subject, const redcc_loop *loop, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
