/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The largest common step: additive continuous collision detection (Li, Kaufman and Jiang 2021,
 * section 4 and algorithm 1). A distance decreases by at most the relative displacement, so
 * features that move by (1 - kept) of their distance cannot meet. This is repeated until the
 * distance is the fraction `kept` of its first value. No equation is solved, so no root can be
 * missed; rounding errors are some 1e-16 of the coordinates.
 */
#include "barrier.h"

#include "base/vector.h"

/* A pair keeps at least this fraction of its distance beyond the minimum distance. */
static const double kept = 0.1;
/* The minimum distance, as a fraction of the reach. Without it, repeated approaches by nine tenths
 * of the distance would reach the size of rounding errors, at which the side of a vertex is
 * undefined.
 */
static const double kept_reach = 1e-6;
/* After this number of advances the fraction reached so far is returned, which is always safe. */
enum { most_advances = 1000 };

/* Makes the displacements relative to the pair's mean. Returns an upper bound on the features'
 * approach. */
static double approach(const barrier_pair *pair, double displacement[4][3]) {
    const int firsts = pair->kind == BARRIER_EDGES ? 2 : 1;
    double of[2] = {0, 0};
    for (int a = 0; a < 3; a++) {
        const double mean =
            (displacement[0][a] + displacement[1][a] + displacement[2][a] + displacement[3][a]) / 4;
        for (int k = 0; k < 4; k++)
            displacement[k][a] -= mean;
    }
    for (int k = 0; k < 4; k++) {
        const double length = vector_length(displacement[k]);
        of[k >= firsts] = length > of[k >= firsts] ? length : of[k >= firsts];
    }
    return of[0] + of[1];
}

static double part_of(const barrier *b, const barrier_pair *pair, const double (*x)[3],
                      const double (*displacement)[3]) {
    double at[4][3], move[4][3];
    nearest found;
    barrier_gather(pair->vertex, x, at);
    barrier_gather(pair->vertex, displacement, move);
    const double speed = approach(pair, move);
    barrier_nearest(b, pair, (const double(*)[3])at, &found);
    double room = found.distance - kept_reach * pair->reach, part = 0;
    const double least = kept * room;
    for (int n = 0; n < most_advances; n++) {
        const double next = (1 - kept) * room / speed;
        if (!(speed > 0) || part + next >= 1)
            return 1;
        if (!(room > 0))
            return part;
        for (int k = 0; k < 4; k++)
            vector_add_scaled(at[k], next, move[k], at[k]);
        barrier_nearest(b, pair, (const double(*)[3])at, &found);
        room = found.distance - kept_reach * pair->reach;
        if (n > 0 && room < least)
            return part;
        part += next;
    }
    return part;
}

double barrier_allowed_part(const barrier *b, const double (*x)[3],
                            const double (*displacement)[3]) {
    double least = 1;
#pragma omp parallel for schedule(static) reduction(min : least)
    for (int k = 0; k < b->list.pairs; k++) {
        const double part = part_of(b, &b->list.pair[k], x, displacement);
        least = part < least ? part : least;
    }
    return least;
}
