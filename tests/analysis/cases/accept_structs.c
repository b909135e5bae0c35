/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Covers rows 17, 45, 46, 48 and 59 of docs/constructs.md. */
#include <math.h>

struct vec {
    double x, y, z;
};
struct particle {
    struct vec force;
    double mass;
    int kind;
};
struct matrix {
    int n;
    const int *start, *column;
    double (*value)[3][3];
};
struct system {
    int n;
    double (*b)[3];
    struct matrix A;
    double fixed[20][3];
};

static void spring(const double (*x)[3], int i, int j, double *f) {
    double d[3], l2 = 0;
    for (int c = 0; c < 3; c++) {
        d[c] = x[j][c] - x[i][c];
        l2 += d[c] * d[c];
    }
    double l = sqrt(l2);
    for (int c = 0; c < 3; c++)
        f[c] = (l - 1.0) * d[c] / l;
}

void springs(int n, const int (*edge)[2], const double (*x)[3], struct system *s) {
    int t, i, j;
    double f[3];
    for (t = 0; t < n; t++) { // EXPECT: transform s->b(+) guards=2 verifiable privates=3
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            s->b[i][c] += f[c];
            s->b[j][c] -= f[c];
        }
    }
}

static int find_block(const struct matrix *A, int i, int j) {
    int low = A->start[i], high = A->start[i + 1] - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (A->column[middle] < j)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void blocks(int n, int (*tri)[3], struct matrix *A) {
    for (int t = 0; t < n; t++) // EXPECT: transform A->value(+) not-verifiable
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) {
                int k = find_block(A, tri[t][a], tri[t][b]);
                for (int r = 0; r < 3; r++)
                    for (int c = 0; c < 3; c++)
                        A->value[k][r][c] += 1.0;
            }
}

void table(int n, int (*block)[3][3], struct system *sys, double (*df)[3][3]) {
    for (int t = 0; t < n; t++) // EXPECT: transform sys->A.value(+) verifiable guards=1
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                for (int r = 0; r < 3; r++)
                    for (int c = 0; c < 3; c++)
                        sys->A.value[block[t][a][b]][r][c] += df[t][r][c];
}

void particles(int n, const int (*pair)[2], struct particle *p) {
    for (int t = 0; t < n; t++) { // EXPECT: transform p(+) interleaved=p
        int i = pair[t][0], j = pair[t][1];
        double m = p[i].mass * p[j].mass;
        p[i].force.x += m;
        p[j].force.x -= m;
        p[j].force.y -= m;
    }
}

void member_array(int n, const int *s, struct system *sys) {
    for (int t = 0; t < n; t++) // EXPECT: transform sys->fixed(+)
        sys->fixed[s[t]][1] += 1.0;
}

struct vec cross(struct vec a, struct vec b) {
    struct vec r = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return r;
}

void struct_private(int n, const int *s, const struct vec *restrict x, struct vec *restrict h) {
    struct vec f;
    for (int t = 0; t < n; t++) { // EXPECT: transform h(+) guards=0
        f = cross(x[t], x[s[t]]);
        h[s[t]].x += f.x;
        h[s[t]].y += f.y;
        h[s[t]].z += f.z;
    }
}

void cutoff(int n, const int (*pair)[2], const double (*x)[3], double (*f)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transform f(+) verifiable
        int i = pair[t][0], j = pair[t][1];
        double d = x[i][0] - x[j][0];
        if (d * d > 4.0)
            continue;
        if (d * d < 2.0) {
            f[i][0] += d;
            f[j][0] -= d;
        }
    }
}

void vla(int n, int m, const int *s, double a[n][m]) {
    for (int t = 0; t < n; t++) // EXPECT: transform a(+)
        for (int c = 0; c < m; c++)
            a[s[t]][c] += 1.0;
}

struct element {
    double area;
};
struct effect {
    int count;
    const int (*vertex)[3];
    const struct element *element;
};

static double area_of(const struct element *e) {
    return e->area;
}

void address_of_element(struct effect *e, double *restrict h) {
    for (int t = 0; t < e->count; t++) // EXPECT: transform h(+) verifiable
        h[e->vertex[t][0]] += area_of(&e->element[t]);
}
