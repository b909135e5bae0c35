#pragma once
static inline void deeper(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse in-header
        h[s[t]]++;
}
static inline void in_a_header(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse in-header
        h[s[t]]++;
    for (int t = 0; t < n; t++)
        h[t] = s[t];
    deeper(n, s, h);
}
static void in_a_table(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++)
        for (int k = s[t]; k < s[t + 1]; k++) // EXPECT: refuse in-header
            h[s[k]] += k;
}
static inline void not_used(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++)
        h[s[t]]++;
}
