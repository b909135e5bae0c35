/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Orders points along Hilbert's curve, in two or three dimensions, by the transposed index
 * (Skilling, Programming the Hilbert curve, AIP Conference Proceedings 707, 2004). */
#include "redcc/reorder.h"

#include "base/memory.h"

#include <assert.h>
#include <float.h>
#include <stdint.h>
#include <stdlib.h>

enum { BITS = 20, MOST_DIMENSIONS = 3 }; /* BITS: number of bits per coordinate */

struct stop {
    uint64_t along; /* the position along the curve */
    int point;
};

/* Converts coordinates of BITS bits to the transposed index: bit b of x[i] becomes the index's bit
 * (b + 1) * dimensions - 1 - i. */
static void transpose(uint32_t *x, int dimensions) {
    for (uint32_t bit = 1u << (BITS - 1); bit > 1; bit >>= 1) {
        const uint32_t below = bit - 1;
        for (int i = 0; i < dimensions; i++) {
            const uint32_t swapped = (x[0] ^ x[i]) & below;
            if (x[i] & bit) {
                x[0] ^= below;
            } else {
                x[0] ^= swapped;
                x[i] ^= swapped;
            }
        }
    }
    for (int i = 1; i < dimensions; i++) /* computes the Gray code */
        x[i] ^= x[i - 1];
    uint32_t turn = 0;
    for (uint32_t bit = 1u << (BITS - 1); bit > 1; bit >>= 1)
        if (x[dimensions - 1] & bit)
            turn ^= bit - 1;
    for (int i = 0; i < dimensions; i++)
        x[i] ^= turn;
}

static uint64_t along_curve(uint32_t *x, int dimensions) {
    _Static_assert(BITS * MOST_DIMENSIONS <= 64, "a place on the curve is a word");
    uint64_t along = 0;
    assert(dimensions >= 2 && dimensions <= MOST_DIMENSIONS && x[0] < 1u << BITS);
    transpose(x, dimensions);
    for (int bit = BITS - 1; bit >= 0; bit--)
        for (int i = 0; i < dimensions; i++)
            along = along << 1 | (x[i] >> bit & 1);
    return along;
}

static uint32_t cell(double value, double least, double width) {
    const double cells = 1u << BITS, at = width > 0 ? (value - least) / width * cells : 0;
    if (!(at > 0)) /* also true for NaN */
        return 0;
    return at < cells ? (uint32_t)at : (1u << BITS) - 1;
}

static int by_place(const void *a, const void *b) {
    const struct stop *p = a, *q = b;
    if (p->along != q->along)
        return p->along < q->along ? -1 : 1;
    return (p->point > q->point) - (p->point < q->point);
}

/* The width of the range of one coordinate of all points; *least is the range's beginning. The
 * range is limited to -DBL_MAX / 4 to DBL_MAX / 4, so that the width does not overflow. */
static double width_of(int count, int dimensions, const double *coordinate, double *least) {
    double low = DBL_MAX, high = -DBL_MAX;
    for (int p = 0; p < count; p++) {
        const double value = coordinate[(size_t)p * (size_t)dimensions];
        low = value < low ? value : low;
        high = value > high ? value : high;
    }
    *least = low < -DBL_MAX / 4 ? -DBL_MAX / 4 : low;
    high = high > DBL_MAX / 4 ? DBL_MAX / 4 : high;
    return high > *least ? high - *least : 0;
}

int redcc_reorder_points(int count, int dimensions, const double *point, int *new_of_old) {
    if (count < 0 || dimensions < 2 || dimensions > MOST_DIMENSIONS)
        return -1;
    struct stop *stop = redcc_memory_alloc((size_t)count * sizeof *stop);
    double least[MOST_DIMENSIONS], width = 0;
    if (!stop)
        return -1;
    for (int i = 0; i < dimensions; i++) {
        const double own = width_of(count, dimensions, point + i, &least[i]);
        width = own > width ? own : width;
    }
    for (int p = 0; p < count; p++) {
        uint32_t x[MOST_DIMENSIONS];
        for (int i = 0; i < dimensions; i++)
            x[i] = cell(point[(size_t)p * (size_t)dimensions + (size_t)i], least[i], width);
        stop[p] = (struct stop){along_curve(x, dimensions), p};
    }
    assert(width >= 0);
    qsort(stop, (size_t)count, sizeof *stop, by_place);
    for (int i = 0; i < count; i++)
        new_of_old[stop[i].point] = i;
    redcc_memory_free(stop);
    return 0;
}
