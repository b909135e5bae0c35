/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/cost_model.h"

#include <assert.h>

/* The expected time of an execution by owners, divided by that of the original loop; without the
 * shares of the threads. Measured: loops with irregular rows that are prefetched take 0.42 to 0.57,
 * and one thread with lanes takes 0.3 to 0.9. Plans may be paid from the credit for such a gain,
 * but no overdraft is allowed for it (learn/learner.h). */
static double by_owners(const struct findings *it) {
    const double waiting = it->fetched ? LEARN_CLEAR * LEARN_BETTER : 1;
    return waiting * (it->threads > 1 ? LEARN_CONTENDED
                      : it->lanes     ? (LEARN_CLEAR + LEARN_BETTER) / 2
                                      : 1);
}

/* The cost of starting new runs of iterations (`runs` in cost_model.h), in seconds per iteration.
 * The runs are assumed to be divided evenly among the threads. */
static double beginning_runs(const struct findings *it) {
    return it->runs * 3 * LEARN_TOUCH / it->threads;
}

/* Seconds to record an iteration: the time for its touches or, if that is longer, the time of its
 * slice. */
static double recording(const struct findings *it) {
    const double touches = it->touches * LEARN_TOUCH;
    return touches > it->slice.recorded ? touches : it->slice.recorded;
}

/* Seconds to sweep an iteration. Consecutive iterations that touch only one owner's range are
 * compared, not recorded. */
static double sweeping(const struct findings *it) {
    const double apart = it->runs < LEARN_FREQUENT ? it->runs / LEARN_FREQUENT : 1;
    const double alike = it->slice.compared > 0 ? it->slice.compared : recording(it);
    return alike + apart * (recording(it) - alike) + it->runs * 2 * LEARN_ROW;
}

static void by_copies(const struct findings *it, struct arm *arm) {
    const double trip = (double)it->trip;
    arm->possible = it->copied > 0;
    arm->set_up = it->spent + recording(it) * trip;
    arm->execution = it->sequential * LEARN_CONTENDED / it->threads +
                     it->copied * (it->reusable ? LEARN_BYTE : 4 * LEARN_BYTE) / trip;
}

/* Estimates owners by address. If an iteration touches other owners than the iteration before, it
 * begins a new run, and must check the owner of each row that it writes. Therefore it costs
 * more. */
static void by_index(const struct findings *it, struct arm *arm) {
    const double apart = it->runs < LEARN_FREQUENT ? it->runs / LEARN_FREQUENT : 1;
    arm->possible = true;
    arm->set_up = it->spent + sweeping(it) * (double)it->trip / it->threads;
    arm->execution =
        it->sequential * by_owners(it) * it->share * (1 + apart * (LEARN_CONTENDED - 1)) +
        beginning_runs(it);
}

/* Estimates owners by the access graph. They are not used if owners by address are balanced, or if
 * a plan would be executed only once. Loops over pairs do not use them either, because their graph
 * has no good partition. */
static void by_graph(const struct findings *it, struct arm *arm) {
    const double side_by_side = recording(it) + it->touches * 6 * LEARN_TOUCH +
                                it->further_rows * LEARN_ROW + it->leading_rows * 1.5 * LEARN_ROW;
    const double alone = it->leading_rows * 1.25 * LEARN_ROW;
    arm->possible = it->reusable && !it->tiled && it->share * it->threads > LEARN_CONTENDED;
    arm->set_up = it->spent + (side_by_side / it->threads + alone) * (double)it->trip;
    arm->execution =
        it->sequential * by_owners(it) * LEARN_CONTENDED / it->threads + beginning_runs(it);
}

static void directly(const struct findings *it, struct arm *arm) {
    arm->possible = it->direct > 0;
    arm->execution = it->sequential * by_owners(it) * it->direct;
}

/* The cost of pushing and applying records is known only after a trial. */
static void by_bins(const struct findings *it, struct arm *arm) {
    arm->possible = it->binned;
    arm->guessed = !it->bins_known;
    arm->execution =
        it->sequential * LEARN_CONTENDED / it->threads + it->bin_more / (double)it->trip;
}

void redcc_estimate_arms(const struct findings *findings, struct arm *arm) {
    assert(findings->trip > 0 && findings->threads >= 1);
    const double trip = (double)findings->trip;
    const double checked = findings->checked * LEARN_BYTE / 3 / findings->threads / trip;
    for (enum way way = 0; way < WAY_COUNT; way++)
        arm[way] = (struct arm){0};
    by_copies(findings, &arm[WAY_COPIES]);
    by_index(findings, &arm[WAY_INDEX]);
    by_graph(findings, &arm[WAY_GRAPH]);
    directly(findings, &arm[WAY_DIRECT]);
    by_bins(findings, &arm[WAY_BINS]);
    /* a plan that cannot be kept is used only once */
    for (enum way way = WAY_COPIES; redcc_is_planned(way); way++)
        arm[way].execution += findings->reusable ? checked : arm[way].set_up / trip;
}
