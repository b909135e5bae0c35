/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The subscript is as dear as the rest of the iteration (kmeans).
// covers: row 33
#include "../case.h"

enum { N = 6000, CENTRES = 40 };
static double point[N][2], centre[CENTRES][2], sum[CENTRES][2];
static int members[CENTRES];

static int nearest(const double *p) {
    int best = 0;
    double least = 1e300;
    for (int c = 0; c < CENTRES; c++) {
        const double x = p[0] - centre[c][0], y = p[1] - centre[c][1], d = x * x + y * y;
        if (d < least) {
            least = d;
            best = c;
        }
    }
    return best;
}

static void assign(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int c = nearest(point[t]);
        members[c]++;
        sum[c][0] += point[t][0];
        sum[c][1] += point[t][1];
    }
}

int main(void) {
    case_values(&point[0][0], 2 * N);
    case_values(&centre[0][0], 2 * CENTRES);
    for (int round = 0; round < 3; round++) {
        assign(N - round);
        CASE_PRINT(members);
        CASE_PRINT(sum);
    }
    return 0;
}
