/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Ownership cut from the access graph: each unit of the reduction arrays gets an owner, so that few
 * iterations touch units of several owners and the load is balanced.
 *
 *     logged       the access log of the inspector                               all threads
 *     clusters   of some dozens of units of the leading group                  all threads
 *     coarse     the graph of the clusters                                     all threads
 *     divided    by bisection, refined                                         one thread
 *     boundary   the graph of the units at boundaries between parts            all threads
 *     refined    there, unit by unit                                           one thread
 *     further    groups: a unit gets an owner that its iterations have anyway  all threads
 *     summary    which owners each iteration touches                           all threads
 *
 * The result depends only on the loop and the number of owners.
 */
#ifndef REDCC_DIVIDE_H
#define REDCC_DIVIDE_H

#include "base/barrier.h"
#include "ownership/graph/clusters.h"
#include "ownership/graph/neighbours.h"
#include "ownership/sweep.h"

/** Boundaries between parts. */
struct boundary {
    unsigned char *is_boundary;      /* [units.leading] an iteration touches it and another part */
    struct unit_list *list;          /* [threads] iterations that touch such a unit */
    const struct unit_list **logged; /* [threads] lists from which the graph is built */
    struct graph graph;              /* of only these units */
};

struct divide {
    const struct partition *partition; /* has the number of owners */
    int threads;
    struct barrier *barrier;
    struct units units;
    size_t most_logged;        /* maximum touches in a thread's log */
    struct access_log *logged; /* [threads] */
    struct sweep *sweep;       /* [threads] the result: the access summaries */
    unsigned char *owner;      /* [units.count] the result: the owner of each unit */
    /* intermediate results */
    struct clusters clusters;
    struct graph coarse;
    unsigned char *part; /* [clusters.count] */
    struct boundary boundary;
    atomic_ushort *vote; /* [units.count - units.leading] */
    double deadline;     /* on the clock of redcc_seconds, checked at barriers; 0: none */
    atomic_bool failed;
    bool clustered; /* there are few enough clusters */
    bool going;     /* no thread has failed so far, and the deadline has not passed */
};

enum divide_result {
    DIVIDE_DONE,
    DIVIDE_NO_MEMORY,  /* or late */
    DIVIDE_UNSUITABLE, /* too many units, touches or owners to pay off, or none */
    DIVIDE_BEYOND      /* a touch outside of the numbered units */
};

/** Can the arrays be divided, if group g is touched at most in touched[g], by about `touches`
 *  touches in all? Allocates the threads' initial memory; call redcc_divide_end in any case. */
enum divide_result redcc_divide_begin(struct divide *divide, const struct partition *partition,
                                      const struct range *touched, int threads, redcc_int trip,
                                      double touches);

/** Each thread's part, after all have recorded their iterations; all call it and get the same
 *  result. seen [array_count] belongs to the thread. */
enum divide_result redcc_divide(struct divide *divide, int thread, struct range *seen);

/** The same division with stealable blocks joined to the preceding owner, as they are in the
 *  partition now. Each thread's part; all call it and get the same result. */
enum divide_result redcc_divide_join(struct divide *divide, int thread, struct range *seen);

/** Frees intermediate results. */
void redcc_divide_tidy(struct divide *divide);

/** Frees all memory except results that were moved out. */
void redcc_divide_end(struct divide *divide);

#endif
