/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The example of docs/generated-code.md in a program, its iterations told, not probed: springs N
 * THREADS CALLS prints a checksum of the bits of the result, which must be the serial loop's; with
 * one argument more, the trip count from which on loops of short iterations are worth entering. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _OPENMP
#include <redcc/runtime.h>
REDCC_REQUIRE_VERSION(1);
#ifdef SPRINGS_LEAVE_OUT /* breaks the promise, for REDCC_VALIDATE to find out */
#define redcc_owns(owner, address) ((void)(owner), 0)
#endif
#endif
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__FP_FAST_FMA)
#pragma GCC optimize("fp-contract=off")
#endif

struct system {
    double (*b)[3];
};

static void spring(const double (*x)[3], int i, int j, double *f) {
    int c;
    for (c = 0; c < 3; c++)
        f[c] = 0.7 * (x[j][c] - x[i][c]) - 0.1;
}

/* clang-format off */
static void springs(int n, const int (*edge)[2], const double (*x)[3], struct system *s) {
    int t, i, j;
    double f[3];
{ /* redcc: iterations run in parallel; s->b (+) keeps the order of the sequential loop */
#ifdef _OPENMP
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
    static const redcc_array redcc__arrays[] = {
        {"s->b", REDCC_SUM, REDCC_DOUBLE, sizeof(double), sizeof(s->b[0])}};
    static const redcc_source redcc__sources[] = {{"edge", 1}, {"x", 0}};
    static redcc_loop redcc__loop = {"springs.c", 4, "springs", REDCC_ORDER_SERIAL, REDCC_VERIFIABLE,
                                     1, redcc__arrays, 2, redcc__sources, 2, 0};
    redcc_call redcc__call;
    const redcc_int redcc__lower = 0;                                  /* the counter's first value */
    const redcc_int redcc__trip = redcc__lower < n ? (redcc_int)n - redcc__lower : 0;
    void *const redcc__bases[] = {(void *)s->b};
    redcc_extent redcc__known[2] = {{0, 0}, {0, 0}};
    const redcc_word redcc__key[] = {(redcc_word)redcc__lower, (redcc_word)(redcc_size)edge};
    int redcc__done;
    if (redcc__trip > 0) {                            /* ends of what is read at affine subscripts */
        redcc__known[0].first = (const char *)&edge[redcc__lower];
        redcc__known[0].end = (const char *)(&edge[redcc__lower + redcc__trip - 1] + 1);
        redcc__known[1].first = (const char *)x;      /* x[i]: the inspector tells the ends */
    }
    if (redcc_enter(&redcc__call, &redcc__loop, redcc__trip, redcc__bases, redcc__known, redcc__key,
                    omp_get_max_threads(), omp_in_parallel())) {
#pragma omp parallel num_threads(redcc__call.threads) firstprivate(edge, x, s)
        {
            redcc_worker redcc__worker;
            redcc_int redcc__k;
            redcc_join(&redcc__worker, &redcc__call, omp_get_thread_num(), omp_get_num_threads());
            /* inspector: which elements does each iteration update? */
            while (redcc_inspect(&redcc__worker))
                for (redcc__k = redcc__worker.first; redcc__k < redcc__worker.last;
                     redcc__k += redcc__worker.stride) {
                    __typeof__(t) t = (__typeof__(t))(redcc__lower + redcc__k);
                    __typeof__(i) i;
                    __typeof__(j) j;
                    i = edge[t][0];
                    j = edge[t][1];
                    redcc_read(&redcc__worker, 1, &x[i], sizeof(x[i]));
                    redcc_read(&redcc__worker, 1, &x[j], sizeof(x[j]));
                    redcc_touch(&redcc__worker, 0, &s->b[i], sizeof(s->b[i]));
                    redcc_touch(&redcc__worker, 0, &s->b[j], sizeof(s->b[j]));
                    redcc_iteration_done(&redcc__worker);
                }
            /* executor */
            while (redcc_next(&redcc__worker)) {
                __typeof__(&(s->b)[0]) const redcc__b =
                    (__typeof__(&(s->b)[0]))redcc__worker.base[0];
                const redcc_owner redcc__own_b = redcc__worker.owner[0];
                const redcc_run *redcc__run = redcc__worker.run;
                for (; redcc__run != redcc__worker.run_end; redcc__run++) {
                    const redcc_int redcc__end = redcc__worker.origin + redcc__run->begin
                                                 + redcc__run->count_and_guard / 2;
                    redcc__k = redcc__worker.origin + redcc__run->begin;
                    if (!(redcc__run->count_and_guard & 1))
                        for (; redcc__k < redcc__end; redcc__k++) {
                            __typeof__(t) t = (__typeof__(t))(redcc__lower + redcc__k);
                            __typeof__(i) i;
                            __typeof__(j) j;
                            __typeof__(f) f;
                            {
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            redcc__b[i][c] += f[c];
            redcc__b[j][c] -= f[c];
        }
    }
                        }
                    else
                        for (; redcc__k < redcc__end; redcc__k++) {
                            __typeof__(t) t = (__typeof__(t))(redcc__lower + redcc__k);
                            __typeof__(i) i;
                            __typeof__(j) j;
                            __typeof__(f) f;
                            {
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            { if (redcc_owns(&redcc__own_b, &redcc__b[i][c])) redcc__b[i][c] += f[c]; }
            { if (redcc_owns(&redcc__own_b, &redcc__b[j][c])) redcc__b[j][c] -= f[c]; }
        }
    }
                        }
                }
            }
        }
    }
    redcc__done = redcc_leave(&redcc__call);
    if (redcc__done)
        t = (__typeof__(t))(redcc__lower + redcc__trip);    /* where the counter outlives the loop */
#pragma GCC diagnostic pop
    if (!redcc__done)
#endif
    for (t = 0; t < n; t++) {
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            s->b[i][c] += f[c];
            s->b[j][c] -= f[c];
        }
    }
#ifdef _OPENMP
    redcc_sequential_done(&redcc__loop);
#endif
}
    if (t != n)
        abort();
}
/* clang-format on */

int main(int count, char **arguments) {
    const int nodes = count > 1 ? atoi(arguments[1]) : 1000;
    const int calls = count > 2 ? atoi(arguments[2]) : 3;
    const int n = 3 * nodes;
    int(*edge)[2] = malloc(sizeof(int[2]) * (size_t)n);
    double(*x)[3] = calloc((size_t)nodes, sizeof(double[3]));
    struct system s = {calloc((size_t)nodes, sizeof(double[3]))};
    unsigned long sum = 0;
    for (int t = 0; t < n; t++) {
        edge[t][0] = t / 3;
        edge[t][1] = (t / 3 + 1 + t % 3 * 7) % nodes;
    }
    for (int i = 0; i < nodes; i++)
        for (int c = 0; c < 3; c++)
            x[i][c] = 0.37 * i + 1.0 / (c + i + 1);
    for (int call = 0; call < calls; call++)
        springs(n, (const int(*)[2])edge, (const double(*)[3])x, &s);
    for (int i = 0; i < nodes; i++)
        for (int c = 0; c < 3; c++) {
            unsigned long bits;
            memcpy(&bits, &s.b[i][c], sizeof bits);
            sum = (sum ^ bits) * 0x9e3779b97f4a7c15u;
        }
    printf("%016lx\n", sum);
#ifdef _OPENMP
    if (count > 3)
        for (redcc_int trip = 0; trip < 1000; trip++)
            if (redcc_is_worth_entering(trip)) {
                printf("from %lld\n", (long long)trip);
                break;
            }
#endif
    free(edge);
    free(x);
    free(s.b);
    return 0;
}
