/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESTIMATE_H
#define REDCC_ESTIMATE_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/* What an iteration touches, in the mean of the sample. */
struct touching {
    double touches;
    double leading_rows; /* of the leading group, at different addresses */
    double further_rows; /* of the others */
};

struct estimate {
    double share;    /* of the iterations: what the owner that takes part in most of them has, the
                        stealable ones behind it included */
    double overhead; /* of the iterations: what is executed once more because of stealable owners */
    struct touching each; /* iteration */
    double changes; /* of the iterations: those that touch other owners than the one sampled before.
                       Those in between may be alike: no more than these begin a run, about */
};

/** What the samples of `threads` threads say of a partition that is cut. Where not all of an
 *  iteration's touches are in the sample, the share is too low. False: no memory. */
bool redcc_estimate(const struct partition *partition, const struct sample *const *sample,
                    int threads, struct estimate *estimate);

#endif
