void of_a_source(int n, const int *s, const double *e, double *f);
void of_a_source(int n, const int *s, const double *e, double *f) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        f[s[t]] += e[t];
        f[s[n - 1 - t]] -= 2 * e[t];
    }
}