/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A pair list as in molecular dynamics, and finite elements with a loop over an element's nodes.
// covers: row 45, row 58 of docs/constructs.md
// COMPILERS: clang-19
#include "case.h"
#include <math.h>

enum { ATOMS = 1000, PAIRS = 9000, ELEMENTS = 4000, NODES = 1300 };

typedef struct vector3 {
    double x, y, z;
} vector3;

static vector3 at[ATOMS], force[ATOMS];
static int list[PAIRS][2], element[ELEMENTS][4];
static double load[NODES], diagonal[NODES], position[NODES][2], near[ATOMS][1];

static vector3 difference(vector3 a, vector3 b) {
    vector3 d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return d;
}

static void forces(int pairs) {
    for (int p = 0; p < pairs; p++) { // EXPECT: transformed
        const int i = list[p][0], j = list[p][1];
        const vector3 d = difference(at[i], at[j]);
        const double r2 = d.x * d.x + d.y * d.y + d.z * d.z;
        if (r2 > 1.5)
            continue;
        const double f = 1.5 - r2;
        force[i].x += f * d.x;
        force[i].y += f * d.y;
        force[i].z += f * d.z;
        force[j].x -= f * d.x;
        force[j].y -= f * d.y;
        force[j].z -= f * d.z;
    }
}

struct places {
    int of[2][1];
};

/* Decides from an array with an initialiser whether a pair is near, in the inspector as well.
 */
static void densities(int pairs, double (*density)[1]) {
    for (int p = 0; p < pairs; p++) { // EXPECT: transformed
        const int i = list[p][0], j = list[p][1];
        const double d[3] = {at[i].x - at[j].x, at[i].y - at[j].y, at[i].z - at[j].z};
        const struct places pair = {{{i}, {j}}};
        const double q = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        if (q >= 1.5)
            continue;
        density[pair.of[0][0]][0] += 1.5 - q;
        density[pair.of[1][0]][0] += 1.5 - q;
    }
}

static void stiffness(const double corner[4][2], double k[4][4], double f[4]) {
    for (int a = 0; a < 4; a++) {
        f[a] = 0.0;
        for (int b = 0; b < 4; b++) {
            k[a][b] = corner[a][0] * corner[b][1] - corner[a][1] * corner[b][0];
            f[a] += k[a][b] * 0.25;
        }
    }
}

static void assemble(int elements) {
    double corner[4][2], k[4][4], f[4];
    for (int e = 0; e < elements; e++) { // EXPECT: transformed
        for (int a = 0; a < 4; a++) {
            corner[a][0] = position[element[e][a]][0];
            corner[a][1] = position[element[e][a]][1];
        }
        stiffness((const double(*)[2])corner, k, f);
        for (int a = 0; a < 4; a++) {
            load[element[e][a]] += f[a];
            diagonal[element[e][a]] += k[a][a] + k[a][(a + 1) % 4];
        }
    }
}

int main(void) {
    for (int i = 0; i < ATOMS; i++)
        at[i] = (vector3){case_value(), case_value(), case_value()};
    case_values(&position[0][0], 2 * NODES);
    for (int round = 0; round < 3; round++) {
        case_subscripts(&list[0][0], 2 * PAIRS, ATOMS);
        case_near_subscripts(&element[0][0], 4 * ELEMENTS, NODES);
        forces(PAIRS);
        assemble(ELEMENTS);
        densities(PAIRS, near);
        CASE_PRINT(force);
        CASE_PRINT(load);
        CASE_PRINT(diagonal);
        CASE_PRINT(near);
    }
    return 0;
}
