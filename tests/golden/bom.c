/* The first bytes are a byte order mark. */
void bom(int n, const int *restrict k, int *restrict h);
void bom(int n, const int *restrict k, int *restrict h) {
    for (int t = 0; t < n; t++)
        h[k[t]] += 1;
}