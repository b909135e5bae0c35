/* REDCC: --require --assume-noalias */
/* Expressions that must not be evaluated before the first iteration. */
#include <stdio.h>

struct system {
    int shift;
    double *x;
    int *map;
    double (*row)[3];
};

static void conditional_key(int n, const int *restrict k, double *restrict h, const struct system *s) {
    for (int t = 0; t < n; t++)
        if (s)
            h[k[t] + s->shift] += 0.1 * t;
}

static void conditional_source(int n, const int *restrict k, double *h, const struct system *s) {
    for (int t = 0; t < n; t++)
        if (s)
            h[k[t]] += s->x[t];
}

static void conditional_reads(int n, const int *restrict k, double *h, const struct system *s) {
    for (int t = 0; t < n; t++) {
        if (k[t] < 0)
            continue;
        h[s->map[k[t]]] += s->x[k[t]];
    }
}

static void division(int n, int m, const int *restrict k, double *restrict h, const int *restrict w) {
    for (int t = 0; t < n; t++)
        if (m)
            h[k[t] + n / m] += w[n % m];
}

static void certain(int n, const int *restrict k, double *h, const struct system *s) {
    for (int t = 0; t < n; t++)
        for (int c = 0; c < 3; c++)
            s->row[k[t] + s->shift][c] += h[t];
}

enum { SIZE = 15000, CELLS = 300 };
static int k[SIZE], map[CELLS];
static double h[CELLS * 2], x[SIZE], row[CELLS * 2][3];

static void show(const char *name, const void *data, unsigned long bytes) {
    const unsigned char *byte = data;
    unsigned long sum = 5381, i;
    for (i = 0; i < bytes; i++)
        sum = sum * 33 + byte[i];
    printf("%s %lu\n", name, sum);
}

int main(void) {
    static const struct system whole = {7, x, map, row};
    static const struct system *const systems[] = {&whole, NULL, &whole};
    struct system empty = {0, NULL, NULL, NULL};
    int i;
    for (i = 0; i < SIZE; i++) {
        k[i] = (i * 7919) % CELLS;
        x[i] = 1.0 / (i + 1);
    }
    for (i = 0; i < CELLS; i++)
        map[i] = CELLS - 1 - i;
    for (i = 0; i < 3; i++) {
        conditional_key(SIZE, k, h, systems[i]);
        conditional_source(SIZE, k, h, systems[i]);
        conditional_reads(SIZE, k, h, &whole);
        division(CELLS, i * 5, k, h, map);
        certain(CELLS, k, x, &whole);
        certain(0, k, x, NULL);
        conditional_reads(0, k, h, &empty);
    }
    show("h", h, sizeof h);
    show("row", row, sizeof row);
    return 0;
}
