/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Adds each sample to a window of 7 x 7 cells of a grid. In the version by hand, each thread owns
 * a band of rows, and clips the windows to its band. */
#include "meet.h"

#include <math.h>

enum { SIDE = 512, SAMPLES = 300000, REACH = 3 };

typedef struct sample {
    float x, y, value;
} sample;

static sample *samples;
static float *grid;

#ifndef BY_HAND
static void spread(int n, const sample *s, float *g) {
    for (int t = 0; t < n; t++) {
        const int cx = (int)s[t].x, cy = (int)s[t].y;
        for (int y = cy - REACH; y <= cy + REACH; y++) {
            const float dy = s[t].y - (float)y;
            for (int x = cx - REACH; x <= cx + REACH; x++) {
                const float dx = s[t].x - (float)x, rr = dx * dx + dy * dy;
                g[y * SIDE + x] += s[t].value / (1 + rr);
            }
        }
    }
}
#else
#include <omp.h>
static void spread(int n, const sample *s, float *g) {
#pragma omp parallel
    {
        const int me = omp_get_thread_num(), all = omp_get_num_threads();
        const int first = SIDE * me / all, last = SIDE * (me + 1) / all - 1;
        for (int t = 0; t < n; t++) {
            const int cx = (int)s[t].x, cy = (int)s[t].y;
            const int from = cy - REACH > first ? cy - REACH : first;
            const int to = cy + REACH < last ? cy + REACH : last;
            for (int y = from; y <= to; y++) {
                const float dy = s[t].y - (float)y;
                for (int x = cx - REACH; x <= cx + REACH; x++) {
                    const float dx = s[t].x - (float)x, rr = dx * dx + dy * dy;
                    g[y * SIDE + x] += s[t].value / (1 + rr);
                }
            }
        }
    }
}
#endif

void make(void) {
    samples = room(SAMPLES * sizeof *samples);
    grid = room(SIDE * SIDE * sizeof *grid);
    change();
}

void change(void) {
    for (int t = 0; t < SAMPLES; t++) {
        samples[t].x = (float)(REACH + draw() * (SIDE - 2 * REACH - 1));
        samples[t].y = (float)(REACH + draw() * (SIDE - 2 * REACH - 1));
        samples[t].value = (float)draw();
    }
}

void call(void) {
    spread(SAMPLES, samples, grid);
}

const void *results(size_t *size) {
    *size = SIDE * SIDE * sizeof *grid;
    return grid;
}
