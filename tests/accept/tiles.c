// Loops over pairs, cut into tiles: row and column counters with j > i or j < i, in several spellings. NOT-TILED lists
// similar loops in which two inner iterations may conflict although neither their rows nor their columns are equal.
// THREADS: 3 33
// INTEGERS: no
// CFLAGS: -Wno-unknown-pragmas
// MAY-RUN-SERIALLY: arrays overlap, or there are few iterations
#include <math.h>

#include "case.h"

#define COLUMNS n
enum { N = 210, ROOM = 12 * N };
typedef struct {
    double x, y, z;
} vector;
typedef struct {
    vector at, speed, force;
} point;
static point points[N];
static double memory[ROOM], energy, virial;
static long pairs;

#define SUB(a, b, c) (a).x = (b).x - (c).x, (a).y = (b).y - (c).y, (a).z = (b).z - (c).z
#define ADD(a, s, b) (a).x = (a).x + (s) * (b).x, (a).y = (a).y + (s) * (b).y, (a).z = (a).z + (s) * (b).z

static void records(int n, double cut) {
    vector d;
    double rr, f;
    int i, j;
    for (i = 0; i < n - 1; i++) { // EXPECT: transformed
        for (j = i + 1; j < n; j++) {
            SUB(d, points[i].at, points[j].at);
            rr = d.x * d.x + d.y * d.y + d.z * d.z;
            if (rr < cut) {
                f = 1 / (rr + 0.1) - 0.3;
                ADD(points[i].force, f, d);
                ADD(points[j].force, -f, d);
                energy += f * rr;
                virial += 4 * f + 1.;
                pairs++;
            }
        }
    }
} // TILED: 30

static void below(long n, const float *x, float *f, float cut) {
    for (long i = 1; i < n; i++) { // EXPECT: transformed
        const float mine = x[i];
        for (long j = 0; j <= i; j++) {
            const float d = mine - x[j];
            if (d * d > cut)
                continue;
            f[i] -= d;
            f[j] += sqrtf(d * d) + 0.5f;
        }
    }
} // TILED: 47

static void packed(unsigned n, const double (*x)[3], double (*f)[3], double *left, double *right) {
    for (unsigned i = 3; i < n; ++i) { // EXPECT: transformed
        for (unsigned j = i; n > j; ++j) {
            double s = 0;
            for (int c = 0; c < 3; c++)
                s += (x[i][c] - x[j][c]) * 0.5;
            for (int c = 0; c < 3; c++)
                f[i][c] = f[i][c] * 0.75 + s;
            for (int c = 0; c < 3; c++)
                f[j][c] -= s;
            left[i] += s;
            right[j] = s - right[j];
        }
    }
} // TILED: 60

/* Both subscripts are shifted; rows end before the columns do, and some rows are empty. */
static void shifted(int first, int n, int most, const double *x, double *f, double sum[2]) {
    for (int i = first; i < n; i++) // EXPECT: transformed
        for (int j = i + 2; j <= most - (i & 3); j++) {
            const double e = x[i - first] * x[j - first];
            sum[1] += e;
            if (e > 0)
                sum[0] -= e;
            f[i + 4] += e;
            f[j + 4] *= 1 - e;
        }
} // TILED: 77

/* Variables, arrays and records hold the row's sums; a row begins and ends with updates outside the inner loop. */
static void summed_by_rows(int n, const double *x, double *f) {
    double sum[3], d[3], rr, e;
    int i, j, k;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        e = 0;
        for (k = 0; k < 3; k++)
            sum[k] = x[i] * 0.5;
        for (j = i + 1; j < n; j++) {
            rr = 0.25;
            for (k = 0; k < 3; k++) {
                d[k] = x[3 * i + k] - x[3 * j + k];
                rr += d[k] * d[k];
            }
            if (rr > 2)
                continue;
            e += 1 / rr;
            for (k = 0; k < 3; k++) {
                sum[k] += d[k] / rr;
                f[3 * j + k] -= d[k] / rr;
            }
        }
        for (k = 0; k < 3; k++)
            f[3 * i + k] += sum[k];
        energy += e;
        virial -= e * 0.5;
    }
} // TILED: 92

static void record_sums(long n, double cut) {
    for (long i = 1; i < n; i++) { // EXPECT: transformed
        vector sum = {0, 0, 0};
        points[i].force.x *= 1.0625;
        pairs += 2;
        energy += points[i].at.x;
        {
            const vector mine = points[i].at;
            long met = 0;
            double d;
            for (long j = 0; j < i; j++) {
                d = mine.x * points[j].at.y;
                if (d > cut) {
                    ADD(sum, d, points[j].at);
                    met++;
                    ADD(points[j].force, -d, points[j].at);
                    energy += d;
                }
            }
            if (met > 2)
                points[i].force.z -= d;
            pairs += met;
        }
        ADD(points[i].force, 1, sum);
    }
} // TILED: 118

