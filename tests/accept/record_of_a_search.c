/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A matrix in a record, whose entries a function finds by bisection. Entries are updated if one was found. The
// function's other reads show that the pointer to the entries is valid.
// covers: row 46 of docs/constructs.md
// INTEGERS: no
#include "case.h"
#include <math.h>

enum { SIDE = 40, NODES = SIDE * SIDE, ELEMENTS = 2 * (SIDE - 1) * (SIDE - 1), WIDTH = 7 };
struct matrix {
    int rows;
    int *first, *column;
    double *value;
};
static int corner[ELEMENTS][3], first[NODES + 1], column[NODES * WIDTH];
static double place[NODES][2], value[NODES * WIDTH];

static int find(const struct matrix *a, int row, int col) {
    int low = a->first[row], high = a->first[row + 1] - 1;
    while (low <= high) {
        const int middle = (low + high) / 2;
        if (a->column[middle] == col)
            return middle;
        if (a->column[middle] < col)
            low = middle + 1;
        else
            high = middle - 1;
    }
    return -1;
}

static int in_row(const struct matrix *a, int row, int col) {
    return find(a, row, col);
}

static void assemble(struct matrix *a, int n, const int (*triangle)[3], const double (*x)[2]) {
    for (int e = 0; e < n; e++) { // EXPECT: transformed
        double b[3], c[3];
        const int *v = triangle[e];
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            b[i] = x[v[j]][1] - x[v[k]][1];
            c[i] = x[v[k]][0] - x[v[j]][0];
        }
        const double area = 0.5 * fabs(b[0] * c[1] - b[1] * c[0]);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                const int at = find(a, v[i], v[j]);
                if (at >= 0)
                    a->value[at] += (b[i] * b[j] + c[i] * c[j]) / (4 * area);
            }
    }
    for (int e = 0; e < n; e++) { // EXPECT: transformed
        const int at = in_row(a, triangle[e][0], triangle[e][1]);
        if (at >= 0)
            a->value[at] -= x[e % NODES][0];
    }
}

static void number(struct matrix *a) {
    int n = 0;
    for (int i = 0; i < NODES; i++) {
        static const int near[WIDTH] = {-SIDE - 1, -SIDE, -1, 0, 1, SIDE, SIDE + 1};
        a->first[i] = n;
        for (int k = 0; k < WIDTH; k++)
            if (i + near[k] >= 0 && i + near[k] < NODES && (k != 1 || i % 7))
                a->column[n++] = i + near[k];
    }
    a->first[NODES] = n;
}

int main(void) {
    static struct matrix a = {NODES, first, column, value};
    int n = 0;
    for (int i = 0; i < SIDE - 1; i++)
        for (int j = 0; j < SIDE - 1; j++) {
            const int p = i * SIDE + j;
            const int two[2][3] = {{p, p + 1, p + SIDE + 1}, {p, p + SIDE + 1, p + SIDE}};
            for (int k = 0; k < 6; k++)
                corner[n + k / 3][k % 3] = two[k / 3][k % 3];
            n += 2;
        }
    number(&a);
    for (int round = 0; round < 5; round++) {
        for (int i = 0; i < NODES; i++) {
            place[i][0] = i % SIDE + 0.25 * case_value();
            place[i][1] = i / SIDE + 0.25 * case_value();
        }
        assemble(&a, n - round, (const int(*)[3])corner, (const double(*)[2])place);
        CASE_PRINT(value);
    }
    return 0;
}
