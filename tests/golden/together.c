/* Several arrays share one record per subscript, if each is updated only together with the others. */
void springs(int n, const int (*restrict edge)[2], const double *restrict length, double *restrict fx,
             double *restrict fy, double *restrict fz);
void springs(int n, const int (*restrict edge)[2], const double *restrict length, double *restrict fx,
             double *restrict fy, double *restrict fz) {
    for (int t = 0; t < n; t++) {
        const int i = edge[t][0], j = edge[t][1];
        const double f = length[t] - 1;
        fx[i] += f;
        fy[i] += f * 2;
        fz[i] += f * 3;
        fx[j] -= f;
        fy[j] -= f * 2;
        fz[j] -= f * 3;
    }
}

void means(int n, const int *restrict k, const float *restrict value, long *restrict count,
           double *restrict sum, double *restrict largest);
void means(int n, const int *restrict k, const float *restrict value, long *restrict count,
           double *restrict sum, double *restrict largest) {
    for (int t = 0; t < n; t++) {
        count[k[t]]++;
        sum[k[t]] += value[t];
        if (value[t] > largest[k[t]])
            largest[k[t]] = value[t];
    }
}

/* The third array is also updated without the other two. */
void partly(int n, const int *restrict k, double *restrict a, double *restrict b, double *restrict c);
void partly(int n, const int *restrict k, double *restrict a, double *restrict b, double *restrict c) {
    for (int t = 0; t < n; t++) {
        a[k[t]] += 1;
        b[k[t]] += 2;
        c[k[t]] += 3;
        c[k[t] / 2] -= 1;
    }
}
