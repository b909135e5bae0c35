/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops over pairs of blocks: the inspector records rows by block; a thread skips pairs in which it owns no row.
// covers: row 47, row 48 of docs/constructs.md
// INTEGERS: no
#include "case.h"
#include <math.h>

enum { MOST = 8, BLOCKS = 400, ALL = 500, NEAR = 9, ROWS = MOST * ALL };
static int near[BLOCKS][NEAR], count[ALL], id[ROWS], order[ROWS];
static double u[ROWS + 64], f[ROWS + 64][3], r[ROWS][3];
static long n_of[ROWS + 64];
static struct {
    double at, mass, push[4];
} body[ROWS];
static struct record {
    double before[5], sum, behind[3];
} record[ROWS];

/* A molecular dynamics force loop. Halo blocks, numbered from `blocks` on, are updated but are not iterated over. */
static void cells(int blocks, double cut) {
    for (int b = 0; b < blocks; b++) { // EXPECT: transformed
        int mine = count[b];
        for (int k = 0; k < NEAR; k++) {
            int other = near[b][k];
            int theirs = count[other];
            for (int p = b * MOST, i = 0; i < mine; i++, p++) { // INNER
                int own = id[p];
                for (int q = MOST * other, j = 0; j < theirs; j++, q++) {
                    if (other < blocks && id[q] <= own)
                        continue;
                    double d[3], d2 = 0;
                    for (int c = 0; c < 3; c++) {
                        d[c] = r[p][c] - r[q][c];
                        d2 += d[c] * d[c];
                    }
                    if (d2 > cut)
                        continue;
                    double e = 1 / (d2 + 0.25);
                    u[p] += 0.5 * e;
                    u[q] += 0.5 * e;
                    for (int c = 0; c < 3; c++) {
                        f[p][c] -= d[c] * e;
                        f[q][c] += d[c] * e;
                    }
                }
            }
        }
    }
}

/* Inclusive bounds, counters that begin at other values than 0, and a wider secondary counter `q`. */
static void with_the_bound(int blocks) {
    for (int b = 0; b < blocks; b++) { // EXPECT: transformed
        for (int k = 1; k < NEAR; k += 2) {
            const int other = near[b][k], last = count[other] - 2, first = count[b] % 3 - 1;
            for (long q = MOST * other + 2, j = first; j <= last; j++, q++) { // INNER
                const double e = r[b][0] * r[b][1] + r[other][2] * (double)j - r[b][0] / 3;
                u[q + 1] += e;
                if (e > 0.125)
                    n_of[q] += 2;
            }
        }
    }
}

/* Updated members of records: other members lie between them. */
static void records(int blocks) {
    for (int b = 0; b < blocks; b++) { // EXPECT: transformed
        for (int k = 0; k < NEAR; k++) {
            const int other = near[b][k], last = MOST * other + count[other];
            for (int q = MOST * other; q < last; q++) { // INNER
                const double e = r[b][0] * body[q].at + r[other][2] * body[q].mass - r[b][0] / 3;
                body[q].push[1] += e * e;
            }
        }
    }
}

/* One updated member per record: consecutive rows of a block are one record apart. */
static void parts(int blocks) {
    for (int b = 0; b < blocks; b++) // EXPECT: transformed
        for (int k = 0; k < NEAR; k++) {
            const int other = near[b][k];
            for (int p = MOST * b; p < MOST * (b + 1); p++) // INNER
                for (int q = MOST * other; q < MOST * (other + 1); q++) {
                    const double d = r[p][0] - r[q][1], e = sqrt(d * d + 0.1) * d / (d * d + 3);
                    record[p].sum += e;
                    record[q].sum -= e;
                }
        }
}

/* The value of the secondary counter after the loop is part of the next subscript. */
static void asked_afterwards(int blocks) {
    int q, j;
    for (int b = 0; b < blocks; b++) // EXPECT: transformed
        for (int k = 0; k < 3; k++) {
            q = MOST * near[b][k];
            for (j = 0; j < count[near[b][k]]; ++j, ++q)
                u[q] += r[b][1];
            n_of[q + j % 2]++;
        }
}

