/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Each construct with a vector form in a separate loop, and constructs without one. The data are
 * random, with NaN, infinities, zeros of both signs and subnormals. */
#include "data.h"

static double scale[COUNT], block[NODES][3][3];
static const double factor = 1.25;
static volatile int far_outside = 1 << 29;

/* ---- arithmetic ---- */

static void lifted_arithmetic(int n, const struct element *restrict e,
                              const double (*restrict p)[3], double (*restrict b)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        double d[3];
        for (int c = 0; c < 3; c++)
            d[c] = -p[i][c] + 2 * p[j][c] / e[t].area - (p[i][c] - 0.1) * factor;
        for (int c = 0; c < 3; c++) {
            b[i][c] += d[c];
            b[j][c] -= d[c] * 0.5;
        }
    }
}

static void lifted_accumulation(int n, const struct element *restrict e,
                                const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        double sum = 0, product = 1.0, list[3] = {1, p[i][0], e[t].kind};
        for (int c = 2; c >= 0; c--) {
            sum += p[i][c];
            product *= p[i][c] + c;
            sum -= list[c];
            product /= 3;
        }
        b[i] += sum;
        b[e[t].node[1]] += product;
    }
}

static void lifted_declared_outside(int n, const struct element *restrict e,
                                    const double (*restrict p)[3], double (*restrict b)[3]) {
    int t, i, c;
    double d[3], half;
    for (t = n - 1; t >= 0; t -= 2) {
        i = e[t].node[2];
        half = 0.5 * e[t].area;
        for (c = 0; c < 3; c++)
            d[c] = half * p[i][c];
        for (c = 0; c < 3; c++)
            b[i][c] += d[c];
    }
}

static void lifted_step_at_start(int n, const struct element *restrict e,
                                 const double (*restrict p)[3], double *restrict b) {
    int t = n;
    while (t > 0) {
        --t;
        b[e[t].node[0]] += p[e[t].node[1]][0] * e[t].area + t;
    }
}

static void lifted_step_at_end(int n, const struct element *restrict e,
                               const double (*restrict p)[3], double *restrict b) {
    int t = 0;
    while (t < n) {
        b[e[t].node[0]] += p[e[t].node[1]][0] * e[t].area - t;
        t++;
    }
}

static void lifted_integers(int n, const struct element *restrict e, const double (*restrict p)[3],
                            double *restrict b) {
    for (int t = 0; t < n; t++) {
        unsigned char low = (unsigned char)(e[t].node[0] * 7);
        int i = e[t].node[1];
        low += 200;
        i ^= 1;
        i %= NODES;
        const double v = low * 0.25 + e[t].kind + p[i][low % 3];
        b[i] += v;
    }
}

static void lifted_zeros(int n, const struct element *restrict e, const double (*restrict p)[3],
                         double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double zero = -0.0;
        double other = p[0][0] > 1e300 ? 1.0 : -0.0;
        other *= 1.0;
        b[e[t].node[0]] += zero;
        b[e[t].node[1]] += other;
    }
}

static void lifted_roots(int n, const struct element *restrict e, const double (*restrict p)[3],
                         double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double r = sqrt(p[i][0]) - fabs(p[i][1]);
        b[i] += r;
    }
}

static void lifted_selection(int n, const struct element *restrict e, const double (*restrict p)[3],
                             double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        const double u = p[i][0], v = p[j][1];
        const double least = u < v ? u : v, most = !(u >= v) || v != v ? v : u;
        const double middle = u > 0.0 && v <= 1 ? u / v : -0.0;
        b[i] += least;
        b[j] += most - middle;
    }
}

static void lifted_comparisons_kept(int n, const struct element *restrict e,
                                    const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double u = p[i][1], v = p[i][2];
        const int less = u < v || !(u == u), both = u > 0.0 && v > 0.5;
        const double inverse = less ? 1 / v : both ? u : -0.0;
        b[i] += inverse + less - 2u * both;
        if (less)
            b[e[t].node[1]] += u;
    }
}

