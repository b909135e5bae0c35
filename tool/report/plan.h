/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How a translated loop uses plans (docs/glossary.md): one of four classes. */
#ifndef REPORT_PLAN_H
#define REPORT_PLAN_H

#include "analysis/base/facts.h"

typedef struct plan_answer {
    const char *word;   /* "kept": one plan is reused while its inputs are unchanged. "remade": each
                         * execution builds one. "none": in-order binning executes the loop without
                         * a plan. "never": the loop runs sequentially unless a method is named.
                         * NULL: the loop is not translated, or runs in fixed blocks */
    const char *cause;  /* reason for "remade" and "never"; otherwise NULL */
    const char *advice; /* a change of the source that would help, or NULL if there is no simple
                         * one */
    ir_range range;     /* range of the cause; empty: the loop itself */
} plan_answer;

plan_answer verdict_plan(arena *a, const loop_verdict *verdict);

#endif