/* A statement after the inner loop reads the column's counter, or an inner loop runs over all columns. */
static void counter_read_behind(int n, const double *x, double *f) {
    int i, j;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        double sum = 0;
        for (j = i + 1; j < n; j++) {
            sum += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
        f[i] += sum * (double)j;
    }
} // NOT-TILED: 147

static void long_rows(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double sum = 0;
        for (int j = 0; j < n; j++)
            sum += x[j] * x[i];
        for (int j = i + 1; j < n; j++) {
            sum *= 0.5;
            f[j] = f[j] * 0.5 - sum;
        }
        f[i] += sum;
    }
} // NOT-TILED: 158

static void last_column_behind(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double sum = 0;
        for (int j = i + 1; j < n; j++) {
            sum += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
        f[n - 1] = f[n - 1] * 0.5 + sum;
    }
} // NOT-TILED: 171

/* Vectors of 3 or 2 elements, one after another in one array, with local arrays. */
static void vectors(int n, const double *x, double *f) {
    double d[3], rr;
    int i, j, k;
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = i + 1; j < n; j++) {
            rr = 0.125;
            for (k = 0; k < 3; k++) {
                d[k] = x[3 * i + k] - x[3 * j + k];
                rr += d[k] * d[k];
            }
            if (rr < 1.5) {
                for (k = 0; k < 3; k++) {
                    f[3 * i + k] += d[k] / rr;
                    f[k + j * 3] -= d[k] / rr;
                }
            }
        }
} // TILED: 185

static void planes(long n, const float *x, const float *mass, float *f, float cut) {
    for (long i = 0; i < n; ++i) { // EXPECT: transformed
        const float m = mass[i];
        for (long j = i + 1; j < n; ++j) {
            const float dx = x[2 * i + 0] - x[2 * j + 0], dy = x[2 * i + 1] - x[2 * j + 1];
            const float rr = dx * dx + dy * dy;
            if (rr < cut) {
                const float e = m * mass[j] * (cut - rr);
                f[2 * i + 0] += e * dx;
                f[2 * i + 1] += e * dy;
                f[2 * j + 0] -= e * dx;
                f[2 * j + 1] -= e * dy;
            }
        }
    }
} // TILED: 202

/* The counter `k`, which a loop under a condition sets, is a subscript after that loop. */
static void counter_named_later(int n, const double *x, double *f) {
    int i, j, k;
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = i + 1; j < n; j++) {
            k = 1;
            if (x[i] * x[j] > 0.25)
                for (k = 0; k < 2; k++)
                    f[3 * j + k] -= x[i];
            f[3 * i + k] = f[3 * i + k] * 0.5 + x[j];
        }
} // NOT-TILED: 221

/* Vectors of 3 elements at distances of 2 overlap. */
static void longer_vectors(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++)
            for (int k = 0; k < 3; k++) {
                f[2 * i + k] += x[j];
                f[2 * j + k] = f[2 * j + k] * 0.5 - x[i];
            }
} // NOT-TILED: 233

/* The third value may come from an earlier turn of its row. */
static void older_values(int n, const double *x, double *f) {
    double d[3] = {0, 0, 0};
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        d[0] = d[1] = d[2] = x[i];
        for (int j = i + 1; j < n; j++) {
            for (int k = 0; k < 3 - (x[j] > 0); k++)
                d[k] = x[j] * 0.25;
            for (int k = 0; k < 3; k++) {
                f[3 * i + k] += d[k];
                f[3 * j + k] = f[3 * j + k] * 0.5 - d[k];
            }
        }
    }
} // TILED: 244

static void values_left_over(int n, const double *x, double *f) {
    double d[3] = {0, 0, 0};
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        d[0] = d[1] = d[2] = x[i];
        for (int j = i + 1; j < n; j++) {
            for (int k = 0; k < 3; k++) {
                if (x[j] * x[i] > 0.5 && k == 2)
                    continue;
                d[k] = x[j] * 0.25;
            }
            for (int k = 0; k < 3; k++) {
                f[3 * i + k] += d[k];
                f[3 * j + k] = f[3 * j + k] * 0.5 - d[k];
            }
        }
    }
} // TILED: 259

/* Row i + 1 and column j may be one element. */
static void uneven(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            f[i + 1] += x[j];
            f[j] = f[j] * 0.5 + x[i];
        }
} // NOT-TILED: 277

static void full(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i & 1; j < n; j++) {
            f[i] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
} // NOT-TILED: 285

static void above_and_below(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < i + 2; j++) {
            f[i] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
} // NOT-TILED: 293

