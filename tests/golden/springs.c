/* The loop of docs/generated-code.md. */
struct system {
    double (*b)[3];
};

static void spring(const double (*x)[3], int i, int j, double *f) {
    for (int c = 0; c < 3; c++)
        f[c] = 0.5 * (x[j][c] - x[i][c]);
}

void springs(int n, const int (*edge)[2], const double (*x)[3], struct system *s);
void springs(int n, const int (*edge)[2], const double (*x)[3], struct system *s) {
    int t, i, j;
    double f[3];
    for (t = 0; t < n; t++) {
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            s->b[i][c] += f[c];
            s->b[j][c] -= f[c];
        }
    }
}
