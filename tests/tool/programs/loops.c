/* REDCC: --require */
/* Every form of loop and of its surroundings that redcc can rewrite. The last bits of the values
 * show a change of order. */
#include <stdio.h>
#include <string.h>

#define SIZE 20000
#define CELLS 700
#define UPDATE(array, index, value) array[index] += (value)
#define BOTH(i) do { s->cell[k[i]] += w[i]; if (w[i] > 0.5) s->cell[m[i]] -= 0.25; } while (0)

struct grid {
    double *cell;
    struct { double weight, length; } part[CELLS];
    double (*row)[3];
};

static int k[SIZE], m[SIZE];
static double w[SIZE], h[CELLS], rows[CELLS][3], cells[CELLS];
static float narrow[CELLS];
static unsigned long bits[CELLS];
static struct grid grid;

static void show(const char *name, const void *data, size_t bytes) {
    const unsigned char *byte = data;
    unsigned long sum = 5381;
    size_t i;
    for (i = 0; i < bytes; i++)
        sum = sum * 33 + byte[i];
    printf("%s %lu\n", name, sum);
}

static void fill(void) {
    unsigned long state = 7;
    int i;
    for (i = 0; i < SIZE; i++) {
        state = state * 6364136223846793005UL + 1442695040888963407UL;
        k[i] = (int)((state >> 33) % CELLS);
        m[i] = (int)((state >> 20) % CELLS);
        w[i] = (double)(state >> 11) / 9007199254740992.0;
    }
}

static int plain(int n) {
    int t;
    for (t = 0; t < n; t++)
        h[k[t]] += w[t];
    return t;
}

static long stepping(long from, long to) {
    long t;
    for (t = from; t > to; t -= 3)
        h[m[t]] -= w[t] * 0.1;
    return t;
}

static size_t inclusive(size_t n) {
    size_t t;
    for (t = 1; t <= n; t += 2) {
        if (k[t] % 5 == 0)
            continue;
        if (k[t] % 2)
            narrow[k[t]] += (float)w[t];
        else
            narrow[m[t]] -= (float)w[t];
    }
    return t;
}

static int loop_while(int n) {
    int t = 5;
    while (t < n) {
        bits[k[t]] ^= (unsigned long)m[t] << (t % 40);
        t++;
    }
    return t;
}

static double last_values(struct grid *s, int n) {
    int t, i = 0;
    double f[3];
    double value = 0;
    for (t = 0; t < n; t++) {
        int c;
        i = k[t];
        value = w[t] * 0.3;
        for (c = 0; c < 3; c++)
            f[c] = value * (c + 1);
        for (c = 0; c < 3; c++)
            s->row[i][c] += f[c];
    }
    return value + i;
}

static void macros(struct grid *s, int n) {
    int t;
    for (t = 0; t < n; t++)
        UPDATE(s->cell, k[t], w[t]);
    for (t = 0; t < n; t++)
        BOTH(t);
    for (t = 0; t < n; t++) { s->part[k[t]].weight += w[t]; } printf("after %d\n", t);
}

static int surroundings(int n, int which) {
    int t = -1;
    if (which == 0) for (t = 0; t < n; t++) h[k[t]] += 0.1; else for (t = 0; t < n; t++) h[m[t]] -= w[t];
    switch (which) {
    case 1: for (t = 0; t < n; t++) { rows[k[t]][1] += w[t]; } break;
    default: t = 0;
    }
    return t;
}

int main(void) {
    int round;
    fill();
    grid.cell = cells;
    grid.row = rows;
    for (round = 0; round < 3; round++) {
        printf("%d\n", plain(SIZE));
        printf("%ld\n", stepping(SIZE - 1, 7));
        printf("%lu\n", (unsigned long)inclusive(SIZE - 1));
        printf("%d\n", loop_while(SIZE));
        printf("%.17g\n", last_values(&grid, SIZE - round));
        printf("%d\n", surroundings(SIZE, 0));
        printf("%d\n", surroundings(SIZE, 1));
        printf("%d\n", surroundings(0, 1));
        macros(&grid, SIZE);
    }
    show("h", h, sizeof h);
    show("rows", rows, sizeof rows);
    show("cells", cells, sizeof cells);
    show("narrow", narrow, sizeof narrow);
    show("bits", bits, sizeof bits);
    show("part", grid.part, sizeof grid.part);
    return 0;
}
