/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/ahead.h"

#include "redcc/steps.h"

#include "redcc/prefetch.h"

static int next_run(redcc_ahead *it) {
    for (; it->run != it->run_end; it->run++) {
        it->k = it->origin + it->run->begin;
        it->end = it->k + it->run->count_and_check / 2;
        if (it->k < it->end) {
            it->run++;
            return 1;
        }
    }
    it->k = it->end;
    return 0;
}

static void begin(redcc_ahead *it, const redcc_worker *worker, int distance) {
    *it = (redcc_ahead){.origin = worker->origin,
                        .run = worker->run,
                        .run_end = worker->run_end,
                        .calls = &redcc_ahead_library};
    for (; distance > 0; distance--)
        redcc_ahead_step(it);
}

static void copy_rows(redcc_progression *to, const redcc_progression *from, int count) {
    for (int i = 0; i < count; i++) {
        to[i] = from[i];
        for (int j = 0; j < i; j++)
            if (to[j].step == to[i].step && to[i].first - to[j].first < to[j].bytes)
                to[i].first = 0;
    }
}

static void prefetch_lines(const char *address, redcc_size bytes) {
    redcc_prefetch(address, bytes);
}

const redcc_ahead_calls redcc_ahead_library = {
    .begin = begin, .next_run = next_run, .rows = copy_rows, .prefetch = prefetch_lines};
