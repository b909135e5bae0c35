/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* For check-planted: the faults that plant_errors.c makes in these loops must be detected, and
 * other loops must still be transformed. */
static double here[64], hers[64];
static int one[1000];

struct near {
    int i, j;
};

struct afar {
    int i, j;
};

static struct near places[1000];

void first(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        here[one[t]] += 0.5;
}

void second(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse internal
        /* plant: it does not compile */
        here[one[t]] += 0.5;
    }
}

void third(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse binding
        /* plant: another name */
        here[one[t]] += 0.5;
    }
}

void fourth(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse binding
        /* plant: another subscript */
        const int won = one[t], two = one[n - 1 - t];
        hers[won] += 0.5;
        hers[two] += 0.5;
    }
}

void fifth(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse binding
        /* plant: another type */
        struct near own = places[t];
        here[own.i] += 0.5;
    }
}

void sixth(int n) {
    struct afar own = {1, 2};
    for (int t = 0; t < n; t++) // EXPECT: transformed
        hers[one[t]] += (t % 2 ? own.i : own.j);
}

void seventh(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse binding
        /* plant: only in front */
        const int won = one[t], two = one[n - 1 - t];
        hers[won] += 0.5;
        hers[two] += 0.5;
    }
}

double eighth(int n, const int *restrict k, const double *restrict x, double *restrict h) {
    double e = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse internal
        /* plant: another type of a value */
        e = x[t] * 3.0;
        h[k[t]] += e;
        if (e > 1)
            h[k[t] + 1] -= e;
    }
    return e;
}
