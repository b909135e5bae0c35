/* REDCC: --order=any */
/* Two arrays with different rows, one of them an array variable whose size the loop uses. */
double sums[100][2];
void any(int n, const int *restrict k, long *restrict count);
void any(int n, const int *restrict k, long *restrict count) {
    for (int t = 0; t < n; t++) {
        sums[k[t]][0] += 1.0;
        sums[k[t]][1] += (double)sizeof sums;
        count[k[t]] |= 1L << (t & 31);
    }
}
