/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESTIMATE_H
#define REDCC_ESTIMATE_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/* Average touches of an iteration in the sample. */
struct touching {
    double touches;
    double records;      /* the same, but a block's as one */
    double leading_rows; /* of the leading group, at different addresses */
    double further_rows; /* of the others */
};

struct estimate {
    double share;         /* fraction of the iterations of the most loaded share (an owner with its
                           * stealable blocks) */
    double direct;        /* the same if threads find their iterations during execution: then owners
                           * by votes are possible */
    double overhead;      /* fraction of the iterations that are replicated because of stealable
                           * owners */
    struct touching each; /* per iteration */
    double changes; /* fraction of the iterations that touch other owners than the preceding sampled
                     * one. Those in between may be equal, so it is roughly an upper bound on the
                     * fraction that begins a run */
};

/** Statistics of the samples of `threads` threads for a partition that is cut, or has a map. If the
 *  sample lacks some of an iteration's touches, the share is too low. False: no memory. */
bool redcc_estimate(const struct partition *partition, const struct sample *const *sample,
                    int threads, struct estimate *estimate);

#endif