static void lifted_integer_choices(int n, const struct element *restrict e,
                                   const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        const double u = p[i][1], v = p[j][2];
        const double usable = u > v ? 1 : 0, sign = v < 0.0 ? -1 : u < -0.5 ? i : j;
        b[i] += usable * u - sign;
        b[j] += (v > 1 ? 3u : 4000000000u) * v;
    }
}

static void lifted_elements_of_a_lane(int n, const struct element *restrict e,
                                      const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1], role = e[t].kind % 3;
        double g[3], h[2][3], sum = 0;
        for (int c = 0; c < 3; c++) {
            g[c] = p[i][c] * e[t].weight[c];
            h[0][c] = p[j][c];
            h[1][c] = -g[c];
        }
        const double mine = g[role], other = h[role > 1][2 - role];
        if (mine < other)
            sum = h[1][role] + 1;
        b[i] += mine + sum;
        b[j] -= h[role & 1][role] * other;
    }
}

/* ---- control ---- */

static void lifted_uniform_conditions(int n, int flags, const struct element *restrict e,
                                      const double (*restrict p)[3], double (*restrict b)[3][3]) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        double a[3][3] = {{0}};
        for (int r = 0; r < 3; r++)
            for (int c = r; c < 3; c++) {
                if (r == c)
                    a[r][c] = p[i][r];
                else if (flags & 2)
                    a[r][c] -= p[i][r] * p[i][c];
                else
                    a[r][c] = 7;
                a[c][r] += r == c ? 0.5 : a[r][c];
            }
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                b[i][r][c] += a[r][c];
    }
}

static void lifted_condition_around_updates(int n, const struct element *restrict e,
                                            const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        const double d = p[i][0] - p[j][0];
        if (d > 0.25 && e[t].kind > 1) {
            b[i] += d;
            b[j] -= d;
        } else if (d < 0.0)
            b[j] += 2.0;
    }
}

/* ---- statements that only some iterations execute ---- */

/* Under some conditions the rows of the other iterations would be far outside. */

static void lifted_varying_condition(int n, const struct element *restrict e,
                                     const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].kind > 2 ? e[t].node[0] : 1 << 29;
        double d = 1.0, f[2] = {0}, g;
        if (e[t].kind > 2) {
            const double twice = p[i][0] * 2;
            d = twice;
            d += p[i][1];
            f[1] -= twice / d;
        }
        if (d > 0.25)
            g = d;
        else
            g = -f[1];
        b[e[t].node[0]] += d - g;
        b[e[t].node[1]] += f[1];
    }
}

static void lifted_array_of_some(int n, const struct element *restrict e,
                                 const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        double d[2], sum = 0;
        if (p[i][0] > 0.25) {
            d[0] = -p[i][1];
            d[1] = d[0] - 0.5;
            sum = d[0] * d[1];
        }
        b[i] += sum;
    }
}

static void lifted_conditions_within(int n, const struct element *restrict e,
                                     const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        int c, k = 0;
        double d = p[i][0], s = -0.0;
        if (d > 0.0) {
            k = 2;
            if (p[j][1] < d && e[t].kind != 1) {
                for (c = 0; c < 3; c++)
                    s += p[j][c] * d;
                k--;
            } else if (!(e[t].kind == 1)) {
                s = d / p[i][2];
            }
        } else {
            d = -d;
            for (int r = 0; r < 2; r++)
                s -= d * p[i][r];
        }
        b[i] += d * p[j][k];
        b[j] += s;
    }
}

static void lifted_decided_by_the_left(int n, int far, const struct element *restrict e,
                                       const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].kind > 2 ? e[t].node[0] : 1 << 29;
        const double d = e[t].kind, all = 7.0;
        double f = 1.0;
        if (d > 2.0 && p[i][0] > 0.0)
            f = p[i][1];
        if (d <= 2.0 || p[i][0] < d)
            f *= 3.0;
        if (all < d && p[far][1] < d)
            f = 0.0;
        b[e[t].node[1]] += f;
    }
}

