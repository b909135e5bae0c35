/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * binning: in-order binning (propagation blocking). Each thread executes an equal share of a
 * round's iterations and appends its updates to bins of rows. Then each bin's updates are applied
 * by one thread, in the order of the loop. By default the runtime chooses between two variants,
 * which `records` and `copies` select: records in bins or, for small arrays of integers, private
 * copies.
 *
 * Source: S. Beamer, K. Asanovic, D. Patterson, Reducing Pagerank communication via propagation
 * blocking, IPDPS 2017.
 */
#include "plan/method.h"

#include "base/bins_kind.h"

#include <string.h>

static int parse(const char *text) {
    if (strcmp(text, "records") == 0)
        return BINS_RECORDS;
    return strcmp(text, "copies") == 0 ? BINS_COPIES : 0;
}

static const char *spell(int parameter) {
    return parameter == BINS_RECORDS ? "records" : "copies";
}

const struct method redcc_method_binning = {.name = "binning",
                                            .parameter = "records|copies",
                                            .keeps = REDCC_ORDER_SERIAL,
                                            .in_bins = true,
                                            .parse = parse,
                                            .spell = spell,
                                            .usual = BINS_EITHER};
