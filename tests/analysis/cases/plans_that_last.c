/* Which arrays decide whether a plan is still valid: those that select the elements that may be
 * touched, not those of conditions that decide whether an element is touched. */
void cut_off(int n, double *restrict f, const double *restrict x, const int *restrict p,
             const int *restrict q, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) verifiable rests-on=p,q
        int i = p[t], j = q[t];
        double d = x[i] - x[j];
        if (d * d > cut)
            continue;
        f[i] += d;
        f[j] -= d;
    }
}

void cut_off_in_a_row(int n, double *restrict f, const double *restrict x,
                      const int *restrict start, const int *restrict q, double cut) {
    for (int i = 0; i < n; i++) // EXPECT: transform f(+) verifiable rests-on=start,q
        for (int k = start[i]; k < start[i + 1]; k++) {
            int j = q[k];
            double d = x[i] - x[j];
            if (d * d > cut)
                continue;
            f[i] += d;
            f[j] -= d;
        }
}

void components(int n, double *restrict f, const double *restrict x, const int *restrict p,
                double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) verifiable rests-on=p
        int i = p[t];
        double r = x[3 * i] * x[3 * i + 1];
        if (r > cut)
            continue;
        for (int c = 0; c < 3; c++)
            f[3 * i + c] += r;
    }
}

void components_under_a_condition(int n, double *restrict f, const double *restrict x,
                                  const int *restrict p, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) verifiable rests-on=p
        int i = p[t];
        double r = x[3 * i] * x[3 * i + 1];
        if (r <= cut) {
            int first = 3 * i;
            for (int c = 0; c < 3; c++)
                f[first + c] += r;
        }
    }
}

/* The load of q[i] is executed only under the condition, and might be out of bounds otherwise. */
void read_behind(int n, double *restrict f, const double *restrict x, const int *restrict p,
                 const int *restrict q, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) rests-on=p,x,q
        int i = p[t];
        if (x[i] <= cut) {
            int j = q[i];
            f[j] += x[i];
        }
    }
}

void read_behind_in_a_row(int n, double *restrict f, const double *restrict x,
                          const int *restrict start, const int *restrict q, double cut) {
    for (int i = 0; i < n; i++) // EXPECT: transform f(+) rests-on=start,x,q
        for (int k = start[i]; k < start[i + 1]; k++) {
            if (x[k] > cut)
                continue;
            int j = q[k];
            f[j] += x[k];
        }
}

/* The condition's counter `place` keeps its value for the next turn of the inner loop. */
void counted_in_a_row(int n, double *restrict f, const double *restrict x,
                      const int *restrict start, double cut) {
    for (int i = 0; i < n; i++) { // EXPECT: transform f(+) rests-on=start,x
        int place = 0;
        for (int k = start[i]; k < start[i + 1]; k++) {
            if (x[k] > cut)
                continue;
            f[3 * start[i] + place] += x[k];
            place++;
        }
    }
}

void kept_from_the_round_before(int n, double *restrict f, const double *restrict x,
                                const int *restrict p, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) rests-on=p,x
        int at = p[t], c;
        for (c = 0; c < 3; c++) {
            if (x[3 * t + c] > cut)
                continue;
            f[at] += x[3 * t + c];
            at = c;
        }
    }
}

void leaves_after(int n, double *restrict f, const double *restrict x, const int *restrict start,
                  const int *restrict q, double cut) {
    for (int i = 0; i < n; i++) // EXPECT: transform f(+) rests-on=start,q,x
        for (int k = start[i]; k < start[i + 1]; k++) {
            int j = q[k];
            if (x[k] > cut)
                continue;
            f[j] += x[k];
            if (j == 5)
                break;
        }
}

void set_by_the_condition(int n, double *restrict f, const double *restrict x,
                          const int *restrict p, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) rests-on=x,p
        int i = 0;
        if (x[t] > cut) {
            int j = p[t];
            i = j;
        }
        f[i] += x[t];
    }
}

/* The inner counter's value is used after the condition. */
void counter_outlives(int n, double *restrict f, const double *restrict x, const int *restrict p,
                      double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) rests-on=x,p
        int c = 0;
        if (x[t] <= cut)
            for (c = 0; c < 3; c++)
                f[3 * p[t] + c] += x[t];
        f[p[t] + c] += 1;
    }
}

void divides(int n, double *restrict f, const double *restrict x, const int *restrict p, int m,
             double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) rests-on=p,x
        int i = p[t];
        if (x[t] <= cut) {
            int at = i / m;
            f[at] += x[t];
        }
    }
}

static int find(const int *start, const int *col, int row, int column) {
    for (int k = start[row]; k < start[row + 1]; k++)
        if (col[k] == column)
            return k;
    return -1;
}

void searched(int n, double *restrict f, const int *start, const int *col, const int *p,
              const int *q) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) verifiable rests-on=p,q,start,col
        int k = find(start, col, p[t], q[t]);
        if (k >= 0)
            f[k] += 1;
    }
}

/* Unlike in `find`, each next position is read from an array, so the range of positions is not known in advance. */
static int follow(const int *next, const int *col, int at, int column) {
    while (col[at] != column && next[at] > at)
        at = next[at];
    return col[at] == column ? at : -1;
}

void followed(int n, double *restrict f, const int *next, const int *col, const int *p,
              const int *q) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) not-verifiable
        int k = follow(next, col, p[t], q[t]);
        if (k >= 0)
            f[k] += 1;
    }
}

/* A function's conditional read is recorded without its condition. */
static double optional(const double *x, const int *at, int t, int is_there) {
    return is_there ? x[at[t]] : 1;
}

void maybe_no_table(int n, double *h, const double *x, const int *p, const int *at, int is_there) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        h[p[t]] += optional(x, at, t, is_there);
}

void table_in_any_case(int n, double *h, const double *x, const int *p, const int *at,
                       int is_there) {
    for (int t = 0; t < n; t++) { // EXPECT: transform h(+) guards=1 verifiable
        h[p[t]] += optional(x, at, t, is_there);
        h[at[t]] += 1;
    }
}

struct bodies {
    int n;
    double *f;
    const double *x;
};

/* Only the condition's branch reads the array's pointer, but each iteration reads another member of *s. */
void pairs_in_a_record(struct bodies *s, double cut) {
    for (int i = 0; i < s->n; i++) // EXPECT: transform s->f(+) verifiable
        for (int k = i + 1; k < s->n; k++) {
            double d = s->x[i] - s->x[k];
            if (d < cut) {
                s->f[i] += d;
                s->f[k] -= d;
            }
        }
}

/* Perhaps no iteration reads *s: the condition, which does not read it, may always be false. */
void optional_record(struct bodies *s, int m, const int *restrict p, const double *restrict x,
                     double cut) {
    for (int t = 0; t < m; t++) { // EXPECT: refuse base-conditional
        int i = p[t];
        if (x[i] < cut)
            s->f[i] += 1;
    }
}