static void lifted_exits(int n, const struct element *restrict e, const double (*restrict p)[3],
                         const double *restrict s, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].kind > 2 ? e[t].node[0] : 1 << 29, j = e[t].node[1];
        double d = p[j][0];
        if (e[t].kind <= 2)
            continue;
        d -= p[i][1];
        if (d < 0.0 || s[t] > 1.5) {
            continue;
        }
        const double root = sqrt(d);
        b[i] += root;
        if (p[j][2] > 0.0)
            b[j] -= root * d;
    }
}

static void lifted_last_part(int n, const struct element *restrict e, const double (*restrict p)[3],
                             double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        const double square = p[i][0] * p[i][0] + p[j][1] * p[j][1];
        if (square < 1.0) {
            const double inverse = 1.0 / square, root = sqrt(1.0 - square);
            if (root > 0.999)
                continue;
            b[i] += inverse;
            b[j] -= inverse * root;
        }
    }
}

static void scaled(const double (*p)[3], int i, double most, double f[3]) {
    const double length = sqrt(p[i][0]);
    for (int c = 0; c < 3; c++)
        if (p[i][c] < most)
            f[c] = p[i][c] / length;
}

static void lifted_functions_of_some(int n, const struct element *restrict e,
                                     const double (*restrict p)[3], double (*restrict b)[3]) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].kind > 2 ? e[t].node[0] : 1 << 29;
        double f[3] = {1.0, -0.0, 0.5};
        if (e[t].kind > 2)
            scaled(p, i, 0.75, f);
        scaled(p, e[t].node[1], 0.25, f);
        for (int c = 0; c < 3; c++)
            b[e[t].node[2]][c] += f[c];
    }
}

/* ---- functions ---- */

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double clamped(double value, double most, int times) {
    for (int k = 0; k < times; k++)
        value = value > most ? most : value * 1.5;
    return value;
}

static void matrix(const double (*p)[3], int i, int j, const double *w, double f[3],
                   double df[3][3]) {
    double n[3];
    int place = 0;
    for (int c = 0; c < 3; c++)
        n[c] = w[0] * p[i][c] - w[1] * p[j][c];
    const double length = sqrt(dot(n, n) + 1e-3), other = dot(n, p[i]);
    for (int r = 0; r < 3; r++, place++) {
        f[place] -= n[r] / length;
        for (int c = 0; c < 3; c++)
            df[r][c] += n[r] * n[c] / clamped(length * other, 3.0, 2);
    }
}

static void lifted_functions(int n, const struct element *restrict e, const double (*restrict p)[3],
                             double (*restrict b)[3], double (*restrict a)[3][3]) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        double f[3] = {0}, df[3][3] = {{0}};
        matrix(p, i, j, e[t].weight, f, df);
        matrix(p, j, i, &e[t].weight[1], f, df);
        for (int c = 0; c < 3; c++)
            b[i][c] += f[c];
        const int k = e[t].node[2];
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                a[k][r][c] -= df[r][c];
    }
}

/* The function changes its parameter; the caller's variable keeps its value. */
static double wound(int times, double value) {
    times %= 3;
    times += 1;
    return value * times;
}

static void lifted_changed_parameters(int n, const struct element *restrict e,
                                      const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        int times = e[t].node[1];
        const double v = wound(times, p[e[t].node[0]][0]);
        b[e[t].node[0]] += v + times;
        b[e[t].node[2]] += v - times;
    }
}

static void lifted_read_again_below(int n, const struct element *restrict e,
                                    const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double d = p[i][0], f[2] = {p[i][1], d};
        b[i] += d * f[1];
        const int k = e[t].node[i % 3];
        const double h = d * p[i][2];
        b[k] -= h;
    }
}

