/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the phases of an inspection share (inspect.c, sampling.c, gather.c). */
#ifndef REDCC_INSPECT_H
#define REDCC_INSPECT_H

#include "loop.h"
#include "ownership/estimate.h"

/** The iterations that a member inspects: a consecutive share, [begin, end). */
redcc_int redcc_own_begin(const struct member *member);
redcc_int redcc_own_end(const struct member *member);

/** Has the worker tell iterations first, first + stride, ... < last; returns 1. A touch within
 *  `window` [array_count] makes no entry. */
int redcc_hand_out(redcc_worker *worker, redcc_int first, redcc_int last, redcc_int stride,
                   const redcc_owner *window);

/** To be called by one thread, while the others wait: nothing is to be done in parallel. */
void redcc_refuse(struct execution *execution, enum reason reason);

/** Has some thread run out of memory? */
bool redcc_some_failed(const struct execution *execution);

/** A partition for as many owners as the sample is to cut the arrays for, and room for those that
 *  auto may come to. False: no memory. */
bool redcc_begin_partition(struct execution *execution);

/** Hands out the member's iterations of the sample; returns 0 where there are none. */
int redcc_hand_out_sample(redcc_worker *worker);

/** Takes what was told of the sample, up to `end`. */
void redcc_take_sample(struct member *member, const redcc_entry *end);

/** To be called by one thread, when the sample is told: cuts, and sends all on. */
void redcc_after_sample(struct execution *execution);

/** To be called by one thread: sends all to a sweep with groups that do not overlap, as far as is
 *  known, newly cut by the sample; or, as auto sees by it, on by other means. */
void redcc_cut_and_sweep(struct execution *execution);

/** What the threads touched, by group, into execution->touched. */
void redcc_gather_touched(struct execution *execution);

/** How many iterations all owners execute, as the members have counted them (member.executed). */
redcc_int redcc_executed_in_all(const struct execution *execution);

/** What of the iterations the thread has that would execute most by LOCALWRITE, as the members have
 *  counted them (member.executed). */
double redcc_largest_share(const struct execution *execution);

/** The row of auto's table by the sample. */
enum rule redcc_find_way(struct execution *execution, const struct estimate *estimate);

/** The method that follows when all iterations are told. NULL: one thread executes all. */
const struct method *redcc_find_method(struct execution *execution);

/** Do memory and what is touched allow private copies? */
bool redcc_copies_allowed(const struct execution *execution);

/** To be called by one thread, when all iterations are told: the method named or chosen by what was
 *  found, and on to its plan. */
void redcc_choose_and_go_on(struct execution *execution);

/** To be called by one thread, when all iterations are told: an empty plan by the method chosen,
 *  and all go on to prepare it. */
void redcc_make_plan(struct execution *execution);

/** To be called by one thread, instead of redcc_make_plan: sends all to tell their iterations once
 *  more, for ownership by the access graph; where that cannot be had, on by other means. False: to
 *  redcc_make_plan. */
bool redcc_begin_gathering(struct execution *execution);

/** A member's steps on that way, by phase: GATHER, GATHERING (returns 1 where iterations are to be
 *  told), DIVIDE and JOIN. */
void redcc_gather(struct member *member);
int redcc_gathering(redcc_worker *worker);
void redcc_divide_share(struct member *member);
void redcc_join_share(struct member *member);

#endif
