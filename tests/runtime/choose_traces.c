/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose_traces.h"

#include <stdlib.h>

uint64_t random_state;

double uniform(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (double)(random_state >> 11) * 0x1p-53;
}

struct trace *ordinary(int count) {
    struct trace *trace = calloc(1, sizeof *trace);
    *trace = (struct trace){.count = count,
                            .set_up_error = 1,
                            .execution_error = 1,
                            .look = 0.3e-3,
                            .check = 0.2,
                            .wake = 10e-6,
                            .block = 50e-6};
    trace->possible[WAY_INDEX] = trace->possible[WAY_GRAPH] = true;
    trace->set_up[WAY_INDEX] = 5e-9;
    trace->set_up[WAY_GRAPH] = 20e-9;
    for (int c = 0; c < count; c++) {
        trace->call[c] = (struct simulated_call){.trip = 1000000, .sequential = 10e-3};
        trace->call[c].execution[WAY_INDEX] = 6.5e-3;
        trace->call[c].execution[WAY_GRAPH] = 5.5e-3;
    }
    return trace;
}

void scale(struct simulated_call *call, double sequential, double parallel) {
    call->sequential *= sequential;
    for (enum way way = 0; way < WAY_COUNT; way++)
        call->execution[way] *= parallel;
}
