/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Chooses owners by partitioning the access graph. Each unit of the reduction arrays gets an owner,
 * so that few iterations touch units of several owners and the load is balanced. The steps are:
 *
 *     logged     the access log of the inspector                               all threads
 *     clusters   of some dozens of units of the leading group                  all threads
 *     coarse     the graph of the clusters                                     all threads
 *     divided    by bisection, refined                                         one thread
 *     boundary   the graph of the units at boundaries between parts            all threads
 *     refined    these units are moved one by one                              one thread
 *     further    units of other groups get the owners of their iterations      all threads
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

/** The boundaries between the parts of different owners. */
struct boundary {
    unsigned char *is_boundary; /* [units.leading] does an iteration touch both this unit and a unit
                                   of another owner? Such units are boundary units */
    struct unit_list *list;     /* [threads] the iterations that touch a boundary unit */
    const struct unit_list **logged; /* [threads] the lists from which a graph is built */
    struct graph graph;              /* the graph of the boundary units */
};

struct divide {
    const struct partition *partition; /* defines the groups and the number of owners */
    int threads;
    struct barrier *barrier;
    struct units units;
    size_t most_logged;        /* maximum number of items of a list of a thread's log */
    struct access_log *logged; /* [threads] the access logs */
    struct sweep *sweep;       /* [threads] a result: the access summaries */
    unsigned char *owner;      /* [units.count] a result: the owner of each unit */
    /* Intermediate results: */
    struct clusters clusters;
    struct graph coarse;
    unsigned char *part; /* [clusters.count] the owner of each cluster */
    struct boundary boundary;
    atomic_ushort *vote; /* [units.count - units.leading] for each unit that is not in the leading
                            group: the winning vote */
    double deadline; /* a time on the clock of redcc_seconds, checked at barriers; 0: no deadline */
    atomic_bool failed;
    bool clustered; /* redcc_clusters_join has returned false */
    bool going;     /* no thread has failed, and the deadline has not passed */
};

enum divide_result {
    DIVIDE_DONE,
    DIVIDE_NO_MEMORY,  /* out of memory, or the deadline has passed */
    DIVIDE_UNSUITABLE, /* there are too many units, iterations, touches or owners, or no units */
    DIVIDE_BEYOND      /* there was a touch outside of the numbered units */
};

/** Begins a division. All touches of group g lie within touched[g], and there are about `touches`
 * in total. Checks whether the arrays can be divided, and allocates the threads' initial
 * memory. Call redcc_divide_end in any case. */
enum divide_result redcc_divide_begin(struct divide *divide, const struct partition *partition,
                                      const struct range *touched, int threads, redcc_int trip,
                                      double touches);

/** Divides the units, after all threads have recorded their iterations. All threads call this
 * function, and get the same result. seen[array_count] has the ranges that the thread has touched,
 * and belongs to the caller. */
enum divide_result redcc_divide(struct divide *divide, int thread, struct range *seen);

/** Called after redcc_partition_join_stealable: merges the units of stealable blocks into the
 * owners before them, and summarises the iterations again. All threads call this function, and get
 * the same result. */
enum divide_result redcc_divide_join(struct divide *divide, int thread, struct range *seen);

/** Frees intermediate results. */
void redcc_divide_tidy(struct divide *divide);

/** Frees all memory except results that the caller has taken. */
void redcc_divide_end(struct divide *divide);

#endif
