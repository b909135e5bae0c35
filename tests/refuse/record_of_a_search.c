/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Members that only some iterations update, of a record that may not exist in other iterations. No read in the loop or
 * its callees is certain to be executed. */
// covers: row 46 of docs/constructs.md
struct matrix {
    int *column;
    double *restrict value;
};

static int find(const struct matrix *a, int row) {
    if (row < 0)
        return -1;
    return a->column[row];
}

static int find_in_another(const struct matrix *a, const struct matrix *b, int row) {
    if (row < 0)
        a = b;
    return a->column[row & 7];
}

static int find_elsewhere(const struct matrix *a, int row) {
    return a ? row : -1;
}

__attribute__((weak)) int find_weakly(const struct matrix *a, int row) {
    return a->column[row & 7];
}

void in_some_rows(struct matrix *restrict a, int n, const int *restrict row) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-conditional
        const int at = find(a, row[i]);
        if (at >= 0)
            a->value[at] += 1.0;
    }
}

void of_another(struct matrix *restrict a, struct matrix *restrict b, int n,
                const int *restrict row) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-conditional
        const int at = find_in_another(a, b, row[i]);
        if (at >= 0)
            a->value[at] += 1.0;
    }
}

void not_read(struct matrix *restrict a, int n, const int *restrict row) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-conditional
        const int at = find_elsewhere(a, row[i]);
        if (at >= 0)
            a->value[at] += 1.0;
    }
}

void replaced(struct matrix *restrict a, int n, const int *restrict row) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse impure-call
        const int at = find_weakly(a, row[i]);
        if (at >= 0)
            a->value[at] += 1.0;
    }
}