static void carried(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double before = 1;
        for (int j = i + 1; j < n; j++) {
            const double e = x[i] * before;
            before = x[j];
            f[i] += e;
            f[j] = f[j] * 0.5 - e;
        }
    }
} // TILED: 301

static void sometimes_carried(int n, const double *x, double *f) {
    double e = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        e = x[i];
        for (int j = i + 1; j < n; j++) {
            if (x[j] > 0)
                e = x[j] * 0.25;
            f[i] += e;
            f[j] = f[j] * 0.5 - e;
        }
    }
} // TILED: 314

static void left_early(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            if (x[i] * x[j] > 0.9)
                break;
            f[i] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
} // NOT-TILED: 326

static void counted_by_rows(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        energy += x[i];
        for (int j = i + 1; j < n; j++) {
            f[i] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
    }
} // TILED: 336

static void begun_by_rows(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        f[i] = f[i] * 0.5 + 1;
        for (int j = i + 1; j < n; j++) {
            f[i] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
    }
} // TILED: 346

static void records_begun_by_rows(int n, const double *x) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        points[i].force.x += 1;
        for (int j = i + 1; j < n; j++) {
            points[i].force.x += x[j];
            points[j].force.x -= x[i];
        }
    }
} // TILED: 356

/* The arrays overlap: an element that `f` updates as a row may be updated by `g` as another column. */
static void two_arrays(int n, const double *x, double *f, double *g) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i; j < n; j++) {
            f[i] += x[j];
            g[j] += x[i] * 1.0625;
        }
}

static void by_twos(int n, const double *x, double *f) {
    for (int i = 0; i < n; i += 2) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            f[i] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
} // NOT-TILED: 375

/* Both counters step by threes, and the row's sums follow; other loops begin or end between multiples of the step. */
static void by_threes(int n, const double *x, double *f) {
    int i, j;
    for (i = 0; i < n * 3; i += 3) { // EXPECT: transformed
        double fx = 0, fy = 0;
        for (j = i + 3; j < n * 3; j += 3) {
            const double e = x[i] * x[j + 1] - x[i + 2] * x[j];
            if (e > 0.5)
                continue;
            fx += e;
            fy -= x[i + 1] * e;
            energy -= e * 0.5;
            f[j] -= e;
            f[j + 1] -= e * 0.25;
            f[j + 2] = f[j + 2] * 0.5 - x[i];
        }
        f[i] += fx;
        f[i + 1] += fy;
    }
} // TILED: 385

static void below_by_twos(long n, const double *x, double *f) {
    for (long i = 3; i < n; i += 2) // EXPECT: transformed
        for (long j = 1; j <= i; j = j + 2) {
            f[i + 4] += x[j];
            f[j + 5] = f[j + 5] * 0.5 - x[i];
        }
} // TILED: 404

static void between(int n, const double *x, double *f) {
    for (int i = 0; i < n; i += 3) // EXPECT: transformed
        for (int j = i + 2; j < n; j += 3) {
            f[i] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
} // NOT-TILED: 412

static void begun_between(int n, const double *x, double *f) {
    for (int i = 1; i < n; i += 2) // EXPECT: transformed
        for (int j = 0; j < i; j += 2) {
            f[i] += x[j];
            f[j + 1] = f[j + 1] * 0.5 - x[i];
        }
} // NOT-TILED: 420

static void longer_than_the_step(int n, const double *x, double *f) {
    for (int i = 0; i < n; i += 2) // EXPECT: transformed
        for (int j = i + 2; j < n; j += 2) {
            f[i + 2] += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
} // NOT-TILED: 428

/* The inner loop's header steps other variables as well. */
static void beside(int n, const double *x, double *f) {
    int i, j, p;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        p = n - i;
        for (j = i + 1; j < n; j++, p++)
            f[j] = f[j] * 0.5 - x[p];
    }
} // TILED: 438

static void walked_beside(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const double *p = x + 5;
        for (int j = i + 1; j < n; j++, p++)
            f[j] = f[j] * 0.5 - *p;
    }
} // NOT-TILED: 446

/* Each turn steps a position in a packed triangle, above or below the diagonal. */
static int packed_above(int n, const double *x, double *f, const double *packed) {
    int i, j, k = 2;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        double sum = 0;
        for (j = i + 1; j < COLUMNS; j++) {
            const double e = packed[k] * x[j];
            sum += packed[k] * x[i];
            if (e > 0.5)
                pairs += k;
            f[j] = f[j] * 0.5 - e;
            k = k + 1;
        }
        f[i] += sum;
    }
    return k;
} // TILED: 456

