/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Balance within a round: each thread's share is cut into pieces, which it takes one after the
 * other; a thread that has done its own takes over pieces of others (work stealing). Iterations may
 * so be as uneven as they like. The thread marks in its bins where the records of each piece begin,
 * and a bin's records are applied in the order of the pieces, which is that of the loop, whoever
 * appended them.
 */
#ifndef REDCC_PIECES_H
#define REDCC_PIECES_H

#include "redcc/runtime.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

enum {
    SHARE_PIECES = 16,
    STOLEN_PIECES = 16,                          /* at most, by one thread in one round */
    TAKEN_PIECES = SHARE_PIECES + STOLEN_PIECES, /* at most, of its own as well */
    PIECE_MARKS = TAKEN_PIECES + 1 /* where each begins, and where the last one ends */
};

struct binning;
struct binner;

/** Who took a piece. */
struct piece {
    int thread;
    int number; /* it was the thread's piece number so-and-so of this round */
};

/** A thread's share of a round: iterations [begin, end). */
struct bins_share {
    redcc_int begin;
    redcc_int end;
    atomic_int taken; /* pieces, the first ones */
    struct piece piece[SHARE_PIECES];
};

/** Pieces that follow each other in the loop and in the records of one thread: its pieces number
 *  [first, end). */
struct piece_run {
    int share, piece; /* the one behind them */
    int thread;
    int first;
    int end;
};

/** Cuts the round into shares. One thread, before the others push. */
void redcc_pieces_cut(struct binning *binning);

/** The thread takes a piece, its own or another's: iterations [binner->next, binner->last). False:
 *  there is none for it, and its records are complete. */
bool redcc_pieces_take(struct binning *binning, struct binner *binner);

/** The run of pieces behind *run (all zero: the first one), which becomes it. False: there is none.
 *  All were taken. */
bool redcc_pieces_next_run(const struct binning *binning, struct piece_run *run);

/** Records of stream `s` that the iterations of thread `thread`'s share have, whoever pushed them.
 */
redcc_int redcc_pieces_records(const struct binning *binning, int thread, uint32_t s);

#endif
