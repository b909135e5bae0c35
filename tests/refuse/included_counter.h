enum { COUNTED = __COUNTER__ };
static void counted(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse in-header
        h[s[t]]++;
}
