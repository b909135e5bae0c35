// Iterations of inner loops. In the owner-checked form a thread skips those in which it owns no row, if the
// rest of the iteration consists of updates and their operands. INNER marks each expected ownership check.
// INTEGERS: no
#include <math.h>
#include <stdio.h>

#include "case.h"

enum { N = 600, M = 200, MOST = 12 };
static int point[N + 1], list[N * MOST], own[N], near[N][MOST], kind[N * MOST];
static unsigned char small[N * MOST];
static double r[M][3], w[N * MOST], reach;

static double f[M + 8][3], g[M], s[M + 8], o[N];
static int counts[M];
static struct atom {
    double mass;
    double force[3];
    float charge;
} atom[M + 8];

static double image(double d) {
    return d > 0.5 ? d - 1 : d < -0.5 ? d + 1 : d;
}

static void apart(const double *a, const double *b, double *d) {
    for (int c = 0; c < 3; c++)
        d[c] = image(a[c] - b[c]);
}

static void half_list(int n) {
    int i, j, k, a;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        a = own[i];
        for (k = point[i]; k < point[i + 1]; k++) {
            j = list[k];
            const double dx = image(r[a][0] - r[j][0]); // INNER
            const double dy = image(r[a][1] - r[j][1]), dz = image(r[a][2] - r[j][2]);
            const double r2 = dx * dx + dy * dy + dz * dz;
            if (r2 < reach) {
                const double e = 1.0 / (r2 + 0.25);
                f[a][0] += e * dx;
                f[a][1] += e * dy;
                f[j][0] -= e * dx;
                f[j][1] -= e * dy;
                f[j][2] -= e * dz;
            }
        }
    }
}

/* Variables of the function. In some loops each inner iteration sets them before use. In others the next inner
 * iteration or code after the loop reads them, or an inner iteration reads one without setting it. */
static void names_of_the_function(int n) {
    int i, j, k, a, c;
    double dx, r2, e;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        a = own[i];
        for (k = point[i]; k < point[i + 1]; k++) {
            j = list[k];
            dx = image(r[a][0] - r[j][0]); // INNER
            r2 = dx * dx;
            for (c = 1, e = 0.25; c < 3; c++) {
                r2 += r[a][c] * r[j][c];
                e += 0.125 * r2;
            }
            if (r2 < reach)
                continue;
            e = 1 / (r2 * r2 + e * e + 0.5);
            f[a][0] += e * dx;
            f[j][0] -= e * dx;
        }
    }
}

static void used_by_the_turn_after(int n) {
    int i, j, k, a;
    double dx, e;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        a = own[i];
        e = 0.5;
        for (k = point[i]; k < point[i + 1]; k++) {
            j = list[k];
            dx = image(r[a][0] - r[j][0]) * 0.5 - e * 0.25 + r[a][1] * r[j][1];
            f[a][1] += dx;
            f[j][1] -= dx;
            e = dx * 0.5 + 0.125;
        }
    }
}

static void used_behind_the_loop(int n) {
    int i, j, k, a;
    double dx;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        a = own[i];
        dx = 0.25;
        for (k = point[i]; k < point[i + 1]; k++) {
            j = list[k];
            dx = image(r[a][0] - r[j][0]) * 0.5 + r[a][1] * r[j][1] + r[a][2] * 0.125;
            f[a][2] += dx;
            f[j][2] -= dx;
        }
        g[a] += dx;
    }
}

static void set_in_some_turns(int n) {
    int i, j, k, a;
    double r2;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        a = own[i];
        r2 = 0.75;
        for (k = point[i]; k < point[i + 1]; k++) {
            j = list[k];
            if (j & 1)
                r2 = image(r[a][0] - r[j][0]) * 0.5 + r[a][1] * r[j][1] + r[a][2] * 0.125;
            f[a][2] += r2;
            f[j][2] -= r2;
        }
    }
}

static void half_list_named(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            double d[3]; // INNER
            apart(r[a], r[j], d);
            const double e = 1 / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 0.5);
            for (int c = 0; c < 3; c++) {
                f[a][c] += e * d[c];
                f[j + 1][c] -= e * d[c];
            }
        }
    }
}

