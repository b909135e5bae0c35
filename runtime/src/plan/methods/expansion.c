/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Array expansion: each thread executes an equal share of the iterations and writes to its own copy
 * of the whole array. At the end each thread merges one block of all copies into the array. The
 * merge goes copy after copy (figure 9 (b) of the paper, docs/paper.md; the default) or element
 * after element (figure 9 (a)).
 */
#include "plan/methods/shares.h"

#include <string.h>

static int parse(const char *text) {
    return strcmp(text, "a") == 0 || strcmp(text, "b") == 0 ? text[0] : 0;
}

const struct method redcc_method_expansion = {.name = "expansion",
                                              .parameter = "a|b",
                                              .keeps = REDCC_ORDER_ANY,
                                              .copies = COPY_WHOLE,
                                              .parse = parse,
                                              .usual = 'b',
                                              .owners = redcc_one_owner,
                                              .prepare = redcc_shares_prepare};