/* Calls without a vector form, which are made lane by lane. errno must have the value that the last
 * failing call sets. */
static void lifted_calls_by_lane(int n, const struct element *restrict e,
                                 const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0], j = e[t].node[1];
        const double d = p[i][0] * e[t].area;
        double f = cbrt(d) - floor(p[j][1] * 3);
        if (d > 0.1)
            f += fmax(f, copysign(cbrt(f), -1.0));
        b[i] += f;
        b[j] -= f * d;
    }
}

static void lifted_one_failing_call(int n, const struct element *restrict e,
                                    const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = (double)(t % 5 - 2) * p[e[t].node[0]][0];
        double f = 0.5;
        if (e[t].area < 0.4)
            f = log(d);
        b[e[t].node[1]] += f;
    }
}

/* In iterations that do not make the call, it would fail. */
static void lifted_calls_of_some(int n, const struct element *restrict e,
                                 const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double odd = (double)(t % 2);
        double f = p[e[t].node[0]][1];
        if (odd > 0.5)
            f += log(odd * 3.0);
        b[e[t].node[1]] += f;
    }
}

static void lifted_calls_that_fail_alike(int n, const struct element *restrict e,
                                         const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double *const w = e[t].weight;
        double f = 0.0;
        for (int c = 0; c < 3; c++)
            f += exp(w[c] * p[e[t].node[0]][c]) * cosh((double)(t % 1500) * w[c]);
        b[e[t].node[1]] += f;
    }
}

/* ---- constructs without a vector form ---- */

static void plain_calls_that_fail_in_two_ways(int n, const struct element *restrict e,
                                              const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = p[e[t].node[0]][0];
        b[e[t].node[1]] += sqrt(d - 0.5) + 2.0;
        const double f = log(d - 0.5) * sqrt(p[e[t].node[0]][1]);
        b[e[t].node[2]] += f;
    }
}

/* C converts one operand to the other's type before the result becomes a double: with 3u and -1
 * this matters. */
static void plain_choice_of_two_types(int n, const struct element *restrict e,
                                      const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double u = p[i][0], d = u > 0.0 ? 3L : i;
        b[e[t].node[1]] += d;
    }
}

static void halve(double f[2]) {
    f[0] *= 0.5;
    f[1] *= 0.5;
}

static void plain_handed_on_below(int n, const struct element *restrict e,
                                  const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        double f[2] = {p[i][1], p[i][0]};
        b[i] += f[0];
        halve(f);
        b[e[t].node[1]] -= f[1];
    }
}

static void plain_used_below(int n, const struct element *restrict e, const double (*restrict p)[3],
                             double *restrict b) {
    for (int t = 0; t < n; t++) {
        int i = e[t].node[0];
        double d = p[i][0];
        b[i] += d;
        i = e[t].node[1];
        d = p[i][1];
        b[i] -= d;
    }
}

static void plain_subscript_from_double(int n, const struct element *restrict e,
                                        const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = e[t].area * 2;
        const int c = (int)d & 1;
        b[e[t].node[0]] += p[e[t].node[1]][c];
    }
}

static void plain_effects_in_operands(int n, const struct element *restrict e,
                                      const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        int k = 0;
        double d[2];
        d[0] = p[e[t].node[0]][k++];
        d[1] = p[e[t].node[0]][k++];
        b[e[t].node[1]] += d[0] / d[1] + k;
    }
}

static void plain_effects_in_updates(int n, const struct element *restrict e,
                                     const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        int k = 0;
        const double d[3] = {p[e[t].node[0]][0], 2.0, 3.0};
        b[e[t].node[1]] += d[k++];
        b[e[t].node[2]] += d[k++];
    }
}

static void plain_array_as_pointer(int n, const struct element *restrict e,
                                   const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d[3] = {p[e[t].node[0]][0], 2.0, 3.0};
        b[e[t].node[1]] += *(d + 1) + dot(d, d);
    }
}

