// One record updates several adjacent elements of an array: members of structures, components of arrays, or
// both nested. Also: rows among other data, the order of updates of rows that may be equal, rows too large
// for a record, rows of two sizes, and rows of which only one element is updated.
// INTEGERS: no
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "case.h"

enum { N = 3000, M = 150 };
static int i1[N], i2[N];
static double w[N], u[N], v[N];
static float part[N];

static struct vector {
    double x, y, z;
} force[M], torque[M];
static struct particle {
    char kind;
    double place[3];
    struct vector force;
    int hits;
    double mass;
} particle[M];
static double rows[M + 4][3], grid[M / 10][10][2], flat[2 * M], block[M][3][3];
static float pairs[M][2];
static int counts[M][2], mixed[M][3];
static struct both {
    long first, second;
} both[M];
static struct wide {
    double many[12];
} wide[M];
static struct huge {
    double at[200];
} huge[M];
static struct __attribute__((packed)) off {
    double x, y;
    char tag;
} off[M];

static void structures(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = i1[t], j = i2[t];
        const double a = w[t] * u[t], b = w[t] + u[t], c = w[t] - u[t];
        force[i].x += a;
        force[i].y += b;
        force[i].z += c;
        force[j].x -= a;
        force[j].y -= b;
        force[j].z -= c;
    }
} // WIDE: 45

static void components(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        rows[i1[t]][0] += w[t];
        rows[i1[t]][1] = rows[i1[t]][1] * 0.5 + u[t];
        rows[i1[t]][2] -= 1;
        rows[i2[t] + 1][2] *= 0.75;
    }
} // WIDE: 58

// No update may be moved past an update of the same element through another subscript.
static void in_turns(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        force[i1[t]].x += w[t];
        force[i2[t]].y *= 0.5;
        force[i1[t]].y += u[t];
        force[i2[t]].x *= 0.75;
        force[i1[t]].x -= v[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        force[i1[t]].x += w[t];
        force[i1[t]].y += w[t];
        torque[i2[t]].x = torque[i2[t]].x * 0.5 + 1;
        force[i2[t]].x *= 0.5;
        force[i1[t]].z += u[t];
        torque[i2[t]].y = torque[i2[t]].y * 0.25 + 1;
    }
} // WIDE: 68 75

static void twice(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        force[i1[t]].x += w[t];
        force[i1[t]].x *= 0.5;
        force[i1[t]].y += u[t];
        force[i1[t]].x -= u[t];
    }
} // WIDE: 86

static void together(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        force[i1[t]].x += w[t];
        torque[i1[t]].x -= u[t];
        force[i1[t]].z += u[t];
        torque[i1[t]].z += w[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        flat[i1[t]] += w[t];
        force[i1[t]].x -= u[t];
        force[i1[t]].y -= u[t];
    }
} // WIDE: 95 101

static void among_others(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        particle[i1[t]].force.x += w[t];
        particle[i1[t]].force.z += u[t];
        particle[i1[t]].place[1] -= w[t];
        particle[i2[t]].mass += u[t];
    }
} // WIDE: 109

static void of_two_kinds(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        particle[i1[t]].force.x += w[t];
        particle[i1[t]].force.y += u[t];
        particle[i1[t]].hits++;
    }
} // NOT-BINNED: 118

static void in_a_grid(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        grid[i1[t] / 10][i2[t] % 10][0] += w[t];
        grid[i1[t] / 10][i2[t] % 10][1] += u[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        block[i1[t]][0][0] += w[t];
        block[i1[t]][1][1] += w[t];
        block[i1[t]][2][1] -= u[t];
        block[i2[t]][2][2] -= v[t];
    }
} // WIDE: 126 130

static void integers(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        counts[i1[t]][0]++;
        counts[i1[t]][1] += t;
        counts[i2[t]][1] += i1[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        both[i1[t]].second ^= t;
        both[i1[t]].first ^= i2[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        mixed[i1[t]][2]++;
        mixed[i1[t]][0]++;
    }
} // WIDE: 139 144 148

static void under_conditions(int n, const int *restrict k, const double *restrict x,
                             double (*restrict to)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (i2[t] % 3) {
            pairs[i1[t]][0] += part[t];
            pairs[i1[t]][1] -= part[t];
        } else
            pairs[i2[t]][1] += 2;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (x[t] > to[k[t]][1])
            to[k[t]][1] = x[t];
        if (x[t] < to[k[t]][0])
            to[k[t]][0] = x[t];
        to[k[t]][2] += x[t];
    }
} // WIDE: 156 163

