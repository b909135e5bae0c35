/* Prefetch distances for iterations of 3, 18, 150, 840 and about 12,000 operations. */
#include <math.h>

static double series(double x, double y) {
    return sqrt(x) / y + x / (y + 1.0) - sqrt(y) / x;
}

void few(int n, const int (*edge)[2], const double *restrict w, double *restrict f) {
    for (int t = 0; t < n; t++)
        f[edge[t][0]] += 2.0 * w[t];
}

void light(int n, const int (*edge)[2], const double (*restrict x)[3], double (*restrict f)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = edge[t][0], j = edge[t][1];
        for (int c = 0; c < 3; c++) {
            f[i][c] += 2.0 * (x[j][c] - x[i][c]);
            f[j][c] -= 2.0 * (x[j][c] - x[i][c]);
        }
    }
}

void middle(int n, const int (*edge)[2], const double (*restrict x)[3], double (*restrict f)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = edge[t][0], j = edge[t][1];
        for (int c = 0; c < 3; c++)
            f[i][c] += series(x[j][c], x[i][c]) + 1.0 / x[j][c];
    }
}

void heavy(int n, const int (*edge)[2], const double (*restrict x)[3], double (*restrict f)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = edge[t][0], j = edge[t][1];
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int k = 0; k < 6; k++)
                sum += series(x[j][c] + k, x[i][c]);
            f[i][c] += sum;
        }
    }
}

void heaviest(int n, const int (*edge)[2], const double (*restrict x)[3], double (*restrict f)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = edge[t][0], j = edge[t][1];
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int k = 0; k < 99; k++)
                sum += series(x[j][c] + k, x[i][c]);
            f[i][c] += sum;
        }
    }
}
