/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/prospects.h"

/* Seconds, on the machines of bench/results. They are first estimates: what a set-up has taken, and
 * what executions take, comes in their place as soon as it is known. */
static const double touch_told = 1e-9; /* of a thread: a touch, where iterations follow alike, */
static const double iteration_apart = 45e-9; /* one that has other owners than the last: 37 to 60 */
static const double touch_kept = 7e-9;       /* told and kept, of a thread; */
static const double graph_row = 32e-9; /* cutting owners from what is kept, a row: of a thread, */
static const double graph_row_alone = 25e-9; /* and while the others wait; */
/* to assign a row of a further group to an owner, by majority vote of the iterations: of a thread,
 * 13 to 20. */
static const double further_row = 20e-9;
static const double touch_range = 1e-9; /* to tell a touch for its extent alone */
static const double frequent = 0.25;    /* runs, of the iterations: all touches are told apart */
static const double run_begun = 3e-9;
static const double byte_copied = 0.15e-9;    /* of a copy that is filled and brought in, */
static const double new_byte_copied = 0.6e-9; /* and that the system has to find a page for */
static const double byte_checked = 0.05e-9;
static const double contended = 1.1;  /* times as long as alone, side by side: 1.05 to 1.4 */
static const double scattered = 1.15; /* where an owner's rows do not lie together */
static const double guarded = 1.1;    /* where most iterations ask who owns what they write */
/* Where rows in no order are prefetched, which the sequential loop does not do: 0.42 to 0.57. */
static const double fetched_ahead = 0.7;
/* By lanes one thread takes 0.3 to 0.9: worth a set-up from the credit, but no loan. More threads
 * are worth one without. */
static const double by_lanes = 0.85;
static const double even = 1.1; /* of an equal share: the graph cannot do much better */

const double redcc_level_touch = 20e-9;

static void by_copies(const struct findings *it, struct prospect *prospect) {
    const double trip = (double)it->trip;
    prospect->possible = it->copies;
    prospect->set_up = it->spent + it->touches * trip * touch_range;
    prospect->execution = it->sequential * contended / it->threads +
                          it->copied * (it->reusable ? byte_copied : new_byte_copied) / trip;
}

/* Where the executor waits for memory less than the original loop. */
static double waiting(const struct findings *it) {
    return it->fetched ? fetched_ahead : 1;
}

/* Of an execution by owners, in proportion to the original loop beside as many others. */
static double executing(const struct findings *it) {
    return waiting(it) * (it->threads > 1 ? contended : it->lanes ? by_lanes : 1);
}

static void by_index(const struct findings *it, struct prospect *prospect) {
    const double apart = it->runs < frequent ? it->runs / frequent : 1;
    const double inspected = it->touches * touch_told + it->runs * iteration_apart;
    prospect->possible = true;
    prospect->set_up = it->spent + inspected * (double)it->trip / it->threads;
    prospect->execution = it->sequential * executing(it) * it->share * (1 + apart * (guarded - 1)) +
                          it->runs * run_begun / it->threads;
}

static void by_graph(const struct findings *it, struct prospect *prospect) {
    const double each =
        (it->touches * touch_kept + it->leading_rows * graph_row + it->further_rows * further_row) /
        it->threads;
    prospect->possible = it->reusable && it->share * it->threads > even;
    prospect->set_up = it->spent + (each + it->leading_rows * graph_row_alone) * (double)it->trip;
    prospect->execution = it->sequential * executing(it) * scattered / it->threads +
                          it->runs * run_begun / it->threads;
}

/* What pushing and applying records takes is known only when it was tried. */
static void by_bins(const struct findings *it, struct prospect *prospect) {
    prospect->possible = it->binned;
    prospect->execution =
        it->sequential * contended / it->threads + it->bin_bytes * byte_copied / (double)it->trip;
}

void redcc_estimate_prospects(const struct findings *findings, struct prospect *prospect) {
    const double trip = (double)findings->trip;
    const double checked = findings->checked * byte_checked / findings->threads / trip;
    for (enum way way = 0; way < WAY_COUNT; way++)
        prospect[way] = (struct prospect){0};
    by_copies(findings, &prospect[WAY_COPIES]);
    by_index(findings, &prospect[WAY_INDEX]);
    by_graph(findings, &prospect[WAY_GRAPH]);
    by_bins(findings, &prospect[WAY_BINS]);
    for (enum way way = WAY_COPIES; way <= WAY_LAST_PLANNED;
         way++) /* a plan that is not kept serves once */
        prospect[way].execution += findings->reusable ? checked : prospect[way].set_up / trip;
}
