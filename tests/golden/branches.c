/* Conditional branches that this compilation selects, and others. */
struct table {
    double *value;
    int *count;
};

void collect(int n, const int *k, const double *e, struct table *to) {
    for (int t = 0; t < n; t++) {
        double w = e[t];
#ifdef ABSOLUTE
        if (w < 0)
            w = -w;
#elif defined(SQUARED)
        w *= w;
#endif
        to->value[k[t]] += w;
#ifndef WITHOUT_COUNTS
        to->count[k[t]]++;
#else
        to->count = 0;
#endif
    }
}
