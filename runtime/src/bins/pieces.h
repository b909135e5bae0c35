/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Load balancing within a round. Each thread's share is cut into pieces, which the thread takes one
 * after the other. A thread that has finished its share takes pieces of other shares (work
 * stealing). So the cost of iterations may vary widely. A thread marks in its bins where the
 * records of each piece begin. A bin's records are applied in the order of the pieces in the loop,
 * whichever thread appended them.
 */
#ifndef REDCC_PIECES_H
#define REDCC_PIECES_H

#include "redcc/runtime.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

enum {
    SHARE_PIECES = 16,
    STOLEN_PIECES = 16, /* maximum number of pieces that one thread steals in a round */
    /* maximum number of pieces that one thread executes in a round */
    TAKEN_PIECES = SHARE_PIECES + STOLEN_PIECES,
    PIECE_MARKS =
        /* number of marks: the beginning of each piece, and the end of the last piece */
    TAKEN_PIECES + 1
};

struct binning;
struct binner;

/** Says which thread took a piece. */
struct piece {
    int thread;
    int number; /* the piece's number among the pieces that `thread` took in this round, in the
                   order in which it took them */
};

/** A thread's share of a round: iterations [begin, end). */
struct bins_share {
    redcc_int begin;
    redcc_int end;
    atomic_int taken; /* number of pieces of this share that were taken, from the first one on */
    struct piece piece[SHARE_PIECES];
};

/** A run of pieces that are consecutive both in the loop and in the records of `thread`: the pieces
 * [first, end) that it took. */
struct piece_run {
    int share, piece; /* position of the next piece in the loop */
    int thread;
    int first;
    int end;
};

/** Cuts the round into shares. Called by one thread, before any thread pushes. */
void redcc_pieces_cut(struct binning *binning);

/** Takes a piece for the thread, from its own share or from another, and sets binner->next and
 * binner->last to its iterations. Returns false if no piece is left that the thread can take; its
 * records are then complete. */
bool redcc_pieces_take(struct binning *binning, struct binner *binner);

/** Advances *run to the next run of pieces, in the order of the loop. If all fields of *run are
 * zero, that is the first run. Returns false if no run is left. All pieces must have been taken. */
bool redcc_pieces_next_run(const struct binning *binning, struct piece_run *run);

/** The number of records of stream `s` that belong to iterations of thread number `thread`'s share,
 * whichever thread pushed them. */
redcc_int redcc_pieces_records(const struct binning *binning, int thread, uint32_t s);

#endif
