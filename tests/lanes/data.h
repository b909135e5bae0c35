/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Data shared by the programs in this folder: random elements and points, with NaN, infinities,
 * zeros of both signs and subnormals, and hashes of results. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Enough iterations for a trial to divide them into slices (execute/variant.h). */
enum { NODES = 300, COUNT = 2503 };

struct element {
    int node[3];
    double weight[3];
    double area;
    short kind;
};

static struct element element[COUNT];
static double x[NODES][3], force[NODES][3], single[NODES];

static uint64_t random_bits(void) {
    static uint64_t state = 88172645463325252u;
    state ^= state << 13;
    state ^= state >> 7;
    return state ^= state << 17;
}

static double odd_value(void) {
    static const double odd[] = {NAN, INFINITY, -INFINITY, -0.0, 0.0, 4.9e-324, -1e-310, 1e308};
    const uint64_t r = random_bits();
    return r % 61 == 0 ? odd[r / 61 % 8] : (double)(int64_t)r * 0x1p-62;
}

static void print(const char *name, const double *v, size_t count) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &v[i], sizeof bits);
        bits = v[i] != v[i] ? 1 : bits; /* no standard says which NaN results */
        hash = (hash ^ bits) * 0x100000001b3u;
    }
    printf("%s %016llx\n", name, (unsigned long long)hash);
}

/* Fills in -0.0, which is the only neutral element of addition for all values. */
static void begin(double *v, size_t count) {
    for (size_t i = 0; i < count; i++)
        v[i] = -0.0;
}

static void begin_round(void) {
    for (int t = 0; t < COUNT; t++) {
        for (int k = 0; k < 3; k++) {
            element[t].node[k] = (int)((t * NODES / COUNT + random_bits() % 40) % NODES);
            element[t].weight[k] = odd_value();
        }
        element[t].area = 1 + (double)(random_bits() % 1000) / 999;
        element[t].kind = (short)(random_bits() % 5);
    }
    for (int i = 0; i < NODES; i++)
        for (int c = 0; c < 3; c++)
            x[i][c] = odd_value();
}
