/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Floats in vector code, alone and mixed with doubles, one construct per loop. The data are random,
 * with NaN, infinities, zeros of both signs and subnormal floats. */
#include "data.h"

static float p[NODES][3], small[COUNT], forces[NODES][3], singles[NODES];
static long long big[COUNT];
static const float factor = 1.25f;

typedef const struct element *restrict elements;
typedef const float (*restrict points)[3];

/* ---- arithmetic ---- */

static void lifted_of_floats(int n, elements e, points q, float (*restrict b)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        float d[3];
        for (int c = 0; c < 3; c++)
            d[c] = -q[i][c] + 2 * q[j][c] / 3.0f - (q[i][c] - 0.1f) * factor;
        for (int c = 0; c < 3; c++) {
            b[i][c] += d[c];
            b[j][c] -= d[c] * 0.5f;
        }
    }
}

static void lifted_floats_read(int n, elements e, const float *restrict s, const float weight,
                               const double (*restrict o)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double d = s[t] * 0.1f, both = s[t] * o[i][0], third = weight / 3 + s[t];
        b[i] += d - both * weight;
        b[e[t].node[1]] += third / 0.7f + s[t];
    }
}

/* A double result is rounded to float once; a float computation is rounded at each step. */
static void lifted_roundings(int n, elements e, points q, const double (*restrict o)[3],
                             float *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        const float u = q[i][0], v = q[j][1];
        const float once = u * 0.1 + v, twice = u * 0.1f + v, narrowed = o[i][1];
        const double wide = u * v, wider = (double)u * v, through = (float)o[j][2] - o[j][2];
        b[i] += once - twice * narrowed;
        b[j] += wide - wider + through;
    }
}

static void lifted_compound(int n, elements e, points q, const double (*restrict o)[3],
                            float *restrict a, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        float f = q[i][0], list[3] = {1, o[i][0], q[i][2]}, none[2] = {0.0f},
              half[2] = {0.0f, 0.5f};
        double d = q[i][1];
        f += o[i][1];
        f *= 0.1;
        f -= q[i][2];
        f /= 3;
        d -= f;
        d *= q[i][0];
        none[1] += list[1] - f * half[1];
        for (int c = 0; c < 3; c++)
            list[c] *= d + e[t].kind;
        a[i] += f + list[0] - list[2];
        a[e[t].node[1]] -= none[1] - none[0];
        b[e[t].node[2]] += d + list[1];
    }
}

/* If converted through double, some integers would be rounded twice. */
static void lifted_of_integers(int n, elements e, const long long *restrict many,
                               const float *restrict s, float *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const float rounded = many[t], sum = s[t] + many[t], kind = (float)e[t].kind;
        float product = 1;
        product *= many[t];
        b[i] += rounded * 0x1p-60f + kind;
        b[e[t].node[1]] += sum - product;
    }
}

static void lifted_zeros_and_roots(int n, elements e, points q, const double (*restrict o)[3],
                                   float *restrict a, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const float zero = -0.0f, root = sqrtf(fabsf(q[i][0]) + 1), other = sqrt(q[i][1]);
        const double wide = sqrt(q[i][0]), narrow = sqrtf(o[i][0]) - fabs(q[i][1]);
        a[i] += zero;
        a[e[t].node[1]] += root + other;
        b[e[t].node[2]] += wide - narrow;
    }
}

static void lifted_declared_before(int n, elements e, points q, float (*restrict b)[3]) {
    int t, c;
    float d[3], half;
    for (t = n - 1; t >= 0; t -= 2) {
        half = 0.5f * small[t];
        for (c = 0; c < 3; c++)
            d[c] = half * q[e[t].node[2]][c];
        for (c = 0; c < 3; c++)
            b[e[t].node[2]][c] += d[c];
    }
}

/* ---- conditions ---- */

/* 0.1f is greater than 0.1. */
static void lifted_choices(int n, elements e, points q, const double (*restrict o)[3],
                           const float most, float *restrict a, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        const float v = q[j][1], u = v < 0 ? 0.1f : v, w = u < most ? u : v;
        const double x0 = o[i][0], larger = u > x0 ? u : x0;
        const int above = u > 0.1, not_above = u <= 0.1f, odd = !(v == v) || u >= 1;
        a[i] += above - 2 * not_above + (q[i][0] < most ? w : 3);
        b[j] += odd ? larger : u;
        b[i] += above;
    }
}

static void lifted_kept_choices(int n, elements e, points q, const double (*restrict o)[3],
                                float *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const float u = q[i][1];
        const double d = o[i][2];
        const float f = u < d ? u : -0.5f, g = u == 2 ? u : d, h = i > 100 ? f : g;
        b[i] += f * h;
        b[e[t].node[1]] += g;
    }
}

/* Under some conditions the rows of the other iterations would be far outside. */
static void lifted_below_conditions(int n, elements e, points q, const double (*restrict o)[3],
                                    float *restrict a, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].kind > 2 ? e[t].node[0] : 1 << 29, j = e[t].node[1];
        float f = 1.0f, g[2] = {0}, h;
        double d = q[j][0];
        if (e[t].kind > 2) {
            const float twice = q[i][0] * 2;
            f = twice;
            f += o[j][1];
            g[1] -= twice / f;
            d *= q[i][2];
        }
        if (f > 0.25f)
            h = sqrtf(f);
        else
            h = -g[1];
        if (e[t].kind > 2 && q[i][1] < d)
            d -= h;
        a[j] += f - h;
        b[e[t].node[2]] += g[1] * d;
    }
}