// A turn's loops may end early, and the turn itself may be cut short by `continue`.
static void of_several_arrays(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int k = 0, j, b;
        do {
            j = list[i * MOST + k];
            b = 3 * small[i * MOST + k] % M;
            double e = 0; // INNER
            for (int c = 0; c < 3; c++) {
                if (e > 2)
                    break;
                e += r[j][c] * r[b][c] * w[k];
            }
            if (e < -1.5)
                continue;
            e = e * e + 0.5 * e * e;
            atom[j].force[1] += e;
            atom[b].charge += (float)e;
            s[j + b >= M ? 0 : j + b] += e;
        } while (++k < MOST);
    }
}

// At the check `j` may be out of bounds, since the condition follows it: the check must not read the element.
static void under_condition(int n, int last) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = point[i]; k < point[i + 1]; k++) {
            int j = list[k];
            if (kind[k] % 3 == 0)
                j = -1000000 * kind[k];
            const double e = image(w[k] * r[a][0]) * w[k] + w[k] * r[a][1]; // INNER
            if (j >= 0 && j < last) {
                s[j] += e;
                s[a] *= e;
            }
        }
    }
}

// In a nest the inner loop has the check if only this loop determines a row.
static void of_cells(int n, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int c = 0; c < 3; c++)
            for (int k = point[i]; k < point[i + 1]; k++) {
                const int j = list[k];
                const double e = w[k] * w[k] - r[j][c] * w[k] + r[a][c] * w[k] * 0.25; // INNER
                t[a] += e;
                t[j] -= e;
            }
    }
}

// A stored value is read again later in the same inner iteration.
static void of_stored_values(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25; // INNER
            o[j] = e;
            g[a] += o[j] * e;
        }
    }
}

// The sum of the inner iterations goes to a row that is known before them.
static void of_sums(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        double sum = 0, force[3] = {0.5, 0, 0};
        for (int k = point[i]; k < point[i + 1]; k++) {
            const int j = list[k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25; // INNER
            s[j] -= e;
            sum += e;
            for (int c = 0; c < 3; c++)
                force[c] -= e * r[j][c];
        }
        sum *= 0.5;
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25; // INNER
            g[j] += e;
            sum -= e;
        }
        s[a] += sum;
        for (int c = 0; c < 3; c++)
            f[a][c] += force[c];
    }
}

// ---- no check

static void with_sums_between(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        double sum = 0;
        for (int k = point[i]; k < point[i + 1]; k++) {
            const int j = list[k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
            sum += e;
            s[j] -= sum;
        }
    }
}

static void with_sums_of_rows(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double sum = 0;
        for (int m = 0; m < 2; m++) {
            const int a = near[i][m];
            s[a] += sum;
            for (int k = point[i]; k < point[i + 1]; k++) {
                const int j = list[k];
                const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
                s[j] -= e;
                sum += e;
            }
        }
    }
}

static void with_sums_that_decide(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        double sum = 0, twice;
        for (int k = point[i]; k < point[i + 1]; k++) {
            const int j = list[k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
            s[j] -= e;
            sum += e;
        }
        twice = 2 * sum;
        if (twice > 1)
            g[near[i][0]] += 0.5;
        s[a] += sum;
    }
}

static void with_stored_sums(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        double sum = 0;
        for (int k = point[i]; k < point[i + 1]; k++) {
            const int j = list[k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
            s[j] -= e;
            sum += e;
        }
        o[a] = sum;
        g[near[i][0]] += o[a];
    }
}

static void with_another_row(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int a = own[i];
        double sum = 0;
        for (int k = point[i]; k < point[i + 1]; k++) {
            const int j = list[k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[j][0] * w[k] * 0.25;
            s[j] -= e;
            sum += e;
        }
        a = (a + 1) % M;
        s[a] += sum;
    }
}

__attribute__((aligned(32))) static void in_place(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = point[i]; k < point[i + 1]; k++) {
            const int j = list[k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25; // INNER
            s[j] -= e;
            s[a] += e;
        }
    }
}

