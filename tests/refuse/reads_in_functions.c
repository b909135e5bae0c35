/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Unlike in accept/reads_in_functions.c, redcc cannot determine which elements the functions read.
// covers: row 80, row 81 of docs/constructs.md

/* `last` is the subscript that the previous iteration used. */
static double before(const double *x, const int node[4]) {
    double sum = 0;
    int last;
    for (int a = 0; a < 4; a++) {
        if (a > 0)
            sum += x[last];
        last = node[a];
    }
    return sum;
}

void of_the_turn_before(int n, const int (*node)[4], const double *x, double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[node[e][0]] += before(x, node[e]);
}

/* `last` was set in another loop, whose counter has the same name. */
static double after(const double *x, const int node[4]) {
    double sum = 0;
    int a, last;
    for (a = 0; a < 3; a++)
        last = node[a];
    for (a = 0; a < 4; a++)
        sum += x[last] * a;
    return sum;
}

void of_another_loop(int n, const int (*node)[4], const double *x, double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[node[e][0]] += after(x, node[e]);
}

/* `list` is read only under the condition, so it may be shorter than `count`. */
static double chosen(const double *x, const int *list, const double *weight, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++)
        if (weight[k] > 0)
            sum += x[list[k]];
    return sum;
}

void of_some_turns(int n, const int *count, const int *to, const int *list, const double *weight,
                   const double *x, double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += chosen(x, list, weight, count[e]);
}

/* `list` is not read after the loop ends early. */
static double up_to(const double *x, const int *list, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++) {
        sum += x[list[k]];
        if (sum > 1)
            break;
    }
    return sum;
}

void left_early(int n, const int *count, const int *to, const int *list, const double *x,
                double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += up_to(x, list, count[e]);
}

static double left_inside(const double *x, const int *list) {
    double sum = 0;
    for (int a = 0; a < 4; a++)
        for (int c = 0; c < 3; c++) {
            if (x[c] > 1)
                break;
            sum += x[list[a]];
        }
    return sum;
}

void left_before(int n, const int (*list)[4], const int *to, const double *x, double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += left_inside(x, list[e]);
}

static double in_steps(const double *x, int count, double limit) {
    for (int k = 0; k < count; k += 2)
        if (x[k] > limit)
            return x[k];
    return 0;
}

void left_early_in_steps(int n, const int *count, const int *to, const double *x, double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += in_steps(x, count[e], 0.5);
}

static double skipping(const double *x, const int *list, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++) {
        sum += x[list[k]];
        if (sum < 0)
            k++;
    }
    return sum;
}

void counter_moved(int n, const int *count, const int *to, const int *list, const double *x,
                   double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += skipping(x, list, count[e]);
}

struct part {
    int from, end;
};

/* The bounds exist only in some iterations. */
static double of_part(const double *x, const struct part *p) {
    double sum = 0;
    if (p)
        for (int k = p->from; k < p->end; k++)
            sum += x[k];
    return sum;
}

void bounds_not_there(int n, const struct part *const *part, const int *to, const double *x,
                      double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += of_part(x, part[e]);
}

static double returned_before(const double *x, const int *list, const int *count) {
    double sum = 0;
    if (!count)
        return 0;
    for (int k = 0; k < *count; k++)
        sum += x[list[k]];
    return sum;
}

void returns_before(int n, const int *const *count, const int *to, const int *list,
                    const double *x, double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += returned_before(x, list, count[e]);
}

/* The loop's updated array is read by its name. */
static double dot(const int *ptr, const int *col, const double *x, int i) {
    double s = 0;
    for (int k = ptr[i]; k < ptr[i + 1]; k++)
        s += x[col[k]];
    return s;
}

void by_its_name(int n, const int *ptr, const int *col, const int *to, double *y) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        y[to[i]] += dot(ptr, col, y, i);
}

/* The call is under a condition in the same statement. */
void behind_a_condition(int n, const int *ptr, const int *col, const double *x, const int *to,
                        double *y) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        y[to[i]] += i > 2 ? dot(ptr, col, x, i) : 0;
}

/* A jump leads into the loop, to one of its case labels. */
static double entered(const double *x, const int *list, int count, int first) {
    double sum = 0;
    int k = first;
    switch (count) {
    case 0:
        for (k = 0; k < 4; k++) {
        case 1:
            sum += x[list[k]];
        }
    }
    return sum;
}

void into_the_loop(int n, const int *count, const int *to, const int *list, const double *x,
                   double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        b[to[e]] += entered(x, list, count[e], 2);
}

/* The function stores to `list`, which its next read uses. */
static void renumber(const double *x, int *list, double *out) {
    for (int k = 0; k < 4; k++) {
        list[k + 1] = k;
        *out += x[list[k]];
    }
}

void writes_its_list(int n, const int *to, int (*list)[4], const double *x, double *b) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-updates
        renumber(x, list[e], &b[to[e]]);
}

/* Only some calls read the second row, so its pointer must not be read before the loop. */
static float apart(const float *a, const float *b, int n) {
    float sum = 0;
    for (int d = 0; d < n; d++)
        sum += (a[d] - b[d]) * (a[d] - b[d]);
    return sum;
}

static float where_there_is_one(const float *f, float **rows, int n) {
    if (n < 2)
        return 0;
    return apart(f, rows[0], n) / 3;
}

void of_some_calls(int n, const int *k, float **f, float **rows, int d, float *b) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        b[k[i]] += where_there_is_one(f[i], rows, d);
}

static float in_turns(const float *f, float **rows, int n) {
    float sum = 0;
    for (int q = 0; q < n; q++)
        sum += apart(f, rows[0], n);
    return sum;
}

void of_some_loops(int n, const int *k, float **f, float **rows, int d, float *b) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        b[k[i]] += in_turns(f[i], rows, d);
}

static float from_the_first(const float *f, float **rows, int n) {
    return apart(f, rows[0], n) / 5;
}

void of_calls_in_some_iterations(int n, const int *k, float **f, float **rows, int d, float *b) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse callee-reads
        float v = 0;
        if (k[i] > 3)
            v = from_the_first(f[i], rows, d);
        b[k[i]] += v;
    }
}
