/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is counted of each loop, and REDCC_REPORT: one JSON object at exit. */
#ifndef REDCC_REPORT_H
#define REDCC_REPORT_H

#include "base/reason.h"
#include "execute/lanes.h"
#include "execute/validate.h"
#include "learn/rule.h"
#include "plan/method.h"

#include <stdatomic.h>
#include <stdio.h>

/** How a loop was executed last: identifier, slug, what it means. docs/report.md has the slugs, and
 *  a test compares. */
#define REDCC_MODE_LIST(X)                                                                         \
    X(MODE_NONE, "none", "no call had an iteration to execute")                                    \
    X(MODE_SEQUENTIAL, "sequential", "the original loop")                                          \
    X(MODE_TIMED, "timed", "the original loop, timed to compare with it")                          \
    X(MODE_BUILT, "built", "in parallel, by a plan made in that call")                             \
    X(MODE_REUSED, "reused", "in parallel, by a plan kept from an earlier call")                   \
    X(MODE_BINNED, "binned", "in parallel, without a plan")

enum mode {
#define REDCC_MODE(id, slug, text) id,
    REDCC_MODE_LIST(REDCC_MODE)
#undef REDCC_MODE
        MODE_COUNT
};

enum { REDCC_TEXTS = 6, REDCC_TEXT = 192, REDCC_LOST = 4, REDCC_NAME = 64 };

/** A text that names things of the user's, and how often it was true. */
struct told_text {
    char text[REDCC_TEXT];
    long count;
};

/** Of the last execution. */
struct last_execution {
    redcc_int stages;
    redcc_int trip;
    redcc_int length; /* how long it takes by the schedule, in iterations */
    bool compensated; /* its sums */
    int lanes;        /* iterations at once; 0: one by one */
    enum lanes_reason lanes_reason;
    atomic_int mode; /* enum mode, of the last call */
};

/** What executions in parallel took beside time. */
struct extra_work {
    size_t bytes;       /* the most that a plan took */
    redcc_int executed; /* iterations, replicated ones counted */
};

/** The original loop, where it was timed. */
struct timed_sequential {
    long calls;
    redcc_int iterations;
    double seconds;
};

/** Where its threads ran. */
struct placement {
    int nodes;  /* of the machine, in the last execution; 0: not known */
    long moves; /* threads found on another node than at the execution before, in all */
};

/** Plans that were there and could not be used, since a subscript had changed. */
struct lost_plans {
    long count;
    struct lost_to {
        char name[REDCC_NAME];
        long count;
    } array[REDCC_LOST]; /* that had changed; others are only counted */
};

/** What is counted without holding the loop is atomic. */
struct statistics {
    atomic_long calls;
    atomic_long fallback[REASON_COUNT];
    struct told_text overlap[REDCC_TEXTS]; /* of REASON_OVERLAP */
    atomic_int rule;             /* enum rule: the row of auto's table that decided last */
    const struct method *method; /* the last one used; NULL: none yet */
    int parameter;
    redcc_order order;
    int threads; /* of the last execution */
    struct placement placement;
    long plans_built;
    long plans_reused;
    long watched; /* of these executions, those in which some subscripts were not read */
    struct lost_plans lost;
    double inspect_seconds;
    double execute_seconds;
    struct timed_sequential sequential;
    struct extra_work extra;
    redcc_int in_loops; /* iterations in parallel executions, replicated ones not counted */
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

/** The loops that were executed, the last one first; NULL: none. */
const struct reported *redcc_report_loops(void);

/** Takes it out again; for tests. No other thread may be at the list. */
void redcc_report_remove(struct reported *reported);

/** Counts a fallback because of an overlap of what the two names stand for. */
void redcc_report_overlap(struct statistics *statistics, const char *source, const char *array);

/** Counts a plan that could not be used, since the array had changed. */
void redcc_report_lost(struct statistics *statistics, const char *array);

enum { REDCC_BROKEN = 3 /* exit status */ };

/** Tells on standard error what the validation found: a line for each loop, and how many ran in
 *  parallel. Returns whether a promise was broken. */
bool redcc_report_validation(void);

/** What the process's reports begin with, which no other process's do: an opened object and its
 *  members "process" and "started". */
enum { REDCC_REPORT_HEAD = 80 };
void redcc_report_head(char head[REDCC_REPORT_HEAD]);

/** The first translated loop begins: seconds and lost cores count from here. */
void redcc_report_begin(void);

/** Should a program that lost its cores `lost` times in so many seconds wait asleep? policy:
 *  OMP_WAIT_POLICY, NULL where it is not set; told: another variable says how long to spin. */
bool redcc_advises_sleep(long lost, double seconds, const char *policy, bool told);

/** Writes the rest of the object: what holds for all loops, and "loops". */
void redcc_report_body(FILE *out);

/** Writes the loops, objects with commas between them. */
void redcc_report_list(FILE *out);

/** Writes a table for people. */
void redcc_report_table(FILE *out);

/** Writes the file that REDCC_REPORT names; nothing where it names none. */
void redcc_report_write(void);

#endif
