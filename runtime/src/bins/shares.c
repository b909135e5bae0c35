/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "bins/shares.h"

#include "base/share.h"
#include "plan/share_count.h"

#include <assert.h>

/* The size in bytes of a private copy of all rows found so far. */
static uint64_t copy_bytes(const struct binning *binning) {
    const uint64_t most_rows = (uint64_t)1 << 40;
    const uint32_t count = binning->loop->stream_count;
    uint64_t bytes = 0;
    for (uint32_t s = 0; s < count; s++) {
        const struct row_range rows = binning->known[count + s].rows;
        if (redcc_rows_empty(rows))
            continue;
        const uint64_t span = (uint64_t)rows.highest - (uint64_t)rows.lowest + 1;
        if (span == 0 || span > most_rows)
            return UINT64_MAX;
        bytes += span * redcc_stream_row(&binning->loop->streams[s]);
    }
    return bytes;
}

/* The number of updates: that of the first sample, or the estimate by flags if that is more. */
static double updates_of(const struct binning *binning, redcc_int trip) {
    const redcc_loop *loop = &binning->loop->loop;
    const uint32_t count = binning->loop->stream_count;
    const double estimate = redcc_updates(loop, trip);
    double updates = 0;
    for (uint32_t s = 0; s < count; s++)
        updates += binning->known[count + s].rate * (double)trip;
    return loop->flags & REDCC_SHORT || updates < estimate ? estimate : updates;
}

int redcc_bins_shares(const struct binning *binning, redcc_int trip, size_t memory_limit) {
    if (binning->copies.are_denied)
        return 0;
    return redcc_share_count(&binning->loop->loop, trip, updates_of(binning, trip),
                             copy_bytes(binning), memory_limit);
}

static bool is_free(struct binning *binning, unsigned share) {
    const unsigned bit = 1u << share;
    return !(atomic_fetch_or_explicit(&binning->next_bin, bit, memory_order_relaxed) & bit);
}

bool redcc_shares_take(struct binning *binning, struct binner *binner) {
    const unsigned shares = (unsigned)binning->copies.count;
    const unsigned own =
        (unsigned)redcc_share((redcc_int)shares, binner->threads, binner->thread) % shares;
    const struct round *round = &binning->round;
    assert(2 <= shares && shares <= REDCC_MOST_SHARES && binning->binners >= (int)shares);
    for (unsigned k = 0; k < shares; k++) {
        const unsigned share = (own + k) % shares;
        if (!is_free(binning, share))
            continue;
        struct binner *holder = binning->binner[share];
        for (uint32_t s = 0; s < binning->loop->stream_count; s++)
            redcc_buffer_clear(&holder->buffer[s]);
        if (binning->copies.need_filling)
            redcc_private_fill(binning, holder);
        binner->holder = holder;
        assert(round->begin == 0);
        binner->next = redcc_share_begin(round->end, (int)shares, (int)share);
        binner->last = redcc_share_begin(round->end, (int)shares, (int)share + 1);
        return true;
    }
    return false;
}
