/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "bins/pieces.h"

#include "base/share.h"
#include "bins/shares.h"

#include <assert.h>

static int piece_count(const struct bins_share *share) {
    const redcc_int count = share->end - share->begin;
    return count < SHARE_PIECES ? (int)count : SHARE_PIECES;
}

static redcc_int piece_begin(const struct bins_share *share, int piece) {
    return share->begin + redcc_share(share->end - share->begin, piece_count(share), piece);
}

void redcc_pieces_cut(struct binning *binning) {
    const struct round *round = &binning->round;
    const int threads = binning->call->threads;
    const redcc_int count = round->end - round->begin;
    assert(count >= 0 && threads >= 1);
    for (int t = 0; t < threads; t++) {
        struct bins_share *share = &binning->binner[t]->share;
        share->begin = round->begin + redcc_share(count, threads, t);
        share->end = round->begin + redcc_share(count, threads, t + 1);
        atomic_store_explicit(&share->taken, 0, memory_order_relaxed);
    }
}

/* ---- taking ---------------------------------------------------------------------------------- */

static int pieces_left(const struct bins_share *share) {
    return piece_count(share) - atomic_load_explicit(&share->taken, memory_order_relaxed);
}

/* The share that has most pieces left; NULL: no share has any. */
static struct bins_share *fullest_share(const struct binning *binning) {
    struct bins_share *fullest = NULL;
    for (int t = 0; t < binning->call->threads; t++) {
        struct bins_share *share = &binning->binner[t]->share;
        if (pieces_left(share) > (fullest ? pieces_left(fullest) : 0))
            fullest = share;
    }
    return fullest;
}

/* Is there room for the records of a piece of `share`, another thread's share? A thread has memory
 * only for its own share. It takes other pieces only if their records very probably fit, according
 * to known rates, because a round that runs out of memory fails. */
static bool has_room(const struct binning *binning, const struct binner *binner,
                     const struct bins_share *share) {
    const redcc_int iterations = (share->end - share->begin) / piece_count(share) + 1;
    if (binner->pieces == TAKEN_PIECES)
        return false;
    for (uint32_t s = 0; !binning->copies.count && s < binning->loop->stream_count; s++)
        if (!redcc_buffer_has_room(&binner->buffer[s],
                                   binning->stream[s].rate * (double)iterations))
            return false;
    return true;
}

static void begin_piece(const struct binning *binning, struct binner *binner) {
    for (uint32_t s = 0; s < binning->loop->stream_count; s++)
        redcc_buffer_mark(&binner->buffer[s], binner->pieces);
}

static bool take_from(const struct binning *binning, struct binner *binner,
                      struct bins_share *share) {
    const int piece = atomic_fetch_add_explicit(&share->taken, 1, memory_order_relaxed);
    if (piece >= piece_count(share))
        return false;
    assert(binner->pieces < TAKEN_PIECES);
    begin_piece(binning, binner);
    share->piece[piece] = (struct piece){binner->thread, binner->pieces++};
    binner->next = piece_begin(share, piece);
    binner->last = piece_begin(share, piece + 1);
    return true;
}

bool redcc_pieces_take(struct binning *binning, struct binner *binner) {
    if (redcc_in_shares(binning->call))
        return redcc_shares_take(binning, binner);
    struct bins_share *share = &binner->share;
    while (pieces_left(share) > 0)
        if (take_from(binning, binner, share))
            return true;
    while ((share = fullest_share(binning)) && has_room(binning, binner, share))
        if (take_from(binning, binner, share))
            return true;
    begin_piece(binning, binner);
    return false;
}

/* ---- in the order of the loop ---------------------------------------------------------------- */

bool redcc_pieces_next_run(const struct binning *binning, struct piece_run *run) {
    assert(run->share >= 0 && run->piece >= 0);
    run->end = run->first = 0;
    for (; run->share < binning->call->threads; run->share++, run->piece = 0) {
        const struct bins_share *share = &binning->binner[run->share]->share;
        for (; run->piece < piece_count(share); run->piece++) {
            const struct piece piece = share->piece[run->piece];
            if (run->end > 0 && (piece.thread != run->thread || piece.number != run->end))
                return true;
            if (run->end == 0) {
                run->thread = piece.thread;
                run->first = piece.number;
            }
            run->end = piece.number + 1;
        }
    }
    return run->end > 0;
}

redcc_int redcc_pieces_records(const struct binning *binning, int thread, uint32_t s) {
    assert(0 <= thread && thread < binning->call->threads && s < binning->loop->stream_count);
    const struct bins_share *share = &binning->binner[thread]->share;
    redcc_int records = 0;
    for (int i = 0; i < piece_count(share); i++) {
        const struct piece piece = share->piece[i];
        const struct redcc_bin_buffer *buffer = &binning->binner[piece.thread]->buffer[s];
        records += buffer->marked[piece.number + 1] - buffer->marked[piece.number];
    }
    return records;
}