static void plain_length_of_loop(int n, const struct element *restrict e,
                                 const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        double sum = 0;
        for (int k = 0; k < e[t].kind; k++)
            sum += p[e[t].node[0]][k % 3];
        b[e[t].node[1]] += sum;
    }
}

static void lifted_comparisons_of_all_types(int n, const struct element *restrict e,
                                            const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double r = p[e[t].node[0]][0];
        const unsigned near = r < 0.5;
        const unsigned long far = r > 1.5;
        const signed char above = r > 0.0;
        const unsigned short same = !(r != 1.0);
        b[e[t].node[1]] += (near - 2) / 3 + 0.5;
        b[e[t].node[2]] += (double)(~far >> 3) - (above - 2) / 3 - ~same;
    }
}

static void plain_counter_set_inside(int n, const struct element *restrict e,
                                     const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        double r = p[e[t].node[0]][0];
        for (int step = 0; step < 9; step++) {
            r = r * 0.5 + 0.25;
            if (r < 0.75)
                step = 9;
        }
        b[e[t].node[1]] += r;
    }
}

static void lifted_counter_set_by_all(int n, int often, const struct element *restrict e,
                                      const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        double r = p[e[t].node[0]][0];
        for (int step = 0; step < 9; step++) {
            r = r * 0.5 + 0.25;
            if (often)
                step += 2;
            if (r < 0.75)
                for (int c = 0; c < 2; c++)
                    r += 0.125;
        }
        b[e[t].node[1]] += r;
    }
}

/* ---- in update statements: each lane separately ---- */

static double weight(double v) {
    return v < 0 ? -v : v * 0.75;
}

static void lifted_computed_between_updates(int n, const struct element *restrict e,
                                            const double (*restrict p)[3],
                                            double (*restrict b)[3][3]) {
    int m;
    double w;
    for (int t = 0; t < n; t++) {
        double d[3][3];
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                d[r][c] = p[e[t].node[r]][c] * (r == c ? 2.0 : e[t].area);
        for (int q = 0; q < 3; q++) {
            m = e[t].node[q];
            w = q == 1 ? 0.5 : p[m][q];
            double(*const row)[3] = b[m];
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    row[r][c] += w * d[r][c];
        }
    }
}

/* Inner loops whose trip counts differ between lanes, with break and continue. Also an array that
 * only the updates use. */
static void lifted_searches_between_updates(int n, const struct element *restrict e,
                                            const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double r = p[e[t].node[0]][0] * 0.5 + e[t].area;
        for (int q = 0; q < 3; q++) {
            int at = e[t].node[q] % 5, steps[2] = {0, 1};
            const int is_close = r < 0.5;
            if (is_close && q == 1)
                continue;
            while (at < NODES - 4) {
                at += 3 + steps[q % 2] % 2;
                steps[0]++;
                if (at % 7 == e[t].kind % 7)
                    break;
            }
            b[at] += weight(r) * (q + is_close);
        }
    }
}

/* Changes made in update statements affect neither the next iteration nor the computations of all
 * lanes. */
static void lifted_changed_beside_updates(int n, const struct element *restrict e,
                                          const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        int k = 0;
        double v = p[e[t].node[0]][1];
        for (int q = 0; q < 3; q++) {
            b[(e[t].node[q] + k) % NODES] += v;
            k += 1 + e[t].kind % 2;
            v *= 0.5;
        }
    }
}

static void plain_changed_beside_and_used_below(int n, const struct element *restrict e,
                                                const double (*restrict p)[3], double *restrict b) {
    for (int t = 0; t < n; t++) {
        int k = 0;
        for (int q = 0; q < 3; q++) {
            b[(e[t].node[q] + k) % NODES] += p[e[t].node[0]][1];
            k += 1 + e[t].kind % 2;
        }
        const double v = p[(e[t].node[1] + k) % NODES][2];
        b[e[t].node[2]] += v;
    }
}

