/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The output of REDCC_VALIDATE=1, written to standard error at exit. */
#include "report.h"

#include "settings.h"

#include <stdlib.h>
#include <unistd.h>

static void begin_line(const struct reported *loop) {
    fprintf(stderr, "redcc: validated: %s:%d (%s): ", loop->file, loop->line, loop->function);
}

static bool ran_in_parallel(const struct reported *loop) {
    return loop->statistics.in_loops > 0;
}

/* Prints the most frequent reason why a loop never ran in parallel. */
static void print_why_not(const struct reported *loop) {
    const struct statistics *it = &loop->statistics;
    const char *why = "no call had an iteration to execute";
    long most = 0;
    for (int reason = REASON_NONE + 1; reason < REASON_COUNT; reason++)
        if (atomic_load(&it->fallback[reason]) > most) {
            most = atomic_load(&it->fallback[reason]);
            why = redcc_reason_text((enum reason)reason);
        }
    for (int i = 0; i < REDCC_TEXTS; i++)
        if (it->why.overlap[i].count > most) {
            most = it->why.overlap[i].count;
            why = it->why.overlap[i].text;
        }
    begin_line(loop);
    fprintf(stderr, "never ran in parallel, %ld calls: %s\n", atomic_load(&it->calls), why);
}

static void tell_comparison(const struct reported *loop) {
    const struct validated *it = &loop->statistics.validated;
    begin_line(loop);
    fprintf(stderr, "%ld executions compared, ", it->executions);
    if (it->largest > 0)
        fprintf(stderr, "largest difference %.4g ulps, in element %lld of %s", it->largest,
                it->element, it->name);
    else
        fputs("no difference in ulps", stderr);
    if (it->broken > 0)
        fprintf(stderr, "; the promise of order %s is BROKEN in %ld of them\n",
                redcc_order_name(loop->statistics.order), it->broken);
    else if (loop->statistics.last.compensated)
        fputs("; the sums are compensated, those of the sequential loop are not\n", stderr);
    else
        fprintf(stderr, "; order %s is kept\n", redcc_order_name(loop->statistics.order));
}

/* Prints how many updates were made to rows that the slices did not name. (The first few of these
 * updates were printed when they were found.) Returns whether there were any. */
static bool print_misnamed(const struct reported *loop) {
    const long count = atomic_load(&loop->statistics.validated.misnamed);
    if (count == 0)
        return false;
    begin_line(loop);
    fprintf(stderr, "%ld updates of rows that the slice does not name\n", count);
    return true;
}

static void tell(const struct reported *loop) {
    const struct validated *it = &loop->statistics.validated;
    if (!ran_in_parallel(loop)) {
        print_why_not(loop);
        return;
    }
    if (it->passed_over > 0) {
        begin_line(loop);
        fprintf(stderr,
                "%ld executions not compared: no copy of the elements can be made before the loop "
                "(pointers in memory lead to them)\n",
                it->passed_over);
    }
    if (it->executions > 0)
        tell_comparison(loop);
    else if (it->passed_over == 0) {
        begin_line(loop);
        fputs("ran in parallel, no execution compared: there was no memory for a copy, or another "
              "thread executed the loop\n",
              stderr);
    }
}

bool redcc_report_validation(void) {
    bool broken = false;
    long loops = 0, parallel = 0;
    for (const struct reported *loop = redcc_report_loops(); loop; loop = loop->next) {
        tell(loop);
        loops++;
        parallel += ran_in_parallel(loop);
        const bool misnamed = print_misnamed(loop);
        broken = broken || misnamed || loop->statistics.validated.broken > 0;
    }
    if (loops == 0)
        fputs("redcc: validated: 0 loops ran in parallel: no translated loop was executed\n",
              stderr);
    else if (parallel == 0)
        fputs("redcc: validated: 0 loops ran in parallel: the reasons are above\n", stderr);
    else
        fprintf(stderr, "redcc: validated: %ld of %ld loops ran in parallel\n", parallel, loops);
    return broken;
}
