/* Its lines end in CR LF. */
void crlf(int n, const int *restrict k, int *restrict h);
void crlf(int n, const int *restrict k, int *restrict h) {
    int t;
    for (t = 0; t < n; t++) {
        h[k[t]] += 1; /* body */
    }
}
