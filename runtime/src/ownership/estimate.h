/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESTIMATE_H
#define REDCC_ESTIMATE_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/* Averages per iteration of the sample. */
struct touching {
    double touches;
    double records;      /* touches, with a block of rows counted as one */
    double leading_rows; /* number of different rows of the leading group */
    double further_rows; /* number of different rows of the other groups */
};

struct estimate {
    double share;  /* fraction of the iterations that the most loaded share executes. A share is an
                      owner with its stealable blocks */
    double direct; /* `share` for threads that find their iterations during execution. Votes may
                      then have chosen the owners (owner_map.h) */
    double overhead; /* number of additional executions of iterations because of stealable blocks,
                        divided by the number of iterations */
    struct touching each; /* averages per iteration */
    double changes; /* fraction of the sampled iterations whose lowest or highest owner differs from
                       that of the sampled iteration before. It is roughly an upper bound of the
                       fraction that begins a run */
    double share_changes; /* `changes` without stealable blocks: from share to share */
};

/** Computes statistics of the samples of `threads` threads, for a partition that is cut or has a
 * map. If the samples lack some touches of an iteration, `share` is too low. Returns false if out
 * of memory. */
bool redcc_estimate(const struct partition *partition, const struct sample *const *sample,
                    int threads, struct estimate *estimate);

#endif
