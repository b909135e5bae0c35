/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A loop that moves particles towards the middle and deposits their charge on a grid. In the
 * version by hand, each thread moves an equal share of the particles. Then it deposits the charges
 * in its band of rows. */
#include "meet.h"

#include <math.h>

enum { SIDE = 256, PARTICLES = 1500000 };

typedef struct particle {
    float x, y, u, v;
} particle;

static particle *particles;
static float *grid;

#ifndef BY_HAND
static void push(int n, particle *p, float *g) {
    for (int t = 0; t < n; t++) {
        const float dx = p[t].x - SIDE / 2, dy = p[t].y - SIDE / 2;
        const float pull = 0.05f / sqrtf(dx * dx + dy * dy + 1);
        p[t].u -= pull * dx;
        p[t].v -= pull * dy;
        p[t].x += p[t].u;
        p[t].y += p[t].v;
        if (p[t].x < 0 || p[t].x >= SIDE - 1) {
            p[t].x -= p[t].u;
            p[t].u = -p[t].u;
        }
        if (p[t].y < 0 || p[t].y >= SIDE - 1) {
            p[t].y -= p[t].v;
            p[t].v = -p[t].v;
        }
        const int x = (int)p[t].x, y = (int)p[t].y, cell = y * SIDE + x;
        const float a = p[t].x - (float)x, b = p[t].y - (float)y;
        g[cell] += (1 - a) * (1 - b);
        g[cell + 1] += a * (1 - b);
        g[cell + SIDE] += (1 - a) * b;
        g[cell + SIDE + 1] += a * b;
    }
}
#else
#include <omp.h>
enum { ROUND = 32768 }; /* number of particles that fit into a core's cache */

static void push(int n, particle *p, float *g) {
#pragma omp parallel
    for (int begin = 0; begin < n; begin += ROUND) {
        const int end = n - begin < ROUND ? n : begin + ROUND;
#pragma omp for schedule(static)
        for (int t = begin; t < end; t++) {
            const float dx = p[t].x - SIDE / 2, dy = p[t].y - SIDE / 2;
            const float pull = 0.05f / sqrtf(dx * dx + dy * dy + 1);
            p[t].u -= pull * dx;
            p[t].v -= pull * dy;
            p[t].x += p[t].u;
            p[t].y += p[t].v;
            if (p[t].x < 0 || p[t].x >= SIDE - 1) {
                p[t].x -= p[t].u;
                p[t].u = -p[t].u;
            }
            if (p[t].y < 0 || p[t].y >= SIDE - 1) {
                p[t].y -= p[t].v;
                p[t].v = -p[t].v;
            }
        }
        const int me = omp_get_thread_num(), threads = omp_get_num_threads();
        const int low = SIDE * me / threads, high = SIDE * (me + 1) / threads;
        for (int t = begin; t < end; t++) {
            const int y = (int)p[t].y;
            if (y + 1 < low || y >= high)
                continue;
            const int x = (int)p[t].x, cell = y * SIDE + x;
            const float a = p[t].x - (float)x, b = p[t].y - (float)y;
            if (y >= low) {
                g[cell] += (1 - a) * (1 - b);
                g[cell + 1] += a * (1 - b);
            }
            if (y + 1 < high) {
                g[cell + SIDE] += (1 - a) * b;
                g[cell + SIDE + 1] += a * b;
            }
        }
    }
}
#endif

/* Makes slow particles that are sorted by rows of the grid. (Programs of this kind sort particles
 * from time to time.) */
void make(void) {
    particles = room(PARTICLES * sizeof *particles);
    grid = room(SIDE * SIDE * sizeof *grid);
    for (int t = 0; t < PARTICLES; t++)
        particles[t] =
            (particle){(float)draw() * (SIDE - 1.5f), (float)t / PARTICLES * (SIDE - 1.5f),
                       0.2f * (float)draw() - 0.1f, 0.2f * (float)draw() - 0.1f};
}

void change(void) {
}

void call(void) {
    push(PARTICLES, particles, grid);
}

const void *results(size_t *size) {
    *size = SIDE * SIDE * sizeof *grid;
    return grid;
}
