/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Rows behind pointers in memory: the loop changes or reads the pointers, or the pointers are in no fixed table.
// covers: row 48, row 49 of docs/constructs.md

typedef __SIZE_TYPE__ size_t;
void *realloc(void *, size_t);

struct list {
    double value;
    double *data;
    struct list *next;
};

void row_stored(int n, const int *k, double **rows, double *other) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        rows[k[t]][0] += 1.0;
        rows[t] = other + t;
    }
}

void row_stored_by_other_name(int n, const int *k, double **rows, double *other) {
    double **const same = rows;
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        rows[k[t]][0] += 1.0;
        same[t] = other + t;
    }
}

void row_allocated(int n, const int *k, double **rows) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        rows[k[t]] = realloc(rows[k[t]], 80);
        rows[k[t]][0] += 1.0;
    }
}

void row_incremented(int n, const int *k, double **rows) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse element-type
        rows[k[t]]++;
        rows[k[t]][0] += 1.0;
    }
}

void element_after_element(int n, const int *k, double **rows) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        *rows[k[t]]++ += 1.0;
}

void rows_in_turn(int n, const int *k, double **rows) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        (*rows)[k[t]] += 1.0;
        rows++;
    }
}

void rows_of_iteration(int n, const int *k, double *a, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse row-pointers
        double *rows[2] = {a + t, b + t};
        rows[k[t]][0] += 1.0;
    }
}

void rows_set_again(int n, const int *k, double *a, double *b) {
    double *rows[2];
    for (int t = 0; t < n; t++) { // EXPECT: refuse row-pointers
        rows[0] = a + t;
        rows[1] = b + t;
        rows[k[t]][0] += 1.0;
    }
}

void rows_chosen(int n, const int *k, double **a, double **b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse row-pointers
        double **rows = k[t] & 1 ? a : b;
        rows[k[t]][0] += 1.0;
    }
}

void row_read(int n, const int *k, const int *from, double **rows) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        rows[k[t]][0] += rows[from[t]][1];
}

void row_read_in_condition(int n, const int *k, double **rows) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        if (rows[t][0] > 0)
            rows[k[t]][0] += 1.0;
}

void subscript_from_row(int n, const int *k, long **rows) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        rows[k[t] + rows[t][1]][0] += 1;
}

void value_used(int n, const int *k, int **rows, int *out) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        out[t] = rows[k[t]][0]++;
}

void counter_read(int n, const int *k, int **counter, int *out) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        *counter[k[t]] += 1;
        out[t] = *counter[k[t]];
    }
}

void stored_and_read(int n, const int *k, int **rows, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        rows[k[t]][0] = t % 100;
        h[rows[k[t]][0]] += 1.0;
    }
}

void followed(int n, const int *k, struct list *head) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        struct list *p = head;
        while (p->next)
            p = p->next;
        p->data[k[t]] += 1.0;
    }
}

static void shift(double *row) {
    row[0] += 1.0;
    row[1] -= row[0];
}

void whole_rows(int n, const int *k, double (**rows)[2]) {
    for (int t = 0; t < n; t++) // EXPECT: refuse row-pointers
        shift(rows[k[t]][t % 5]);
}

void own_row(int n, const int *k, double **rows) {
    double f[2];
    rows[3] = f;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        f[0] = t;
        f[1] = 2 * t;
        rows[k[t]][0] += f[1];
    }
}

void own_scalar(int n, const int *k, const double *e, double **rows) {
    double sum = 0;
    rows[3] = &sum;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        sum += e[t];
        rows[k[t]][0] += 1.0;
    }
}

void own_counter(int n, const int *k, int **rows) {
    int t;
    rows[3] = &t;
    for (t = 0; t < n; t++) // EXPECT: nothing
        rows[k[t]][0] += 1;
}

union word {
    double *row;
    long bits;
};

void rows_in_unions(int n, const int *k, union word *rows) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        rows[k[t]].row[0] += 1.0;
}

void rows_as_numbers(int n, const int *k, const long *rows) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        ((double *)rows[k[t]])[0] += 1.0;
}

void volatile_rows(int n, const int *k, double *volatile *rows) {
    for (int t = 0; t < n; t++) // EXPECT: refuse volatile
        rows[k[t]][0] += 1.0;
}