/* One variable is the counter of two loops in a block. */
static void twice(int blocks) {
    for (int b = 0; b < blocks; b++) { // EXPECT: transformed
        int k, q;
        for (k = 0; k < 4; k++) {
            const int other = near[b][k], third = near[b][k + 1];
            const double e = r[b][0] * r[b][0] + r[b][1] * r[b][1] + r[b][2] * r[b][2] - 0.5; // INNER
            for (q = 0; q < 3; q++)
                u[MOST * other + q] += e;
            for (q = 4; q < 7; q++)
                u[MOST * third + q] -= e;
        }
    }
}

/* No blocks: two counters in one subscript, steps within the body, or bounds that the outer loop changes. */
static void others(int blocks) {
    for (int b = 0; b < blocks; b++) // EXPECT: transformed
        for (int k = 0; k < 3; k++) {
            const int other = near[b][k];
            for (int q = MOST * other / 2, j = 0; j < 5; j++, q++) {
                u[q + j] += r[b][0];
                for (int i = 0; i < j; i++)
                    n_of[MOST * other + i] += i;
            }
        }
    for (int b = 0; b < blocks; b++) // EXPECT: transformed
        for (int k = 0; k < 3; k++) {
            const int other = near[b][k];
            for (int q = MOST * other, j = 0; j < 4; j++, q++) {
                u[q] += r[b][1];
                q += j & 1;
            }
        }
    for (int b = 0; b < blocks; b++) // EXPECT: transformed
        for (int k = 0; k < 3; k++) {
            unsigned char q = (unsigned char)(near[b][k] + 250);
            for (int j = 0; j < 12; j++, q++)
                u[q] += r[b][2]; /* unsigned char: 255 + 1 is 0 */
        }
    for (int b = 0; b < blocks; b++) // EXPECT: transformed
        for (int k = 0; k < NEAR; k++) {
            int bound = count[near[b][k]];
            for (int p = 0; p < 2; p++) {
                for (int q = MOST * near[b][k], j = 0; j < bound; j++, q++)
                    u[q] += r[b][p] * r[b][p] + r[b][2] * r[b][2] - r[b][1] * 0.5;
                bound -= 3;
            }
        }
    for (int b = 0; b < blocks; b++) // EXPECT: transformed
        for (int k = 0; k < NEAR; k++)
            for (int q = MOST * near[b][k], j = 0; j < count[b]; j++, q++) {
                if (id[q] % 7 == 3)
                    n_of[order[q]]++;
                if (id[q] % 7 == 5)
                    break;
                n_of[q]++;
            }
}

static void start(int many) {
    for (int b = 0; b < ALL; b++)
        count[b] = case_below(many) - 1;
    case_values(&r[0][0], 3 * ROWS);
    for (int i = 0; i < ROWS; i++) {
        body[i].at = r[i][1];
        body[i].mass = r[i][2];
        id[i] = case_below(100000);
        order[i] = case_below(ROWS);
    }
    for (int b = 0; b < BLOCKS; b++)
        for (int k = 0; k < NEAR; k++) {
            const int other = b + case_below(41) - 20;
            near[b][k] = other < 0 ? BLOCKS + case_below(ALL - BLOCKS) : other;
        }
    if (!getenv("CASE_INTEGERS")) {
        r[17][0] = NAN;
        r[170][1] = INFINITY;
        r[1700][2] = -0.0;
    }
}

int main(void) {
    for (int many = 1; many < MOST + 2; many += 4)
        for (int call = 0; call < 2; call++) {
            if (call == 0)
                start(many);
            cells(BLOCKS, 1.5);
            with_the_bound(BLOCKS - 7);
            records(BLOCKS);
            parts(BLOCKS);
            asked_afterwards(BLOCKS);
            twice(BLOCKS);
            others(BLOCKS);
        }
    case_print("u", u, sizeof u);
    case_print("f", f, sizeof f);
    case_print("body", body, sizeof body);
    case_print("n", n_of, sizeof n_of);
    case_print("record", record, sizeof record);
    return 0;
}
