/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Statistics of all iterations of the loop, computed from the access summaries. */
#include "inspect/inspection.h"

#include <assert.h>

double redcc_count_runs(const struct inspection *inspection) {
    size_t runs = 0;
    for (int thread = 0; thread < inspection->call->threads; thread++)
        runs += inspection->inspector[thread]->sweep.summary.span_count;
    return (double)runs;
}

static redcc_int executed_by(const struct inspection *inspection, uint32_t owner) {
    redcc_int sum = 0;
    for (int thread = 0; thread < inspection->call->threads; thread++)
        sum += inspection->inspector[thread]->executed[owner];
    return sum;
}

redcc_int redcc_executed_in_all(const struct inspection *inspection) {
    redcc_int sum = 0;
    for (uint32_t owner = 0; owner < inspection->partition.owners; owner++)
        sum += executed_by(inspection, owner);
    return sum;
}

redcc_int redcc_executed_joined(const struct inspection *inspection) {
    redcc_int sum = 0;
    for (int thread = 0; thread < inspection->call->threads; thread++)
        sum += redcc_sweep_executed(&inspection->divide.sweep[thread],
                                    1 + inspection->partition.stealable);
    return sum;
}

double redcc_largest_share(const struct inspection *inspection) {
    const struct partition *partition = &inspection->partition;
    assert(partition->owners >= 1);
    redcc_int most = 0;
    for (uint32_t owner = 0; owner < partition->owners; owner++) {
        const redcc_int executed = executed_by(inspection, owner);
        most = executed > most ? executed : most;
    }
    const double even = partition->stealable
                            ? (double)redcc_executed_in_all(inspection) / inspection->call->threads
                            : 0;
    return (even > (double)most ? even : (double)most) / (double)inspection->call->request.trip;
}
