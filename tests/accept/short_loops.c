/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// redcc unrolls short inner loops by a pragma in front of them. It must not add this pragma next to another
// pragma, an attribute or a label.
// CFLAGS: -Wno-unknown-pragmas -Wno-attributes
#include "case.h"

enum { N = 1900, M = 700, CORNERS = 3 };
static int corner[N][CORNERS], kind[N];
static double value[N][4], force[M][4], matrix[M][4][4];

#define FOR_EACH(c) for (int c = 0; c < CORNERS; c++)
#define TWICE(statement)                                                                           \
    for (int again = 0; again < 2; again++)                                                        \
    statement

static void beside_pragmas(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma GCC unroll 2
        for (int c = 0; c < CORNERS; c++)
            force[corner[t][c]][0] += value[t][c];
#pragma GCC ivdep

        /* and a comment between */
        for (int c = 0; c < 4; c++)
            force[corner[t][0]][c] += value[t][c] * 0.5;
#ifdef NEVER
#pragma GCC unroll 8
#endif
        for (int c = 0; c < 4; c++)
            force[corner[t][1]][c] -= value[t][c];
    }
}

static void with_attribute(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        [[clang::nomerge]] for (int c = 0; c < 4; c++)
            force[corner[t][c % CORNERS]][c] += value[t][c];
    }
}

static void in_macros(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        FOR_EACH(c)
        force[corner[t][c]][1] += value[t][c];
        TWICE(force[corner[t][0]][2] -= value[t][1] * (1 + again);)
        FOR_EACH(p) FOR_EACH(q) matrix[corner[t][p]][p][q] += value[t][q];
    }
}

#define NEXT(c) c++
#define AND_ON                                                                                     \
    ;                                                                                              \
    c++
static void steps_in_macros(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 4 AND_ON)
            force[corner[t][1]][c] -= value[t][c] * 0.25;
        for (int c = 0; c < CORNERS; NEXT(c))
            force[corner[t][c]][3] += value[t][c];
        int p;
        for (p = 0; p < 4; /* step of one */ p += 1)
            force[corner[t][2]][p] -= value[t][p];
    }
}

static void without_braces(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (kind[t] % 3 == 0)
            for (int c = 0; c < 4; c++)
                force[corner[t][0]][c] += value[t][c];
        else
            for (int p = 0; p < CORNERS; p++)
                for (int q = p; q < CORNERS; q++)
                    for (int c = p; c <= q; c++)
                        matrix[corner[t][p]][q][c] -= value[t][c] * value[t][q];
        for (int c = 3; c >= 0; c -= 2)
            force[corner[t][2]][c] += value[t][c];
    }
}

static void left_early(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 4; c++) {
            if (c == kind[t])
                continue;
            if (c > kind[t] + 1)
                break;
            force[corner[t][c % CORNERS]][c] += value[t][c];
        }
        switch (kind[t]) {
        case 0:
            for (int c = 0; c < 4; c++)
                force[corner[t][0]][c] -= 0.25;
            break;
        default:
            force[corner[t][0]][0] += 0.25;
            for (int c = 0; c < kind[t]; c++)
                force[corner[t][1]][c % 4] += value[t][0];
        }
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        for (int p = 0; p < CORNERS; p++)
            corner[t][p] = case_below(M);
        kind[t] = case_below(6);
    }
    case_values(&value[0][0], 4 * N);
    for (int call = 0; call < 3; call++) {
        beside_pragmas(N);
        with_attribute(N);
        in_macros(N);
        steps_in_macros(N);
        without_braces(N);
        left_early(N);
    }
    CASE_PRINT(force);
    CASE_PRINT(matrix);
    return 0;
}
