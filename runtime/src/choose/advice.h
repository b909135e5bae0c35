/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The seam between the pipeline and what chooses: every question that REDCC_METHOD=auto answers,
 * and everything that it is told, in the order in which a call comes to it. Nothing else calls the
 * decision core (choose.h); where a method is named it is not asked, and these functions answer by
 * the method.
 *
 *     at entry              redcc_advise_rest, redcc_advise_entry
 *     after the sample      redcc_advise_sampled
 *     after the sweep       redcc_advise_swept
 *     after the log         redcc_advise_logged, redcc_tell_no_graph
 *     after the partition   redcc_advise_partitioned
 *     after the execution   redcc_tell_executed, or redcc_tell_refused
 *
 * One thread at a time uses a chooser: the one that holds the loop, or that a stage's end runs in.
 */
#ifndef REDCC_ADVICE_H
#define REDCC_ADVICE_H

#include "choose/choose.h"
#include "inspect/inspection.h"

/** What auto says at entry. */
struct advice {
    enum mode mode;     /* SERIAL, TIMED, PARALLEL, SOLO, CONTENDED */
    bool by_graph;      /* with owners cut from the access graph */
    bool drops_others;  /* other plans need not stay beside those by the graph */
    long skipped_calls; /* that were SERIAL before this one tries again */
    enum reason reason; /* for SERIAL */
    enum rule rule;
};

/** Is nothing to be decided in this call, since auto left this loop to the original one for a
 *  while? Then *advice says so; much cheaper than redcc_advise_entry. */
bool redcc_advise_rest(struct chooser *chooser, redcc_int trip, int threads, struct advice *advice);

/** For a call that redcc_advise_rest had nothing to say of. */
struct advice redcc_advise_entry(struct chooser *chooser, redcc_int trip, int threads);

/** Of the sample: what of it auto goes by. */
bool redcc_wants_estimate(const struct inspection *inspection);

/** How shall the inspection go on? SERIAL (*reason says why), TIMED, OWNERS, COPIES. May join
 *  stealable blocks of the partition to their owners, or make it one piece. */
enum route redcc_advise_sampled(struct chooser *chooser, const struct advice *entry,
                                struct inspection *inspection, const struct estimate *estimate,
                                enum reason *reason);

/** By what method, now that all iterations are told? reusable: the plan can be kept. NULL: by none,
 *  one thread executes all. */
const struct method *redcc_advise_swept(struct chooser *chooser, const struct advice *entry,
                                        const struct inspection *inspection, bool reusable);

/** Do memory and what is touched allow private copies? */
bool redcc_copies_allowed(const struct inspection *inspection);

/** All touches are kept: does it remain with `method`? May add stealable blocks to the partition.
 */
const struct method *redcc_advise_logged(const struct chooser *chooser,
                                         struct inspection *inspection,
                                         const struct method *method);

/** The owners could not be cut from the access graph after all. */
void redcc_tell_no_graph(struct chooser *chooser, struct advice *entry, redcc_int trip);

/** The owners are cut. *method stays, or changes. JOIN: the stealable blocks, which the partition
 * has no longer, are to be joined to their owners; LEVELS: inspection->levels are there to be used.
 */
enum partitioned { PARTITIONED_KEEP, PARTITIONED_JOIN, PARTITIONED_LEVELS };
enum partitioned redcc_advise_partitioned(struct chooser *chooser, struct inspection *inspection,
                                          const struct method **method);

/** What an execution took. */
struct outcome {
    redcc_int trip;
    enum mode mode;
    bool by_graph;
    double seconds;     /* TIMED: of the loop alone; else from entry on */
    double spent;       /* on an inspection without a plan */
    double block;       /* SOLO, CONTENDED: of the first stealable block */
    double working;     /* of all threads together, less what was executed twice */
    enum reason reason; /* why it executed without a plan; REASON_NONE: it had one */
};

void redcc_tell_executed(struct chooser *chooser, const struct outcome *outcome);

/** The call fell back to the original loop. */
void redcc_tell_refused(struct chooser *chooser, redcc_int trip, enum reason reason);

/** The row of auto's table that decided last. */
enum rule redcc_advice_rule(const struct chooser *chooser, redcc_int trip);

/** How many of `threads` are worth waking, where no sequential loop can be timed against; as
 *  redcc_worth_threads. */
int redcc_advise_threads(redcc_int trip, int threads, double seconds, redcc_int iterations);

#endif
