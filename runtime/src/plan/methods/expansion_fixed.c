/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Array expansion with N copies for any number of threads. The iterations are divided into N equal
 * shares, each of which has a copy of the whole array, and the copies are merged in order. The
 * result has the same bits at every number of threads. At most N threads are busy.
 */
#include "plan/methods/shares.h"

#include <stdlib.h>

enum { USUAL = 16, MOST = 1024 };

static int parse(const char *text) {
    char *end;
    const long copies = strtol(text, &end, 10);
    return end != text && *end == '\0' && copies >= 1 && copies <= MOST ? (int)copies : 0;
}

const struct method redcc_method_expansion_fixed = {.name = "expansion-fixed",
                                                    .parameter = "N",
                                                    .keeps = REDCC_ORDER_FIXED,
                                                    .copies = COPY_SHARE,
                                                    .parse = parse,
                                                    .usual = USUAL,
                                                    .owners = redcc_one_owner,
                                                    .prepare = redcc_fixed_shares_prepare};
