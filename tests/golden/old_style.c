/* REDCC: -std=c89 */
/* K&R definitions and implicit int; declarations only at the beginning of blocks. */
old(n, k, h)
int n, *k;
double *h;
{
    register int t;
    for (t = 0; t < n; t += 3) {
        int i = k[t];
        h[i] += 1;
    }
    return t;
}
