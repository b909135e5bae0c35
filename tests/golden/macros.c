/* Macros in and around loops. */
#define UPDATE(array, index, value) array[index] += (value)
#define EACH(t, n) for (int t = 0; t < (n); t++)
#define TWO(i) h[k[i]] += 1; h[m[i]] += 2
#define IDX(i, j) ((i) * 4 + (j))
struct grid {
    int size;
    double *cell;
};
void macros(int n, const int *restrict k, const int *restrict m, double *restrict h, struct grid *restrict g);
void macros(int n, const int *restrict k, const int *restrict m, double *restrict h, struct grid *restrict g) {
    for (int t = 0; t < n; t++)
        UPDATE(h, k[t], 1.0);
    for (int t = 0; t < n; t++)
        UPDATE(g->cell, k[t], 1.0);
    EACH(t, n) {
        h[k[t]] += 1.0;
    }
    EACH(t, n) UPDATE(h, k[t], 2.0);
    for (int t = 0; t < n; t++) {
        if (k[t] > 2) { TWO(t); }
    }
    for (int t = 0; t < n; t++)
        g->cell[IDX(k[t], 1)] += 1.0;
}
