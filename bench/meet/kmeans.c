/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A step of k-means: each point is added to the sum of its nearest centre. In the version by hand,
 * each thread finds the nearest centres of an equal share of the points. Then it adds up the points
 * that belong to its share of the centres. */
#include "meet.h"

#include <float.h>

enum { POINTS = 100000, CENTRES = 24, PLACES = 16 };

static float (*points)[PLACES], (*centres)[PLACES];
static int *member;
static struct sums {
    float sums[CENTRES][PLACES];
    int counts[CENTRES], changes;
} sums;

#ifndef BY_HAND
static void assign(int n, const float (*x)[PLACES], const float (*centre)[PLACES], int *to,
                   struct sums *all) {
    for (int p = 0; p < n; p++) {
        float least = FLT_MAX;
        int nearest = 0;
        for (int c = 0; c < CENTRES; c++) {
            float d = 0;
            for (int k = 0; k < PLACES; k++)
                d += (x[p][k] - centre[c][k]) * (x[p][k] - centre[c][k]);
            if (d < least) {
                least = d;
                nearest = c;
            }
        }
        if (to[p] != nearest)
            all->changes++;
        to[p] = nearest;
        all->counts[nearest]++;
        for (int k = 0; k < PLACES; k++)
            all->sums[nearest][k] += x[p][k];
    }
}
#else
#include <omp.h>
static void assign(int n, const float (*x)[PLACES], const float (*centre)[PLACES], int *to,
                   struct sums *all) {
    int changes = 0;
#pragma omp parallel reduction(+ : changes)
    {
#pragma omp for schedule(static)
        for (int p = 0; p < n; p++) {
            float least = FLT_MAX;
            int nearest = 0;
            for (int c = 0; c < CENTRES; c++) {
                float d = 0;
                for (int k = 0; k < PLACES; k++)
                    d += (x[p][k] - centre[c][k]) * (x[p][k] - centre[c][k]);
                if (d < least) {
                    least = d;
                    nearest = c;
                }
            }
            changes += to[p] != nearest;
            to[p] = nearest;
        }
        const int me = omp_get_thread_num(), threads = omp_get_num_threads();
        for (int p = 0; p < n; p++) {
            const int c = to[p];
            if (c * threads / CENTRES != me)
                continue;
            all->counts[c]++;
            for (int k = 0; k < PLACES; k++)
                all->sums[c][k] += x[p][k];
        }
    }
    all->changes += changes;
}
#endif

void make(void) {
    points = room(POINTS * sizeof *points);
    centres = room(CENTRES * sizeof *centres);
    member = room(POINTS * sizeof *member);
    for (int p = 0; p < POINTS; p++)
        for (int k = 0; k < PLACES; k++)
            points[p][k] = (float)draw();
    for (int c = 0; c < CENTRES; c++)
        for (int k = 0; k < PLACES; k++)
            centres[c][k] = points[c][k];
}

void change(void) {
    for (int c = 0; c < CENTRES; c++) {
        for (int k = 0; k < PLACES && sums.counts[c] > 0; k++)
            centres[c][k] = sums.sums[c][k] / (float)sums.counts[c];
        for (int k = 0; k < PLACES; k++)
            sums.sums[c][k] = 0;
        sums.counts[c] = 0;
    }
}

void call(void) {
    assign(POINTS, (const float(*)[PLACES])points, (const float(*)[PLACES])centres, member, &sums);
}

const void *results(size_t *size) {
    *size = sizeof sums;
    return &sums;
}