static void with_end(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = point[i]; k < point[i + 1]; k++) {
            const int j = list[k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
            if (e > 1.5)
                break;
            s[a] += e;
            s[j] -= e;
        }
    }
}

static void with_memory(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        double before = 1, d[3] = {0, 0, 0};
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            const double e = w[k] * before - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
            s[a] += e;
            s[j] -= e;
            before = r[j][1];
        }
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            const double e = d[0] * d[1] - d[2] * w[k] + r[a][0] * w[k] * 0.25;
            s[a] += e;
            s[j] -= e;
            apart(r[j], r[a], d);
        }
    }
}

static void with_late_rows(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = 0; k < MOST; k++) {
            int j = near[i][k];
            const double e = w[k] * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
            s[j] -= e;
            j = (j + 7) % M;
            s[j] += e;
        }
    }
}

static void with_rows_in_memory(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int k = 0; k < MOST; k++) {
            const double e = w[k] * w[k] - r[near[i][k]][0] * w[k] + r[own[i]][0] * w[k] * 0.25;
            s[near[i][k]] -= e;
            s[own[i]] += e;
        }
}

static void with_little_work(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            const double e = w[k] * w[k];
            g[a] += e;
            g[j] -= e;
            counts[j] += kind[k];
        }
    }
}

/* The pointer is only read through. Only the thread that leads an iteration executes calls that may set errno. */
static void pull(struct atom *from, int j, double *e) {
    const double *force = from[j].force;
    *e = sqrt(from[j].mass * from[j].mass) * 0.5 + from[j].charge * force[1];
}
static void by_reading(int n, struct atom *from) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            double e; // INNER
            pull(from, j, &e);
            e += w[k] * w[k] - r[j][0] * w[k];
            s[a] += e;
            s[j] -= e;
        }
    }
}

/* A turn stores a value that the next turn reads. */
struct hold { double last; };
static double exchange(struct hold *h, double v) {
    struct hold *const it = h;
    const double before = it->last;
    it->last = v;
    return before;
}
static void by_exchanging(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int a = own[i];
        struct hold h = {1};
        for (int k = 0; k < MOST; k++) {
            const int j = near[i][k];
            const double e = exchange(&h, w[k]) * w[k] - r[j][0] * w[k] + r[a][0] * w[k] * 0.25;
            s[a] += e;
            s[j] -= e;
        }
    }
}

int main(void) {
    static double t[M];
    case_subscripts(own, N, M);
    case_subscripts(list, N * MOST, M);
    case_subscripts(near[0], N * MOST, M);
    case_subscripts(kind, N * MOST, 100);
    case_values(&r[0][0], 3 * M);
    case_values(w, N * MOST);
    for (int i = 0; i < N * MOST; i++)
        small[i] = (unsigned char)case_below(256);
    for (int i = 0; i < N; i++)
        point[i + 1] = point[i] + case_below(MOST + 1);
    for (int i = 0; i < M; i++)
        s[i] = g[i] = t[i] = i % 3 ? case_value() : -0.0;
    reach = 0.7, w[5] = 1e10, w[9] = -0.0, w[11] = 5e-324;
    for (int round = 0; round < 2; round++) {
        half_list(N);
        names_of_the_function(N);
        used_by_the_turn_after(N);
        used_behind_the_loop(N);
        set_in_some_turns(N);
        half_list_named(N);
        of_several_arrays(N);
        under_condition(N, M / 2);
        of_cells(N, t);
        of_stored_values(N);
        of_sums(N);
        with_sums_between(N);
        with_sums_of_rows(N);
        with_sums_that_decide(N);
        with_stored_sums(N);
        with_another_row(N);
        in_place(N);
        with_end(N);
        with_memory(N);
        with_late_rows(N);
        with_rows_in_memory(N);
        with_little_work(N);
        by_reading(N, atom);
        by_exchanging(N);
        CASE_PRINT(f), CASE_PRINT(g), CASE_PRINT(s), CASE_PRINT(o), CASE_PRINT(t);
        CASE_PRINT(counts);
        CASE_PRINT(atom);
    }
}
