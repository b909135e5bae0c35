/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESTIMATE_H
#define REDCC_ESTIMATE_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/* Averages per iteration of the sample. */
struct touching {
    double touches;
    double records;      /* the same, with a block of rows counted as one */
    double leading_rows; /* different rows of the leading group */
    double further_rows; /* different rows of the other groups */
};

struct estimate {
    double share;    /* fraction of the iterations that the most loaded share executes (a share:
                      * an owner with its stealable blocks) */
    double direct;   /* the same if threads find their iterations during execution; their owners may
                        be chosen by votes */
    double overhead; /* fraction of the iterations that are replicated because of stealable
                      * blocks */
    struct touching each; /* averages per iteration */
    double changes; /* fraction of the sampled iterations whose lowest or highest owner differs from
                       the preceding sampled one's: roughly an upper bound on the fraction that
                       begins a run */
};

/** Computes statistics of the samples of `threads` threads for a partition that is cut, or has a
 * map. If samples lack some touches of an iteration, `share` is too low. False: out of memory. */
bool redcc_estimate(const struct partition *partition, const struct sample *const *sample,
                    int threads, struct estimate *estimate);

#endif
