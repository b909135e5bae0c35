/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Ownership cut from the access graph: each unit of the reduction arrays gets an owner, so that few
 * iterations touch units of several owners and every owner has as much to do.
 *
 *     told       what each iteration touches, by the inspector                 all threads
 *     clusters   of some dozens of units of the leading group                  all threads
 *     coarse     the graph of the clusters                                     all threads
 *     divided    by bisection, refined                                         one thread
 *     rims       the graph of the units where parts meet                       all threads
 *     refined    there, unit by unit                                           one thread
 *     further    groups: a unit gets an owner that its iterations have anyway  all threads
 *     summary    which owners each iteration touches                           all threads
 *
 * The result depends on the loop and the number of owners alone.
 */
#ifndef REDCC_DIVIDE_H
#define REDCC_DIVIDE_H

#include "base/barrier.h"
#include "ownership/graph/clusters.h"
#include "ownership/graph/neighbours.h"
#include "ownership/sweep.h"

enum { REDCC_OWNERS_MOST = 256 }; /* of a map */

/** Where parts meet. */
struct rims {
    unsigned char *is_rim;         /* [units.leading] an iteration touches it and another part */
    struct unit_list *list;        /* [threads] iterations that touch such a unit */
    const struct unit_list **told; /* [threads] lists that a graph is made of */
    struct graph graph;            /* of these units alone */
};

struct divide {
    const struct partition *partition; /* how many owners there are to be */
    int threads;
    struct barrier *barrier;
    struct units units;
    size_t most_told;     /* touches that a thread may tell */
    struct told *told;    /* [threads] */
    struct sweep *sweep;  /* [threads] the result: the access summaries */
    unsigned char *owner; /* [units.count] the result: the owner of each unit */
    /* on the way there */
    struct clusters clusters;
    struct graph coarse;
    unsigned char *part; /* [clusters.count] */
    struct rims rims;
    atomic_ushort *vote; /* [units.count - units.leading] */
    double deadline;     /* on the clock of redcc_seconds, looked at where all meet; 0: none */
    atomic_bool failed;
    bool clustered; /* there are few enough clusters */
    bool going;     /* nobody has failed so far, and it is not late */
};

enum divide_result {
    DIVIDE_DONE,
    DIVIDE_NO_MEMORY,  /* or late */
    DIVIDE_UNSUITABLE, /* too many units, touches or owners to be worth it, or none */
    DIVIDE_BEYOND      /* something else was touched than what has a number */
};

/** May the arrays be divided so, group g being touched in touched[g] at most, by about `touches`
 * touches in all? Takes what the threads need to begin; end it all the same. */
enum divide_result redcc_divide_begin(struct divide *divide, const struct partition *partition,
                                      const struct range *touched, int threads, redcc_int trip,
                                      double touches);

/** Each thread's part, when all have told their iterations; all call it, and each gets the same
 *  result. seen [array_count] is the thread's. */
enum divide_result redcc_divide(struct divide *divide, int thread, struct range *seen);

/** The same parts with what is stealable joined to the owner before it, as the partition has them
 * now. Each thread's part; all call it, and each gets the same result. */
enum divide_result redcc_divide_join(struct divide *divide, int thread, struct range *seen);

/** Gives back what was taken on the way to the result. */
void redcc_divide_tidy(struct divide *divide);

/** Gives back all memory but what was taken out of it. */
void redcc_divide_end(struct divide *divide);

#endif
