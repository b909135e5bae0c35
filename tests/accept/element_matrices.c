/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Element matrices are added into a sparse matrix. The position of an entry is searched for in its row,
// which a table gives.
// covers: row 5, row 7 of docs/constructs.md
#include "case.h"

enum { NODES = 1500, ELEMENTS = 2000, CORNERS = 4, MOST = 40 };
struct element {
    int node[CORNERS];
    double stiffness;
};
static struct element element[ELEMENTS];
static int row_begin[NODES + 1], column[NODES * MOST];
static double matrix[NODES * MOST], other[NODES * MOST];

static void left_by_break(int n, const struct element *e, double *K, const int *begin) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int a = 0; a < CORNERS; a++)
            for (int b = 0; b < CORNERS; b++) {
                const int row = e[t].node[a];
                for (int k = begin[row]; k < begin[row + 1]; k++)
                    if (column[k] == e[t].node[b]) {
                        K[k] += e[t].stiffness * (a == b ? 3 : -1);
                        break;
                    }
            }
}

static void searched_before(int n, const struct element *e, double *K, const int *begin) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int a = 0; a < CORNERS; a++)
            for (int b = 0; b < CORNERS; b++) {
                const int row = e[t].node[a], last = begin[row + 1];
                int k;
                for (k = begin[row]; k < last; k++)
                    if (column[k] == e[t].node[b])
                        break;
                K[k] -= e[t].stiffness;
            }
}

static void whole_rows(int n, const struct element *e, double *K) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int row = e[t].node[0], first = row_begin[row];
        for (int k = first; k < row_begin[row + 1]; k++)
            K[k] *= e[t].stiffness > 0.0 ? 0.5 : 1.0;
    }
}

int main(void) {
    static int seen[NODES][MOST], count[NODES];
    for (int t = 0; t < ELEMENTS; t++) {
        const int near = (int)((long)t * (NODES - 12) / ELEMENTS);
        for (int a = 0; a < CORNERS; a++)
            element[t].node[a] = near + 3 * a + case_below(3);
        element[t].stiffness = case_value();
    }
    for (int t = 0; t < ELEMENTS; t++)
        for (int a = 0; a < CORNERS; a++)
            for (int b = 0; b < CORNERS; b++) {
                const int row = element[t].node[a];
                int k = 0;
                while (k < count[row] && seen[row][k] != element[t].node[b])
                    k++;
                if (k == count[row])
                    seen[row][count[row]++] = element[t].node[b];
            }
    for (int i = 0; i < NODES; i++) {
        row_begin[i + 1] = row_begin[i] + count[i];
        for (int k = 0; k < count[i]; k++)
            column[row_begin[i] + k] = seen[i][k];
    }
    for (int step = 0; step < 3; step++) {
        left_by_break(ELEMENTS - step, element, matrix, row_begin);
        searched_before(ELEMENTS, element, other, row_begin);
        whole_rows(ELEMENTS, element, other);
    }
    CASE_PRINT(matrix);
    CASE_PRINT(other);
    return 0;
}
