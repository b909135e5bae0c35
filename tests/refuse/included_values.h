static int put(int n, const int *restrict s, int *restrict place) {
    int k = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        k += place[s[t]]++;
    return k;
}