static long packed_below(int n, int first, double *f, const double *packed) {
#pragma vector aligned
    for (int i = 0; i < 2; i++)
        f[i] *= 0.5;
    long k = -3;
    for (int i = 1; i <= n; ++i) // EXPECT: transformed
        for (int j = first; j <= i; k++, j++) {
            f[i] += packed[k + 3];
            f[j] = f[j] * 0.5 - (double)k * 0.0625;
        }
    return k;
} // TILED: 476

/* Functions set a variable kept for the row, or set it through a pointer from before the inner loop. */
static double bond(double r, double *w) {
    if (r > 0.125)
        *w = r * 0.5;
    return r * r;
}

static void begin(double *w, double value) {
    *w = value;
}

static void set_by_functions(int n, const double *x, double *f, double *sum) {
    double w;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        begin(&w, x[i]);
        for (int j = i + 1; j < n; j++) {
            *sum = *sum + bond(x[i] * x[j], &w);
            f[i] = f[i] * 0.75 + w;
            f[j] -= w;
        }
        f[i] += w;
    }
} // TILED: 497

static void set_through_a_pointer(int n, const double *x, double *f) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double w = 1, *const to = &w;
        for (int j = i + 1; j < n; j++) {
            *to += x[j];
            f[j] = f[j] * 0.5 - x[i];
        }
        f[i] += w;
    }
} // NOT-TILED: 509

static void fill(void) {
    case_values(memory, ROOM);
    case_values((double *)points, (long)(sizeof points / (sizeof(double))));
    memory[N + 7] = -0.0;
    energy = -0.0;
    virial = case_value();
    pairs = 3;
}

static void print(void) {
    CASE_PRINT(memory);
    CASE_PRINT(points);
    CASE_PRINT(&energy);
    CASE_PRINT(&virial);
    CASE_PRINT(&pairs);
}

int main(void) {
    static const int counts[] = {N, N - 1, 17, 1};
    static float x[N], f[N];
    double *const m = memory;
    for (int round = 0; round < 4; round++) {
        const int n = counts[round];
        fill();
        if (round == 1)
            points[40].at.y = memory[33] = __builtin_inf() - __builtin_inf();
        records(n, round == 1 ? 1e9 : 1.5);
        for (int i = 0; i < N; i++) {
            x[i] = (float)case_value();
            f[i] = (float)memory[i];
        }
        below(n, x, f, 0.5f);
        CASE_PRINT(f);
        packed((unsigned)n, (const double(*)[3])m, (double(*)[3])(m + 3 * N), m + 6 * N, m + (round == 1 ? 6 * N + 3 : 7 * N));
        print();
        shifted(round - 3, n / 2, n - 10, m + 9, m + 3 * N, round == 2 ? m + 12 : m + 7 * N);
        shifted(0, n / 3, n / 3 * 2, m, m + (round == 1 ? N : 2 * N), m + 7 * N);
        print();
        vectors(n, m + 3 * N, m);
        summed_by_rows(n, m + 3 * N, m);
        record_sums(n, round == 1 ? -1e9 : 0.25);
        counter_read_behind(n, m, m + 2 * N);
        long_rows(n, m, m + 2 * N);
        last_column_behind(n, m, m + 2 * N);
        planes(n / 2, x, x + 1, f, 1);
        CASE_PRINT(f);
        longer_vectors(n - 1, m, m + 2 * N);
        counter_named_later(n, m, m + 2 * N);
        older_values(n, m, m + 2 * N);
        values_left_over(n, m, m + 2 * N);
        uneven(n, m, m + 2 * N);
        full(n, m, m + 2 * N);
        above_and_below(n - 1, m, m + 2 * N);
        carried(n, m, m + 2 * N);
        sometimes_carried(n, m, m + 2 * N);
        left_early(n, m, m + 2 * N);
        counted_by_rows(n, m, m + 2 * N);
        begun_by_rows(n, m, m + 2 * N);
        records_begun_by_rows(n, m);
        two_arrays(n, m, m + 2 * N, m + 2 * N + 7);
        by_twos(n - 1, m, m + 2 * N);
        by_threes(n, m, m + 4 * N);
        below_by_twos(n, m, m + 2 * N);
        between(n, m, m + 2 * N);
        begun_between(n, m, m + 2 * N);
        longer_than_the_step(n, m, m + 2 * N);
        beside(n, m, m + 2 * N);
        walked_beside(n, m, m + 2 * N);
        for (int first = 0; first < 3; first++) {
            pairs += packed_above(n / 4 - first, m + 3, m + N, m + 2 * N);
            pairs += packed_below(n / 4, 7 * first, m + N, m + 2 * N);
        }
        set_by_functions(n, m, m + 2 * N, &virial);
        set_through_a_pointer(n, m, m + 2 * N);
        print();
    }
}