static void lifted_ends(int n, elements e, points q, const float *restrict s, float *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].kind > 2 ? e[t].node[0] : 1 << 29, j = e[t].node[1];
        float d = q[j][0];
        if (e[t].kind <= 2)
            continue;
        d -= q[i][1];
        if (d < 0.0f || s[t] > 1.5)
            continue;
        const float root = sqrtf(d), bound = s[t], least = root < bound ? root : bound;
        b[i] += root;
        if (q[j][2] > 0)
            b[j] -= least * d;
    }
}

/* ---- functions ---- */

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static float narrowed(double wide, float most, int times) {
    float value = wide;
    for (int k = 0; k < times; k++)
        value = value > most ? most : value * 1.1;
    return wide * 0.5 + value;
}

static double widened(float narrow) {
    return narrow * 3;
}

static void matrix(const float (*q)[3], int i, int j, const double *w, float f[3], double df[3][3],
                   float ff[][2]) {
    float n[3];
    for (int c = 0; c < 3; c++)
        n[c] = w[0] * q[i][c] - q[j][c];
    const double length = sqrt(dot(n, n) + 1e-3), other = dot(n, q[i]);
    for (int r = 0; r < 3; r++) {
        f[r] -= n[r] / length;
        for (int c = 0; c < 3; c++)
            df[r][c] += n[r] * n[c] / narrowed(length * other, 3.0, 2);
        ff[r][1] += widened(length);
    }
}

static void lifted_functions(int n, elements e, points q, float (*restrict a)[3],
                             double (*restrict b)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        float f[3] = {0}, ff[3][2] = {{0}};
        double df[3][3] = {{0}};
        matrix(q, i, j, e[t].weight, f, df, ff);
        matrix(q, j, i, &e[t].weight[1], f, df, ff);
        for (int c = 0; c < 3; c++) {
            a[i][c] += f[c] + ff[c][0];
            a[j][c] -= ff[c][1];
        }
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                b[j][c] -= df[r][c];
    }
}

static void scaled(const float (*q)[3], int i, double most, float f[3]) {
    const float length = sqrtf(q[i][0]);
    for (int c = 0; c < 3; c++)
        if (q[i][c] < most)
            f[c] = q[i][c] / length;
}

static void lifted_functions_of_some(int n, elements e, points q, float (*restrict b)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].kind > 2 ? e[t].node[0] : 1 << 29;
        float f[3] = {1.0f, -0.0f, 0.5};
        if (e[t].kind > 2)
            scaled(q, i, 0.75, f);
        scaled(q, e[t].node[1], 0.25, f);
        for (int c = 0; c < 3; c++)
            b[e[t].node[2]][c] += f[c];
    }
}

/* ---- constructs without a vector form ---- */

static void plain_subscript_from_float(int n, elements e, points q, float *restrict b) {
    for (int t = 0; t < n; t++) {
        const float d = small[t] + 1;
        const int c = (int)d & 1;
        b[e[t].node[0]] += q[e[t].node[1]][c];
    }
}

/* ---- data ---- */

static float odd_float(void) {
    static const float odd[] = {NAN, -INFINITY, -0.0f, 1e-45f, -3e-39f, 3e38f, 0.1f};
    const uint64_t r = random_bits();
    return r % 41 == 0 ? odd[r / 41 % 7] : (float)((double)(int64_t)r * 0x1p-62);
}

static void print_floats(const char *name, const float *v, size_t count) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &v[i], sizeof bits);
        bits = v[i] != v[i] ? 1 : bits;
        hash = (hash ^ bits) * 0x100000001b3u;
    }
    printf("%s %016llx\n", name, (unsigned long long)hash);
}

static void begin_floats(float *v, size_t count) {
    for (size_t i = 0; i < count; i++)
        v[i] = -0.0f;
}

static void random_floats(void) {
    for (int i = 0; i < NODES; i++)
        for (int c = 0; c < 3; c++)
            p[i][c] = odd_float();
    for (int t = 0; t < COUNT; t++) {
        small[t] = odd_float();
        big[t] = (1LL << 60) + (1LL << 36) * (long long)(random_bits() % 8) + t % 3 - 1;
    }
}

#define O (const double(*)[3]) x
#define P (const float(*)[3]) p

int main(void) {
    for (int round = 0; round < 3; round++) {
        begin_round();
        random_floats();
#define EACH(call)                                                                                 \
    begin(&force[0][0], sizeof force / sizeof(double));                                            \
    begin(single, NODES);                                                                          \
    begin_floats(&forces[0][0], sizeof forces / sizeof(float));                                    \
    begin_floats(singles, NODES);                                                                  \
    call;                                                                                          \
    print(#call, &force[0][0], sizeof force / sizeof(double));                                     \
    print("single", single, NODES);                                                                \
    print_floats("forces", &forces[0][0], sizeof forces / sizeof(float));                          \
    print_floats("singles", singles, NODES)
        for (int n = COUNT - round * 500; n >= 0; n -= 1201) {
            EACH(lifted_of_floats(n, element, P, forces));
            EACH(lifted_floats_read(n, element, small, 0.7f, O, single));
            EACH(lifted_roundings(n, element, P, O, singles));
            EACH(lifted_compound(n, element, P, O, singles, single));
            EACH(lifted_of_integers(n, element, big, small, singles));
            EACH(lifted_zeros_and_roots(n, element, P, O, singles, single));
            EACH(lifted_declared_before(n, element, P, forces));
            EACH(lifted_choices(n, element, P, O, 0.3f, singles, single));
            EACH(lifted_kept_choices(n, element, P, O, singles));
            EACH(lifted_below_conditions(n, element, P, O, singles, single));
            EACH(lifted_ends(n, element, P, small, singles));
            EACH(lifted_functions(n, element, P, forces, force));
            EACH(lifted_functions_of_some(n, element, P, forces));
            EACH(plain_subscript_from_float(n, element, P, singles));
        }
    }
    return 0;
}
