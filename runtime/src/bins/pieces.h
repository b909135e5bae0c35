/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Load balancing within a round: each thread's share is cut into pieces, which it takes one after
 * the other; a thread that is done takes pieces of others (work stealing). So iterations may be
 * arbitrarily uneven. The thread marks in its bins where the records of each piece begin. A bin's
 * records are applied in the order of the pieces, which is that of the loop, whichever thread
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
    STOLEN_PIECES = 16, /* maximum number that one thread steals in a round */
    TAKEN_PIECES =
        SHARE_PIECES + STOLEN_PIECES, /* maximum number that one thread executes in a round */
    PIECE_MARKS =
        TAKEN_PIECES + 1 /* marks: the beginning of each piece, and the end of the last one */
};

struct binning;
struct binner;

/** The thread that took a piece. */
struct piece {
    int thread;
    int number; /* the piece's number among the thread's pieces of this round */
};

/** A thread's share of a round: iterations [begin, end). */
struct bins_share {
    redcc_int begin;
    redcc_int end;
    atomic_int taken; /* number of its pieces that were taken, from the first on */
    struct piece piece[SHARE_PIECES];
};

/** Pieces that are consecutive in the loop and in the records of one thread: pieces [first, end) of
 * that thread. */
struct piece_run {
    int share, piece; /* position of the next piece in the loop */
    int thread;
    int first;
    int end;
};

/** Cuts the round into shares. One thread, before the others push. */
void redcc_pieces_cut(struct binning *binning);

/** The thread takes a piece, its own or another's: iterations [binner->next, binner->last). False:
 *  no piece is left for it, and its records are complete. */
bool redcc_pieces_take(struct binning *binning, struct binner *binner);

/** Advances *run to the next run of pieces (zero: the first one). False: none is left. Requires
 *  that all were taken. */
bool redcc_pieces_next_run(const struct binning *binning, struct piece_run *run);

/** Records of stream `s` for the iterations of thread `thread`'s share, whichever thread pushed
 *  them. */
redcc_int redcc_pieces_records(const struct binning *binning, int thread, uint32_t s);

#endif
