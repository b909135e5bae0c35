/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: inside a region the existing team executes `for` loops that reduce scalars, in fixed blocks.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// FIXED: blocks
#include "case.h"

enum { N = 20000, NEAR = 7 };
static double x[N], b[N], r[N], p[N], q[N], w[N];
static double rho, product, of_file, thread_own[8];
#pragma omp threadprivate(thread_own)
static int k[N];

/* a conjugate gradient solver in one region */
static void solve(int n, int steps) {
    int j;
    double alpha, beta, before;
    rho = 0;
#pragma omp parallel default(shared) private(j, alpha, beta, before)
    {
#pragma omp for nowait
        for (j = 0; j < n; j++)
            x[j] = 0, r[j] = p[j] = b[j];
        /* reads what threads wrote in the loop above, some of it in other threads */
#pragma omp for reduction(+ : rho)
        for (j = 0; j < n; j++) // EXPECT: transformed
            rho += r[n - 1 - j] * r[n - 1 - j];
        for (int step = 0; step < steps; step++) {
            before = rho;
#pragma omp barrier
#pragma omp single
            rho = product = 0;
#pragma omp for
            for (j = 0; j < n; j++) {
                q[j] = 9 * p[j];
                for (int at = -NEAR; at <= NEAR; at += NEAR)
                    if (j + at >= 0 && j + at < n)
                        q[j] -= 0.75 * p[j + at];
            }
#pragma omp for reduction(+ : product)
            for (j = 0; j < n; j++) // EXPECT: transformed
                product += p[j] * q[j];
            alpha = before / product;
#pragma omp for reduction(+ : rho) schedule(guided)
            for (j = 0; j < n; j++) { // EXPECT: transformed
                x[j] += alpha * p[j];
                r[j] -= alpha * q[j];
                rho += r[j] * r[j];
            }
            beta = rho / before;
#pragma omp for
            for (j = 0; j < n; j++)
                p[j] = r[j] + beta * p[j];
        }
    }
    case_print("rho", &rho, sizeof rho);
}

/* in a function called inside and outside a region */
static void orphan(int n, const double *restrict u) {
#pragma omp for reduction(+ : of_file)
    for (int i = 0; i < n; i++) // EXPECT: transformed
        of_file += u[i] * w[i];
}

/* repeated with `nowait`: the next loop reads what this loop wrote, in the same thread */
static double hasty(int n, int rounds) {
    double first = 0, second = 1, least = 1e300;
    static double sum;
    sum = 0;
#pragma omp parallel
    for (int round = 0; round < rounds; round++) {
#pragma omp for nowait reduction(+ : first) reduction(min : least)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            q[i] = w[i] + round;
            first += q[i];
            least = least < q[i] ? least : q[i];
        }
#pragma omp for
        for (int i = 0; i < n; i++)
            p[i] = q[i] * 0.5;
#pragma omp for nowait reduction(- : second) schedule(dynamic, 3)
        for (int i = n - 1; i > 2; i -= 3) // EXPECT: transformed
            second -= p[i] * 0.5;
#pragma omp barrier
#pragma omp flush
#pragma omp for reduction(+ : sum)
        for (int i = 3; i <= n - 1; i++) // EXPECT: transformed
            sum += p[i];
    }
    return first + second * 3 + least * 1e3 + sum * 1e-3;
}

/* clauses, and variables private to a thread that no other loop of the region uses */
static double clauses(int n) {
    double sum = 0, mine = 0, last = 0, counts[4] = {0};
    int i = 0, from = 3;
#pragma omp parallel private(mine)
    {
        double bins[4] = {0};
#pragma omp for schedule(static) reduction(+ : sum) firstprivate(from) lastprivate(last, i)
        for (i = 1; i < n; i += 2) { // EXPECT: transformed
            mine = w[i] + from;
            thread_own[i & 7] = mine;
            bins[k[i] & 3]++;
            last = thread_own[i & 7];
            sum += last * mine;
        }
#pragma omp critical
        for (int c = 0; c < 4; c++)
            counts[c] += bins[c];
    }
    case_print("counts", counts, sizeof counts);
    case_print("last", &last, sizeof last);
    case_print("i", &i, sizeof i);
    return sum;
}

/* No iteration: `lastprivate` sets the counter as the loop without a directive does; OpenMP leaves it unspecified. */
static int never(int n) {
    int i = -7;
    double sum = 0.25, last = 5;
#pragma omp parallel
    {
#pragma omp for reduction(+ : sum) lastprivate(last, i)
        for (i = n; i > N; i--) { // EXPECT: transformed
            last = w[i];
            sum += last;
        }
#pragma omp single
        sum *= 2;
    }
    return sum == 0.5 && (getenv("CASE_INTEGERS") || (last == 5 && i == n)); /* unspecified in OpenMP */
}

/* reduced variables of all widths */
static double sizes(int n) {
    signed char low = 100;
    unsigned char bits = 0;
    short least = 3000;
    unsigned short most = 7;
    int count = -5;
    unsigned odd = 1;
    long all = 1;
    unsigned long long product = 1;
    _Bool any = 0;
    float single = 0.5f;
    long double wide = 0.25L;
#pragma omp parallel
    {
#pragma omp for reduction(min : low, least) reduction(max : most) reduction(| : bits) reduction(^ : odd)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            low = (signed char)(k[i] % 100 - 50 < low ? k[i] % 100 - 50 : low);
            least = (short)(k[i] - 900 < least ? k[i] - 900 : least);
            most = (unsigned short)(k[i] > most ? k[i] : most);
            bits |= (unsigned char)(1 << (k[i] & 7));
            odd ^= (unsigned)k[i] * 77u;
        }
#pragma omp for reduction(+ : count, all, single, wide) reduction(* : product) reduction(|| : any)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            count += k[i] & 3;
            all += k[i];
            product *= 2 * (unsigned long long)k[i] + 1;
            any = any || k[i] == N - 1;
            single += (float)w[i];
            wide += w[i];
        }
    }
    case_print("odd", &odd, sizeof odd);
    case_print("product", &product, sizeof product);
    return low + bits * 3 + least * 5 + most * 7 + count * 11 + (double)all + any + single + (double)wide;
}

/* each thread of a team opens a team, in a region with an if clause */
static double nested(int n) {
    double sums[4] = {0}, sum = 0;
#pragma omp parallel for
    for (int part = 0; part < 4; part++) {
        double mine = 0;
#pragma omp parallel num_threads(2) if (part != 1)
        {
#pragma omp for reduction(+ : mine)
            for (int i = 0; i < n; i++) // EXPECT: transformed
                mine += w[i] * part;
        }
        sums[part] = mine;
    }
    for (int part = 0; part < 4; part++)
        sum += sums[part];
    return sum;
}

int main(void) {
    case_values(b, N);
    case_values(w, N);
    case_subscripts(k, N, N);
    if (!getenv("CASE_INTEGERS")) // its quotients are not integers
        solve(N, 25);
    CASE_PRINT(x);
    of_file = 0.25;
    for (int round = 0; round < 3; round++) {
#pragma omp parallel
        orphan(N - round, b);
        orphan(N / 2, b);
    }
    case_print("of_file", &of_file, sizeof of_file);
    double sums[] = {hasty(N, 20), hasty(1, 3), hasty(0, 2), clauses(N), clauses(6), nested(N), sizes(N), sizes(3)};
    CASE_PRINT(sums);
    return !(never(N) && never(7));
}
