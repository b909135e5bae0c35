/* REDCC: --lanes=4 */
/* Which short loops are unrolled, and which vector variables must be initialised. */
void blocks(int n, const int (*k)[3], const double (*restrict x)[9], double (*restrict a)[9]) {
    for (int t = 0; t < n; t++) {
        double small[3], large[9], some[3];
        for (int c = 0; c < 3; c++)
            small[c] = x[t][c] * x[t][c + 3];
        for (int p = 0; p < 9; p++) {
            large[p] = 0.0;
            for (int q = p; q < 9; q++)
                large[p] += small[q % 3] * x[t][p];
        }
        if (x[t][0] > 0.0)
            for (int c = 0; c < 3; c++)
                some[c] = small[c];
        else
            for (int c = 0; c < 3; c++)
                some[c] = 1.0;
        for (int p = 0; p < 3; p++)
            for (int c = 0; c < 9; c++)
                a[k[t][p]][c] += large[c] * some[p];
    }
}

void many(int n, const int *restrict k, const double (*restrict x)[64], double (*restrict a)[64]) {
    for (int t = 0; t < n; t++) {
        double sum = 0.0;
        for (int p = 0; p < 64; p++)
            for (int q = 0; q < 17; q++)
                sum += x[t][p] * x[t][q] / (x[t][p] + x[t][q]);
        for (int p = 0; p < 17; p++)
            for (int q = 0; q < p; q++)
                sum += x[t][q];
        for (int p = 0; p < 16; p++)
            for (int q = p; q >= 0; q--)
                a[k[t]][q] += sum;
    }
}

void by_the_user(int n, const int (*k)[3], const double *restrict x, double *restrict a) {
    for (int t = 0; t < n; t++) {
#pragma GCC unroll 1
        for (int c = 0; c < 3; c++)
            a[k[t][c]] += x[t];
        switch (k[t][0]) {
        case 1:
            for (int c = 0; c < 3; c++)
                a[k[t][c]] -= x[t];
        }
    }
}

static void clip(const double *x, double *f) {
    if (x[0] > 0.0)
        f[0] = x[0];
    else
        f[0] = x[1];
}

void clipped(int n, const int *restrict k, const double (*restrict x)[2], double *restrict a) {
    for (int t = 0; t < n; t++) {
        double f[1], g[1];
        clip(x[t], f);
        g[0] = f[0] * 2.0;
        a[k[t]] += g[0];
    }
}

void over_lists(int n, const int *first, const int *partner, const double (*restrict x)[3],
                double (*restrict f)[3]) {
    for (int t = 0; t < n; t++)
        for (int p = first[t]; p < first[t + 1]; p++)
            for (int c = 0; c < 3; c++) {
                f[t][c] += x[partner[p]][c];
                f[partner[p]][c] -= x[t][c];
            }
}