static void by_pointer(int n, struct vector *restrict at, double (*restrict middle)[3], const int *restrict k) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        at[k[t] - 70].x += w[t];
        at[k[t] - 70].y += u[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        middle[k[t] - 70][2] += w[t];
        middle[k[t] - 70][1] += u[t];
    }
} // WIDE: 173 177

static void that_overlap(int n, struct vector *a, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        a[i1[t]].x += w[t];
        a[i1[t]].y = a[i1[t]].y * 0.5 + u[t];
        b[i1[t]] = b[i1[t]] * 0.5 + v[t];
    }
} // WIDE: 184

#define ADD(to, a)                                                                                 \
    do {                                                                                           \
        (to).x += a;                                                                               \
        (to).y -= a;                                                                               \
    } while (0)
static void by_macro(int n, struct vector *restrict to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        ADD(to[i1[t]], w[t] * 2);
        ADD(to[i2[t]], u[t]);
    }
} // WIDE: 197

// These loops get records of single elements. They have rows of two sizes, one updated element per row,
// rows whose size is no multiple of the element's, or more values than a record holds.
static void no_rows(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        grid[i1[t] / 10][i2[t] % 10][0] += w[t];
        grid[i1[t] / 10][3][1] += u[t];
        grid[i1[t] / 10][3][0] += u[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        force[i1[t]].x += w[t];
        force[i2[t]].z += w[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        wide[i1[t]].many[0] += w[t];
        wide[i1[t]].many[1] += u[t];
        wide[i1[t]].many[2] += v[t];
        wide[i1[t]].many[5] += v[t] - 1;
        wide[i1[t]].many[7] += w[t] + 1;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        huge[i1[t]].at[0] += w[t];
        huge[i1[t]].at[199] += u[t];
    }
} // ELEMENTS: 206 211 215 222

static void out_of_step(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        off[i1[t]].x += w[t];
        off[i1[t]].y += u[t];
    }
} // NOT-BINNED: 229

// More updates of one row than a record can hold.
static void many(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        wide[i1[t]].many[0] += 1;
        wide[i1[t]].many[1] += 2;
        wide[i1[t]].many[2] -= 3;
        wide[i1[t]].many[3] += w[t];
        wide[i1[t]].many[4] *= 0.5;
        wide[i1[t]].many[5] += 5;
        wide[i1[t]].many[6] += 6;
        wide[i1[t]].many[7] += w[t];
        wide[i1[t]].many[8] += 7;
        wide[i1[t]].many[9] -= w[t];
        wide[i1[t]].many[0] *= 0.75;
    }
} // WIDE: 237

static void show_all(void) {
#define SHOW(array) case_print(#array, array, sizeof array)
    SHOW(force), SHOW(torque), SHOW(rows), SHOW(grid), SHOW(flat), SHOW(block), SHOW(pairs);
    SHOW(counts), SHOW(mixed), SHOW(both), SHOW(wide), SHOW(huge), SHOW(off);
    for (int i = 0; i < M; i++) {
        const struct particle *p = &particle[i];
        printf("%a %a %a %a %a %d\n", p->place[1], p->force.x, p->force.y, p->force.z, p->mass,
               p->hits);
    }
}

int main(void) {
    static double space[3 * M + 3];
    case_subscripts(i1, N, M);
    case_subscripts(i2, N, M);
    case_values(w, N);
    case_values(u, N);
    case_values(v, N);
    for (int t = 0; t < N; t++)
        part[t] = (float)case_value();
    for (int i = 0; i < M; i++)
        force[i].x = torque[i].y = particle[i].force.z = rows[i][1] = -0.0;
    w[5] = INFINITY, u[7] = -INFINITY, w[8] = -0.0, w[9] = 1.7e308, u[10] = 5e-324;
    for (int round = 0; round < 2; round++) {
        structures(N);
        components(N);
        in_turns(N);
        twice(N);
        together(N);
        among_others(N);
        of_two_kinds(N);
        in_a_grid(N);
        integers(N);
        under_conditions(N, i1, w, rows);
        by_pointer(N, force + 70, rows + 70, i1);
        that_overlap(N, (struct vector *)(void *)space, space);
        that_overlap(N / 2, (struct vector *)(void *)space, space + 3 * M / 2);
        that_overlap(N, force, flat);
        by_macro(N, torque);
        no_rows(N);
        out_of_step(N);
        many(N);
        show_all();
        case_print("space", space, sizeof space);
        memset(space, 0, sizeof space);
        memset(force, 0, sizeof force);
    }
}
