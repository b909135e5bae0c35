/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The lifetime of what a loop knows of its bins, and of the threads' parts. */
#include "bins/binning.h"

#include "base/memory.h"

#include <assert.h>

bool redcc_bins_new(struct binning *binning, const redcc_loop *loop) {
    binning->loop = redcc_binned_of(loop);
    if (!binning->loop)
        return true;
    const uint32_t count = 2 * binning->loop->stream_count;
    binning->known = redcc_memory_alloc_zeroed(count, sizeof *binning->known);
    for (uint32_t s = 0; binning->known && s < count; s++)
        binning->known[s].rows = redcc_no_rows;
    binning->stream = binning->known;
    return binning->known != NULL;
}

void redcc_binner_join(struct binner *binner, int threads) {
    assert(threads >= 1);
    binner->threads = threads;
    binner->holder = binner;
    binner->phase = BINS_START;
    binner->begun = false;
}

struct binner *redcc_binner_new(const redcc_binned *loop, int thread) {
    assert(thread >= 0);
    struct binner *binner = redcc_memory_alloc_zeroed(1, sizeof *binner);
    if (!binner)
        return NULL;
    binner->thread = thread;
    binner->sources = redcc_memory_alloc_zeroed(loop->loop.source_count, sizeof *binner->sources);
    binner->buffer = redcc_memory_alloc_zeroed(loop->stream_count, sizeof *binner->buffer);
    if (binner->sources && binner->buffer)
        return binner;
    redcc_binner_free(binner, loop);
    return NULL;
}

void redcc_binner_free(struct binner *binner, const redcc_binned *loop) {
    if (!binner)
        return;
    for (uint32_t s = 0; binner->buffer && s < loop->stream_count; s++)
        redcc_buffer_end(&binner->buffer[s]);
    redcc_memory_free(binner->sources);
    redcc_memory_free(binner->buffer);
    redcc_memory_free(binner);
}

void redcc_bins_drop(struct binning *binning) {
    for (int t = 0; binning->loop && t < binning->binners; t++)
        for (uint32_t s = 0; s < binning->loop->stream_count; s++)
            redcc_buffer_end(&binning->binner[t]->buffer[s]);
}
