/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * binning: in-order binning (propagation blocking). The iterations are executed in rounds. Each
 * thread executes an equal share of a round's iterations and appends its updates to bins of rows.
 * Then one thread applies the updates of each bin, in the order of the loop. There are two
 * variants, `records` (records in bins) and `copies` (private copies, for small arrays of
 * integers). By default the runtime chooses between them.
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
