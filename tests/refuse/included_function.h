static inline void in_a_header(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++)
        h[s[t]]++;
}
