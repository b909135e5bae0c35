/* REDCC: --require */
/* Unusual source text: the ends of statements, the else of nested ifs, types of counters and keys,
 * and values that are used after the loop. */
#include <stdio.h>

enum { SIZE = 12000, CELLS = 500 };

#define PLUS(target, value) target += (value);
#define LAST(x) x

struct point {
    double x, y;
};
struct system {
    double (*cell)[2];
    struct point origin;
    int *map;
};

static int k[SIZE], map[CELLS];
static double w[SIZE], h[CELLS], g[CELLS], cells[CELLS][2];
static _Complex double z[CELLS];
static long double wide[CELLS];
static double scale = 0.75;

static void show(const char *name, const void *data, unsigned long bytes) {
    const unsigned char *byte = data;
    unsigned long sum = 5381, i;
    for (i = 0; i < bytes; i++)
        sum = sum * 33 + byte[i];
    printf("%s %lu\n", name, sum);
}

static void fill(void) {
    unsigned long state = 11;
    int i;
    for (i = 0; i < SIZE; i++) {
        state = state * 6364136223846793005UL + 1442695040888963407UL;
        k[i] = (int)((state >> 33) % CELLS);
        w[i] = (double)(state >> 11) / 9007199254740992.0;
    }
    for (i = 0; i < CELLS; i++)
        map[i] = (i * 7) % CELLS;
}

static void ends(int n) {
    for (int t = 0; t < n; t++) h[k[t]] += w[t] /* before; the */ ; /* semicolon; */
    for (int t = 0; t < n; t++)
        PLUS(h[k[t]], w[t])
    for (int t = 0; t < n; t++) {
        g[LAST(k[t])] += LAST(w[t] * 0.5) // a comment; with a semicolon
            ;
        if (w[t] > 0.3) PLUS(g[k[t]], 0.1) else PLUS(g[k[t]], 0.2)
    }
}

static void pairing(int n) {
    for (int t = 0; t < n; t++)
        if (w[t] > 0.2)
            if (w[t] > 0.5)
                h[k[t]] += 0.1;
            else
                h[k[t]] -= w[t];
        else if (w[t] < 0.1)
            g[k[t]] += 0.3;
        else
            for (int c = 0; c < 2; c++)
                if (c)
                    g[k[t]] -= 0.4;
                else
                    h[k[t]] += 0.7;
}

static void inner(struct system *s, int n) {
    for (int t = 0; t < n; t++) {
        int c = 0;
        do
            s->
                cell[k[t]][c] += w[t];
        while (++c < 2);
        for (c = 0; c < 4; c++) {
            if (c == 1)
                continue;
            if (c == 3)
                break;
            s->cell[s->map[k[t]]][c & 1] -= w[t] * c;
        }
        switch (k[t] % 3) {
        case 0:
            s->cell[k[t]][0] += s->origin.x;
            break;
        case 1: s->cell[k[t]][1] += 0.25; /* fall through */
        default:
            break;
        }
    }
}

static unsigned char narrow_counter(void) {
    unsigned char t;
    for (t = 3; t != 250; t++)
        h[k[t]] += w[t];
    return t;
}

static long long long_counter(long long from, short to) {
    long long t;
    for (t = from; t >= to; --t)
        g[k[t]] += w[t] * scale;
    return t;
}

static int float_key(float shift, struct point p, int n) {
    int t;
    for (t = 0; t < n; t += 2) {
        int i = k[t] + (int)shift;
        h[i < CELLS ? i : 0] += p.x * w[t] + p.y;
    }
    return t;
}

static void types(int n) {
    for (int t = 0; t < n; t++) {
        z[k[t]] += w[t];
        wide[k[t]] -= (long double)w[t] / 3;
    }
}

static double variable_rows(int n, int rows, int m, double a[rows][m]) {
    int t, i = 0;
    double last = 0, f[2], kept[2];
    for (t = 0; t < n; t++) {
        double local[m];
        i = k[t];
        last = w[t];
        f[0] = last * 0.5;
        f[1] = last - 1;
        kept[0] = f[1];
        kept[1] = f[0];
        for (int c = 0; c < m; c++)
            local[c] = f[c & 1];
        for (int c = 0; c < m; c++)
            a[i][c] += local[c];
    }
    return i + last + kept[0] + kept[1];
}

int main(void) {
    static double area[CELLS * 3];
    struct system s = {cells, {0.1, 0.2}, map};
    struct point p = {0.3, 0.4};
    int round;
    fill();
    for (round = 0; round < 3; round++) {
        scale += 0.1;
        ends(SIZE);
        pairing(SIZE - round);
        inner(&s, SIZE);
        printf("%d\n", narrow_counter());
        printf("%lld\n", long_counter(SIZE - 1, (short)round));
        printf("%d\n", float_key((float)round * 1.25f, p, SIZE));
        types(SIZE);
        printf("%.17g\n", variable_rows(SIZE, CELLS, 3, (double(*)[3])area));
    }
    show("h", h, sizeof h);
    show("g", g, sizeof g);
    show("cells", cells, sizeof cells);
    show("area", area, sizeof area);
    show("z", z, sizeof z);
    for (round = 0; round < CELLS; round++)
        printf("%La\n", wide[round]);
    return 0;
}
