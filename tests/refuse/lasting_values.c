/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Only some iterations assign a variable used after the loop, and the last such iteration cannot be recorded.
// covers: row 59 of docs/constructs.md
static void set(double *d, double x) {
    *d = x;
}

double by_function(int n, const int *k, double *h, const double *v) {
    double d = -1.0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (v[t] > 0.0) {
            set(&d, v[t]);
            h[k[t]] += d;
        }
    return d;
}

double by_pointer(int n, const int *k, double *h, const double *v) {
    double d = -1.0, *p = &d;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (v[t] > 0.0) {
            *p = v[t];
            h[k[t]] += d;
        }
    return d;
}

int in_condition(int n, const int *k, double *h) {
    int i = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (k[t] > 5 && (i = k[t] / 2) > 3)
            h[i] += 1;
    return i;
}

int in_chain(int n, const int *k, double *h) {
    int i = 0, j = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse last-value
        if (k[t] > 5) {
            i = j = k[t];
            h[j] += 1;
        }
    return i + j;
}

int in_update(int n, const int *k, double *h) {
    int i = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (k[t] > 5)
            h[i = k[t]] += 1;
    return i;
}

int in_header(int n, const int *k, double *h) {
    int i = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse last-value
        if (k[t] > 5)
            for (i = 0; i < 3; i++)
                h[k[t]] += i;
    return i;
}

int static_variable(int n, const int *k, double *h) {
    static int i;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (k[t] > 5) {
            i = k[t];
            h[i] += 1;
        }
    return i;
}

struct pair {
    int a;
    double b;
};

double of_record(int n, const int *k, double *h) {
    struct pair p = {0, 0};
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (k[t] > 5) {
            p.a = k[t];
            p.b = t;
            h[p.a] += p.b;
        }
    return p.b;
}

double of_array(int n, const int *k, double *h) {
    double f[2] = {0, 0};
    for (int t = 0; t < n; t++) // EXPECT: refuse last-value
        if (k[t] > 5) {
            f[0] = k[t];
            f[1] = t;
            h[k[t]] += f[0] + f[1];
        }
    return f[1];
}

int read_first(int n, const int *k, double *h) {
    int i = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] += i;
        if (k[t] > 5)
            i = k[t];
    }
    return i;
}

int read_where_not_assigned(int n, const int *k, double *h) {
    int i = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        if (k[t] > 5)
            i = k[t];
        if (k[t] > 4)
            h[i] += 1;
    }
    return i;
}

int by_the_array(int n, const int *k, double *h) {
    int i = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        h[k[t]] += 1;
        if (h[k[t]] > 3)
            i = t;
    }
    return i;
}

/* The running maximum, and a sum over the iterations that increased it, are carried between iterations. */
int place_of_most(int n, const int *k, double *h) {
    int most = 0, place = -1;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        h[k[t]] += 1;
        if (k[t] > most) {
            most = k[t];
            place += t;
        }
    }
    return place;
}
