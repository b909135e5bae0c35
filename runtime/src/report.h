/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Counters of each loop, and the report that REDCC_REPORT requests: a JSON object written at
 * exit. */
#ifndef REDCC_REPORT_H
#define REDCC_REPORT_H

#include "base/reason.h"
#include "execute/lanes.h"
#include "execute/validate.h"
#include "learn/rule.h"
#include "plan/method.h"

#include <stdatomic.h>
#include <stdio.h>

/** The mode in which a loop's last call was executed. Each mode has an identifier, a slug and a
 * meaning. docs/report.md lists the slugs, and a test compares the two lists. */
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

/** A text with names from the user's source, and how often it was reported. */
struct counted_text {
    char text[REDCC_TEXT];
    long count;
};

/** The last execution. */
struct last_execution {
    redcc_int stages;
    redcc_int trip;
    redcc_int length; /* the makespan in iterations, a lower bound of the time */
    bool compensated; /* sums were compensated */
    int lanes;        /* number of iterations executed at once; 0: one by one */
    enum lanes_reason lanes_reason;
    atomic_int mode; /* mode of the last call, an enum mode */
};

/** Costs of parallel executions other than time. */
struct extra_work {
    size_t bytes; /* size of the largest plan, or the most memory used for bins */
    /* number of executed iterations; each counts once per thread that executes it */
    redcc_int executed;
};

/** Timings of the original loop. */
struct timed_sequential {
    long calls;
    redcc_int iterations;
    double seconds;
};

/** Placement of the loop's threads. */
struct placement {
    int nodes;  /* number of NUMA nodes in the last execution; 0: unknown */
    long moves; /* how often, in total, a thread ran on another node than in the execution before */
};

/** Plans that could not be reused because a subscript had changed. */
struct lost_plans {
    long count;
    struct lost_to {
        char name[REDCC_NAME];
        long count;
    } array[REDCC_LOST]; /* the first few arrays that changed; changes of other arrays only add to
                            the total */
};

/** The method that the user named for a loop, and another one for the case that the loop cannot be
 * executed by it. */
struct named_for_loop {
    const struct method *method; /* NULL: auto */
    const struct method *able;   /* a method by which every execution of the loop is possible; NULL:
                                    there is none */
};

/** What the texts of reasons name. */
struct known_of_reasons {
    struct counted_text overlap[REDCC_TEXTS]; /* the pairs of names for REASON_OVERLAP */
    _Atomic(char *) unlinked;                 /* the text for REASON_UNLINKED, owned; NULL: none */
    struct named_for_loop named;              /* set when the counters are made */
};

/** Counters of a loop. Those that threads may update without holding the loop are atomic. */
struct statistics {
    atomic_long calls;
    atomic_long fallback[REASON_COUNT];
    struct known_of_reasons why;
    atomic_int rule;             /* an enum rule: the row of auto's table that decided last */
    const struct method *method; /* the method used last; NULL: none yet */
    int parameter;
    redcc_order order;
    int threads; /* number of threads in the last execution */
    struct placement placement;
    long plans_built;
    long plans_reused;
    long watched; /* number of reuses in which write tracking made it unnecessary to read at least
                     one subscript array */
    struct lost_plans lost;
    double inspect_seconds;
    double execute_seconds;
    struct timed_sequential sequential;
    struct extra_work extra;
    redcc_int in_loops; /* number of iterations of parallel executions; each counts once */
    struct last_execution last;
    struct validated validated;
};

/** A loop in the report. The texts are copies, because the library that contains the loop may be
 * unloaded. */
struct reported {
    struct reported *next;
    char *file;
    char *function;
    int line;
    struct statistics statistics;
};

/** Adds a loop to the report's list permanently. Thread-safe. */
void redcc_report_add(struct reported *reported);

/** The executed loops, most recent first; NULL: none. */
const struct reported *redcc_report_loops(void);

/** For tests: removes a loop from the list. No other thread may use the list. */
void redcc_report_remove(struct reported *reported);

/** Counts a fallback because source `source` overlaps `array`. */
void redcc_report_overlap(struct statistics *statistics, const char *source, const char *array);

/** Records which function is not linked as expected, for REASON_UNLINKED. Thread-safe. */
void redcc_report_unlinked(struct statistics *statistics, const redcc_expectation *other);

/** The text of a reason, with the names that are known. */
const char *redcc_report_reason(const struct statistics *statistics, enum reason reason);

/** Counts a plan that could not be reused because the subscript array `array` had changed. */
void redcc_report_lost(struct statistics *statistics, const char *array);

enum { REDCC_BROKEN = 3 /* exit status if validation found an error */ };

/** Prints the results of validation to standard error: lines for each loop, and the number of loops
 * that ran in parallel. Returns whether it found an error. */
bool redcc_report_validation(void);

/** Writes the beginning of each report of this process to `head`: the open brace and the members
 * "process" and "started". It identifies the process. */
enum { REDCC_REPORT_HEAD = 80 };
void redcc_report_head(char head[REDCC_REPORT_HEAD]);

/** Called when the settings are read. The report counts seconds and preemptions from this moment
 * on. */
void redcc_report_begin(void);

/** Should the report advise the user to set OMP_WAIT_POLICY=passive? It should if cores were
 * preempted often: `lost` times in `seconds` seconds. `policy` is the value of OMP_WAIT_POLICY
 * (NULL if unset). If it is passive already or another variable sets the spin time (has_spin_time),
 * the answer is no. */
bool redcc_advises_sleep(long lost, double seconds, const char *policy, bool has_spin_time);

/** Writes the JSON object from the end of its head on: data common to all loops, and "loops". */
void redcc_report_body(FILE *out);

/** Writes the loops as objects separated by commas. */
void redcc_report_list(FILE *out);

/** Writes a table for human readers. */
void redcc_report_table(FILE *out);

/** Writes the file that REDCC_REPORT names, if any. */
void redcc_report_write(void);

#endif
