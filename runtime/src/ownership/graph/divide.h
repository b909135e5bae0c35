/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Ownership cut from the access graph: each unit of the reduction arrays gets an owner, so that few
 * iterations touch units of several owners and the load is balanced.
 *
 *     logged     the access log of the inspector                               all threads
 *     clusters   of some dozens of units of the leading group                  all threads
 *     coarse     the graph of the clusters                                     all threads
 *     divided    by bisection, refined                                         one thread
 *     boundary   the graph of the units at boundaries between parts            all threads
 *     refined    these units are moved one by one                              one thread
 *     further    units of other groups get owners that their iterations have   all threads
 *     summary    the owners that each iteration touches                        all threads
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
    struct graph graph;              /* of the boundary units only */
};

struct divide {
    const struct partition *partition; /* defines groups and the number of owners */
    int threads;
    struct barrier *barrier;
    struct units units;
    size_t most_logged;        /* a log's list of this many items does not grow */
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
    bool clustered; /* redcc_clusters_join has returned false */
    bool going;     /* no thread has failed, and the deadline has not passed */
};

enum divide_result {
    DIVIDE_DONE,
    DIVIDE_NO_MEMORY,  /* out of memory, or after the deadline */
    DIVIDE_UNSUITABLE, /* too many units, iterations, touches or owners, or no units */
    DIVIDE_BEYOND      /* there was a touch outside of the numbered units */
};

/** Begins, and checks whether the arrays can be divided, if group g is touched at most in
 * touched[g], with about `touches` touches in total. Allocates the threads' initial memory; call
 *  redcc_divide_end in any case. */
enum divide_result redcc_divide_begin(struct divide *divide, const struct partition *partition,
                                      const struct range *touched, int threads, redcc_int trip,
                                      double touches);

/** Divides, after all threads have recorded their iterations. All call it, and get the same result.
 *  seen [array_count] belongs to the thread. */
enum divide_result redcc_divide(struct divide *divide, int thread, struct range *seen);

/** Joins stealable blocks to the preceding owners in the division, after this was done in the
 *  partition. All threads call it, and get the same result. */
enum divide_result redcc_divide_join(struct divide *divide, int thread, struct range *seen);

/** Frees intermediate results. */
void redcc_divide_tidy(struct divide *divide);

/** Frees all memory except results that were moved out. */
void redcc_divide_end(struct divide *divide);

#endif
