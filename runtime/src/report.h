/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is counted of each loop, and REDCC_REPORT: one JSON object at exit. */
#ifndef REDCC_REPORT_H
#define REDCC_REPORT_H

#include "base/reason.h"
#include "choose/rule.h"
#include "execute/validate.h"
#include "plan/method.h"

#include <stdatomic.h>

enum { REDCC_TEXTS = 8, REDCC_TEXT = 192 };

/** A reason that names things of the user's. */
struct told_reason {
    char text[REDCC_TEXT];
    long count;
};

/** Of the last execution. */
struct last_execution {
    redcc_int stages;
    redcc_int trip;
    redcc_int length; /* how long it takes by the schedule, in iterations */
    bool compensated; /* its sums */
};

/** What is counted without holding the loop is atomic. */
struct statistics {
    atomic_long calls;
    atomic_long fallback[REASON_COUNT];
    struct told_reason told[REDCC_TEXTS]; /* of REASON_OVERLAP */
    atomic_int rule;                      /* enum rule: the row of auto's table that decided last */
    const struct method *method;          /* the last one used; NULL: none yet */
    int parameter;
    redcc_order order;
    int threads; /* of the last execution */
    int nodes;   /* of the machine that its threads ran on then; 0: not known */
    long moves;  /* threads found on another node than at the execution before, in all */
    long plans_built;
    long plans_reused;
    long watched; /* of these executions, those in which some subscripts were not read */
    double inspect_seconds;
    double execute_seconds;
    size_t extra_bytes; /* the most that a plan took */
    redcc_int executed; /* iterations in parallel executions, replicated ones counted */
    redcc_int in_loops; /* and not counted */
    struct last_execution last;
    struct validated validated;
};

/** A loop in the report. The texts are copies: the library that a loop is in may be unloaded. */
struct reported {
    struct reported *next;
    char *file;
    char *function;
    int line;
    struct statistics statistics;
};

/** Enters a loop into the report's list, for good. Thread-safe. */
void redcc_report_add(struct reported *reported);

/** Takes it out again; for tests. No other thread may be at the list. */
void redcc_report_remove(struct reported *reported);

/** Counts a fallback because of an overlap of what the two names stand for. */
void redcc_report_overlap(struct statistics *statistics, const char *source, const char *array);

enum { REDCC_BROKEN = 3 /* exit status */ };

/** Tells on standard error what the validation found. Returns whether a promise was broken. */
bool redcc_report_validation(void);

/** Writes the file that REDCC_REPORT names; nothing where it names none. */
void redcc_report_write(void);

#endif
