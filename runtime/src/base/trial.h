/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** An execution that may go on sequentially in the middle, and does so when it is slower. */
#ifndef REDCC_TRIAL_H
#define REDCC_TRIAL_H

struct trial {
    double usual;    /**< seconds of the sequential loop, an iteration */
    double may_lose; /**< seconds beyond that; 0: this is no trial */
};

#endif
