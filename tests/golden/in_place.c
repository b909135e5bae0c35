/* Slice and body stay in the loop's block, because of a value used after the loop, or a local type. */
struct system {
    double *h;
};

double last(int n, const int *s, const double *x, double *h) {
    double e = 0;
    for (int t = 0; t < n; t++) {
        e = x[t] * 3.0;
        h[s[t]] += e;
        if (e > 1)
            h[s[t] + 1] -= e;
    }
    return e;
}

void local_type(int n, const int *s, const double *x, struct system *out) {
    struct pair {
        double a, b;
    };
    for (int t = 0; t < n; t++) {
        struct pair p = {x[t], 1.0};
        out->h[s[t]] += p.a;
        out->h[s[t] + 1] -= p.b;
    }
}
