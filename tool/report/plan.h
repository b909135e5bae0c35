/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What becomes of the plan of a translated loop: one of three classes. */
#ifndef REPORT_PLAN_H
#define REPORT_PLAN_H

#include "analysis/base/facts.h"

typedef struct plan_answer {
    const char *word;   /* "kept": one plan serves while what it was made from is unchanged;
                           "remade": each execution makes one; "never": it has no parallel execution
                           unless a method is named. NULL: the loop is not translated */
    const char *cause;  /* NULL where it is kept */
    const char *advice; /* what the user could change; NULL: there is nothing simple to say */
    ir_range range;     /* of the cause; empty: the loop itself */
} plan_answer;

plan_answer verdict_plan(arena *a, const loop_verdict *verdict);

#endif