#define P (const double(*)[3]) x

int main(void) {
    for (int round = 0; round < 3; round++) {
        begin_round();
        for (int t = 0; t < COUNT; t++)
            scale[t] = odd_value();
#define EACH(call, array)                                                                          \
    begin(&force[0][0], sizeof force / sizeof(double));                                            \
    begin(&block[0][0][0], sizeof block / sizeof(double));                                         \
    begin(single, NODES);                                                                          \
    call;                                                                                          \
    printf("%m: "); /* prints errno, without reading it in this file */                            \
    print(#call, (const double *)array, sizeof array / sizeof(double))
        for (int n = COUNT - round * 500; n >= 0; n -= 1201) {
            EACH(lifted_arithmetic(n, element, P, force), force);
            EACH(lifted_accumulation(n, element, P, single), single);
            EACH(lifted_declared_outside(n, element, P, force), force);
            EACH(lifted_step_at_start(n, element, P, single), single);
            EACH(lifted_step_at_end(n, element, P, single), single);
            EACH(lifted_integers(n, element, P, single), single);
            EACH(lifted_changed_parameters(n, element, P, single), single);
            EACH(lifted_zeros(n, element, P, single), single);
            EACH(lifted_roots(n, element, P, single), single);
            EACH(lifted_selection(n, element, P, single), single);
            EACH(lifted_comparisons_kept(n, element, P, single), single);
            EACH(lifted_integer_choices(n, element, P, single), single);
            EACH(lifted_elements_of_a_lane(n, element, P, single), single);
            EACH(lifted_uniform_conditions(n, round, element, P, block), block);
            EACH(lifted_condition_around_updates(n, element, P, single), single);
            EACH(lifted_varying_condition(n, element, P, single), single);
            EACH(lifted_array_of_some(n, element, P, single), single);
            EACH(lifted_conditions_within(n, element, P, single), single);
            EACH(lifted_decided_by_the_left(n, far_outside, element, P, single), single);
            EACH(lifted_exits(n, element, P, scale, single), single);
            EACH(lifted_last_part(n, element, P, single), single);
            EACH(lifted_functions_of_some(n, element, P, force), force);
            EACH(lifted_functions(n, element, P, force, block), block);
            print("force", &force[0][0], sizeof force / sizeof(double));
            EACH(lifted_read_again_below(n, element, P, single), single);
            EACH(lifted_calls_by_lane(n, element, P, single), single);
            EACH(lifted_one_failing_call(n, element, P, single), single);
            EACH(lifted_calls_of_some(n, element, P, single), single);
            EACH(lifted_calls_that_fail_alike(n, element, P, single), single);
            EACH(plain_calls_that_fail_in_two_ways(n, element, P, single), single);
            EACH(plain_choice_of_two_types(n, element, P, single), single);
            EACH(plain_handed_on_below(n, element, P, single), single);
            EACH(plain_used_below(n, element, P, single), single);
            EACH(plain_subscript_from_double(n, element, P, single), single);
            EACH(plain_effects_in_operands(n, element, P, single), single);
            EACH(plain_effects_in_updates(n, element, P, single), single);
            EACH(plain_array_as_pointer(n, element, P, single), single);
            EACH(plain_length_of_loop(n, element, P, single), single);
            EACH(lifted_comparisons_of_all_types(n, element, P, single), single);
            EACH(plain_counter_set_inside(n, element, P, single), single);
            EACH(lifted_computed_between_updates(n, element, P, block), block);
            EACH(lifted_searches_between_updates(n, element, P, single), single);
            EACH(lifted_changed_beside_updates(n, element, P, single), single);
            EACH(plain_changed_beside_and_used_below(n, element, P, single), single);
            EACH(lifted_counter_set_by_all(n, round, element, P, single), single);
        }
    }
    return 0;
}
