// Pairs of points: arrays read and arrays updated have one element type, a helper repeats a step until its
// value is in range, and the inner loop accumulates sums. Reads may overlap updates.
// INTEGERS: no
#include "case.h"

enum { N = 220, MOST = 7 * N };
struct points {
    int n;
    double *x, *y, *fx, *fy, energy, box, cut;
};
static double memory[MOST];

static double nearest(double d, double half) {
    while (d > half)
        d -= 2.0 * half;
    while (d < -half)
        d += 2.0 * half;
    return d;
}

static void forces(struct points *s) {
    double dx, dy, squared, f;
    int i, j;
    s->energy = 0.0;
    for (i = 0; i < s->n; ++i) { // EXPECT: transformed
        for (j = i + 1; j < s->n; ++j) {
            dx = nearest(s->x[i] - s->x[j], 0.5 * s->box);
            dy = nearest(s->y[i] - s->y[j], 0.5 * s->box);
            squared = dx * dx + dy * dy + 0.01;
            if (squared < s->cut) {
                f = 1.0 / squared - squared;
                s->energy += f * 0.25;
                s->fx[i] += dx * f;
                s->fy[i] += dy * f;
                s->fx[j] += -dx * f;
                s->fy[j] += -dy * f;
            }
        }
    }
}

/* `energy` may point to one of the coordinates; `near_pairs` counts. */
static long near_pairs;
static void energies(int n, const double *x, double *f, double *energy, double cut) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < i; j++) {
            const double d = nearest(x[j] - x[i], 1.5);
            if (d * d > cut)
                continue;
            near_pairs++;
            *energy -= d;
            f[j] -= d;
            f[i] += d;
        }
} // CHECKED: 25 45

static void fill(void) {
    for (int i = 0; i < MOST; i++)
        memory[i] = (double)case_below(1000) * 0.004 - (i % 3 ? 1.0 : 0.0);
    memory[17] = -0.0;
    memory[2 * N + 3] = -0.0;
}

int main(void) {
    for (int round = 0; round < 6; round++) {
        fill();
        struct points s = {.n = round == 5 ? 2 : N, .box = 3.0, .cut = round == 3 ? 100.0 : 0.4};
        s.x = memory;
        s.y = memory + N;
        s.fx = memory + 2 * N;
        s.fy = memory + 3 * N;
        if (round == 1) /* the second y force is the first coordinate */
            s.fy = memory + 1;
        if (round == 2)
            s.fx = memory + N - 1;
        if (round == 4) /* a NaN: no pair with it is near, and its bits reach no result */
            memory[5] = __builtin_inf() - __builtin_inf();
        forces(&s);
        CASE_PRINT(memory);
        CASE_PRINT(&s.energy);
        double energy = -0.0;
        double *at[] = {&energy, memory + 3, memory + 4 * N - 1, memory + 6 * N, &energy, memory + 2};
        near_pairs = round;
        energies(s.n, memory, memory + (round == 2 ? N - 2 : 4 * N), at[round], s.cut);
        CASE_PRINT(memory);
        CASE_PRINT(&energy);
        CASE_PRINT(&near_pairs);
    }
}
