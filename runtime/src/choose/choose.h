/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * REDCC_METHOD=auto: serial or parallel, and which method. rule.h has the table.
 *
 * Executions are timed, and for each size of a loop (trip counts between two powers of two) the
 * faster course is kept. Who waits in a serial course tries again, at growing distances. Cutting
 * the access graph, which takes as long as several executions, waits until the budget (budget.h)
 * allows it; meanwhile the loop runs as it would without. Used by one thread at a time: the one
 * that holds the loop.
 */
#ifndef REDCC_CHOOSE_H
#define REDCC_CHOOSE_H

#include "base/reason.h"
#include "choose/rule.h"
#include "ownership/estimate.h"
#include "plan/method.h"

enum course {
    COURSE_UNDECIDED,
    COURSE_SERIAL,  /* the original loop */
    COURSE_SOLO,    /* one thread of the region executes all, in order, timed */
    COURSE_PARALLEL /* a method */
};

/** Seconds that cutting the access graph takes for a touch. */
static const double redcc_graph_touch = 40e-9;

/** How a parallel execution with spare parts begins: its first thread may execute its first spare
 *  part before all else, timed, while the others wait or do what is theirs. The one over the other
 *  is how much company slows a thread down, from which follows how long one thread would take for
 *  the loop: without a sequential execution, which takes as long as many parallel ones. */
enum pace { PACE_UNTIMED, PACE_ALONE, PACE_BESIDE };

/** What was timed so. */
struct pace_trial {
    int timed;     /* executions: alone, beside, alone, beside */
    bool given_up; /* a sequential execution will tell */
    /* seconds, the shorter of two: */
    double alone;
    double beside;
    double working; /* of all threads together, less what was executed twice; beside */
};

/** How far ownership by the access graph has come. TRIED: it and what there was before take turns,
 *  so that both meet the machine as it is now. */
enum graph_state { GRAPH_UNTRIED, GRAPH_TRIED, GRAPH_KEPT, GRAPH_LOST };

struct graph_trial {
    enum graph_state state;
    int tries;         /* TRIED: executions so far; KEPT: 0 once plans of other methods are gone */
    int rival_tries;   /* TRIED: executions of what there was before */
    double seconds;    /* that cutting the graph will take; 0: not known, or not to be done */
    double best;       /* seconds an iteration */
    double rival_best; /* the same */
    long runs;         /* executions since it was cut */
    long rest;         /* calls that it rested when it was cut in vain */
    long retry_at;
};

/** What is known of a loop at trip counts of one size. */
struct trial {
    enum course decided; /* UNDECIDED, SERIAL or PARALLEL; of all but the graph */
    enum reason reason;  /* for SERIAL */
    enum rule rule;      /* that decided */
    int threads;
    int serial_tries;
    int parallel_tries;
    struct pace_trial pace;
    int slow;         /* executions in turn in which PARALLEL took longer than serial_best */
    double slow_best; /* of them; seconds an iteration */
    bool doubted;     /* they were many: the sequential loop is timed once more */
    long calls;
    long retry_at;      /* SERIAL: this call tries again */
    long rest;          /* how many calls the last decision for SERIAL rested */
    double serial_best; /* seconds an iteration */
    double parallel_best;
    double sweep_seconds; /* that an inspection was deferred for; 0: none was */
    struct graph_trial graph;
};

struct chooser {
    struct trial trial[64]; /* by the logarithm of the trip count */
};

/** What to do in this call. */
struct choice {
    enum course course;
    bool by_graph;      /* PARALLEL: by a plan with owners cut from the access graph ... */
    bool graph_settled; /* ... which has just been decided: other plans need not stay beside it */
    enum pace pace;     /* PARALLEL, by a plan with spare parts */
    long rested;        /* PARALLEL: how many calls were SERIAL before it was tried again */
    enum reason reason; /* for SERIAL */
    enum rule rule;
};

/** Is nothing to be decided in this call, whatever the budget: is it one of those that are left to
 *  the sequential loop? Then *choice is redcc_choose_course's, in a tenth of the time: loops of a
 *  hundred iterations may be executed millions of times. */
bool redcc_choose_rests(struct chooser *chooser, redcc_int trip, int threads,
                        struct choice *choice);

/** `budget` is redcc_budget(). */
struct choice redcc_choose_course(struct chooser *chooser, redcc_int trip, int threads,
                                  double budget);

/** How long a SOLO or PARALLEL course took; by_graph: with owners cut from the access graph.
 * Returns the seconds gained over the sequential loop, 0 where that is not yet known. */
double redcc_choose_learn(struct chooser *chooser, redcc_int trip, enum course course,
                          bool by_graph, double seconds);

/** How long the first spare part took in an execution of that pace, and all threads together for
 * the loop, what was executed twice left out. To be told before redcc_choose_learn. */
void redcc_choose_learn_pace(struct chooser *chooser, redcc_int trip, enum pace pace, double part,
                             double working);

/** The course could not be taken (a guard, too much replication, memory). */
void redcc_choose_refused(struct chooser *chooser, redcc_int trip, enum reason reason);

/** What an inspection found. */
struct findings {
    redcc_int trip;
    int threads;
    double share;   /* of the iterations, by the thread that would execute most by LOCALWRITE */
    double touches; /* of all iterations, about */
    bool swept;     /* the share is exact; else by a sample */
    double runs;    /* stretches of iterations alike, of all threads; else no more than these */
    bool copies;    /* private copies may and can be had */
    double copied;  /* bytes of one of them */
    bool reusable;  /* the plan will be kept; by a sample: may be */
    bool by_graph;  /* the choice was by_graph */
    double budget;
};

/** The row that a loop of these findings falls under: CHEAP_COPIES, TIMED, COSTLY, EVEN, GRAPH,
 * INDEX, COPIES, DEFERRED, SERIAL. */
enum rule redcc_choose_way(struct chooser *chooser, const struct findings *findings);

/** Are spare owners (ownership/partition.h) worth what they cost, of which *found tells share,
 * spared and changes? */
bool redcc_choose_spares(const struct chooser *chooser, redcc_int trip, int threads,
                         const struct estimate *found);

/** The row that decided last. */
enum rule redcc_choose_rule(const struct chooser *chooser, redcc_int trip);

/** The owners could not be cut from the access graph after all. */
void redcc_choose_no_graph(struct chooser *chooser, redcc_int trip);

/** Instead of owners cut from the access graph the iterations were put in levels: noted as the row
 *  that decided. */
void redcc_choose_levels(struct chooser *chooser, redcc_int trip);

/** How many of `threads` are worth waking for a loop of `trip` iterations that no sequential loop
 * can be timed against, since none gives its sums. seconds: what `iterations` of it have taken so
 * far. */
int redcc_worth_threads(redcc_int trip, int threads, double seconds, redcc_int iterations);

#endif
