/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Cost and accuracy of each order and each kind of sum. The loop is `b[row[t]] += value[t]`, 1.2
 * million contributions to 20000 elements. It is executed with combinations of REDCC_ORDER,
 * REDCC_SUM and REDCC_METHOD.
 *
 *     accuracy CORES >accuracy.csv
 *
 * - rows: sorted (consecutive contributions go to adjacent elements) or shuffled (to any element)
 * - values: well-conditioned (in (0, 1)) or ill-conditioned (of both signs, over ten orders of
 *    magnitude, so that each element's sum is about 1e-12 of the sum of its terms' magnitudes)
 *
 * Errors are relative to the exact sum, which is computed in 113 bits. Every run is a separate
 * process, because a process reads the variables only once. Runs use CORES threads, then 1, 2, 3, 8
 * and 16.
 */
#include "redcc/runtime.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 wide;
#else
typedef long double wide;
#endif

enum { TRIP = 1200000, ROWS = 20000, RUNS = 20, ROUNDS = 9, MOST_RESULTS = 64 };

static int row[TRIP];
static double value[TRIP];
static wide exact[ROWS];

static unsigned long random_state = 88172645463325252u;

static unsigned long next_random(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state;
}

static double unit(void) {
    return (double)(next_random() >> 11) * 0x1p-53;
}

static void make_rows(int shuffled) {
    for (int t = 0; t < TRIP; t++) {
        const int near = (int)((long)t * ROWS / TRIP) + (int)(next_random() % 17) - 8;
        row[t] = shuffled ? (int)(next_random() % ROWS) : (near + ROWS) % ROWS;
    }
}

/* Makes the values. If `ill` is set, the last contribution to each element cancels all but about
 * 1e-12 of the sum of the others' magnitudes. */
static void make_values(int ill) {
    static wide sum[ROWS], size[ROWS];
    static int last[ROWS];
    for (int i = 0; i < ROWS; i++)
        sum[i] = size[i] = 0;
    for (int t = 0; t < TRIP; t++) {
        value[t] = ill ? (unit() - 0.5) * pow(10, 10 * unit()) : unit();
        last[row[t]] = t;
    }
    for (int t = 0; t < TRIP; t++) {
        if (ill && t == last[row[t]])
            value[t] = (double)(1e-12 * (1 + unit()) * size[row[t]] - sum[row[t]]);
        sum[row[t]] += (wide)value[t];
        size[row[t]] += value[t] < 0 ? -(wide)value[t] : (wide)value[t];
    }
    memcpy(exact, sum, sizeof exact);
}

static void add_up(double *b, int from, int to) {
    for (int t = from; t < to; t++)
        b[row[t]] += value[t];
}

/* The loop in the form that redcc generates. */
static void add_up_by_redcc(double *b) {
    static const redcc_array arrays[] = {
        {"b", REDCC_SUM, REDCC_DOUBLE, sizeof(double), sizeof(double), 0}};
    static const redcc_source sources[] = {{"row", 1}, {"value", 0}};
    static redcc_loop loop = {.file = __FILE__,
                              .line = __LINE__,
                              .function = __func__,
                              .order = REDCC_ORDER_SERIAL,
                              .flags = REDCC_VERIFIABLE,
                              .array_count = 1,
                              .arrays = arrays,
                              .source_count = 2,
                              .sources = sources,
                              .key_count = 1};
    void *const bases[] = {b};
    const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)},
                                  {(const char *)value, (const char *)(value + TRIP)}};
    const redcc_word key[] = {0};
    redcc_call call;
    if (redcc_enter(&call, &loop, TRIP, bases, known, key, omp_get_max_threads(),
                    omp_in_parallel())) {
#pragma omp parallel num_threads(call.threads)
        {
            redcc_worker worker;
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
            while (redcc_inspect(&worker))
                for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {
                    redcc_touch(&worker, 0, &b[row[t]], sizeof b[row[t]]);
                    redcc_iteration_done(&worker);
                }
            while (redcc_next(&worker)) {
                double *const to = worker.base[0];
                const redcc_owner own = worker.owner[0];
                for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) {
                    int t = (int)(worker.origin + run->begin);
                    const int end = t + (int)(run->count_and_check / 2);
                    if (!(run->count_and_check & 1))
                        add_up(to, t, end);
                    else
                        for (; t < end; t++)
                            if (redcc_owns(&own, &to[row[t]]))
                                to[row[t]] += value[t];
                }
            }
        }
    }
    if (!redcc_leave(&call))
        add_up(b, 0, TRIP);
    redcc_sequential_done(&loop);
}

/* The results of a child process. */
struct outcome {
    double b[ROWS];
    double seconds;        /* median time of the loop by redcc */
    double serial_seconds; /* median time of the sequential loop, in the same rounds */
};

static int by_size(const void *p, const void *q) {
    const double d = *(const double *)p - *(const double *)q;
    return d < 0 ? -1 : d > 0;
}

static double median(double *values) {
    qsort(values, ROUNDS, sizeof *values, by_size);
    return values[ROUNDS / 2];
}

static void measure(struct outcome *outcome, int timed) {
    double planned[ROUNDS], serial[ROUNDS];
    for (int warm = 0; warm < (timed ? 8 : 2); warm++)
        add_up_by_redcc(outcome->b);
    for (int round = 0; timed && round < ROUNDS; round++) {
        const double begin = omp_get_wtime();
        add_up_by_redcc(outcome->b);
        const double middle = omp_get_wtime();
        add_up(outcome->b, 0, TRIP);
        planned[round] = middle - begin;
        serial[round] = omp_get_wtime() - middle;
    }
    if (timed) {
        outcome->seconds = median(planned);
        outcome->serial_seconds = median(serial);
    }
    memset(outcome->b, 0, sizeof outcome->b);
    add_up_by_redcc(outcome->b);
}

struct way {
    const char *order, *sum, *method;
};

static void run_child(const struct way *way, int threads, struct outcome *outcome, int timed) {
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        char count[16];
        snprintf(count, sizeof count, "%d", threads);
        setenv("OMP_NUM_THREADS", count, 1);
        setenv("REDCC_ORDER", way->order, 1);
        setenv("REDCC_SUM", way->sum, 1);
        setenv("REDCC_METHOD", way->method, 1);
        omp_set_num_threads(threads);
        measure(outcome, timed);
        _exit(0);
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
        fprintf(stderr, "accuracy: a run failed\n");
        exit(1);
    }
}

/* Results collected over all runs of one combination. */
struct collected {
    unsigned long result[MOST_RESULTS]; /* hashes of the different results */
    int results;
    double low[ROWS], high[ROWS];
    double worst, middle; /* relative error of the first run: the largest and the median */
};

static void collect(struct collected *all, const double *b) {
    unsigned long hash = 0;
    for (int i = 0; i < ROWS; i++) {
        unsigned long bits;
        memcpy(&bits, &b[i], sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        if (all->results == 0 || b[i] < all->low[i])
            all->low[i] = b[i];
        if (all->results == 0 || b[i] > all->high[i])
            all->high[i] = b[i];
    }
    int known = 0;
    for (int r = 0; r < all->results; r++)
        known |= all->result[r] == hash;
    if (!known && all->results < MOST_RESULTS)
        all->result[all->results++] = hash;
}

static void find_errors(struct collected *all, const double *b) {
    static double error[ROWS];
    for (int i = 0; i < ROWS; i++)
        error[i] = fabs((double)(((wide)b[i] - exact[i]) / exact[i]));
    qsort(error, ROWS, sizeof *error, by_size);
    all->worst = error[ROWS - 1];
    all->middle = error[ROWS / 2];
}

static double spread(const struct collected *all) {
    double most = 0;
    for (int i = 0; i < ROWS; i++) {
        const double off = fabs((all->high[i] - all->low[i]) / (double)exact[i]);
        most = off > most ? off : most;
    }
    return most;
}

static void try_way(const struct way *way, int cores, const char *rows, const char *values,
                    struct outcome *outcome) {
    static const int counts[] = {1, 2, 3, 8, 16};
    static struct collected all;
    all.results = 0;
    run_child(way, cores, outcome, 1);
    const double seconds = outcome->seconds, serial_seconds = outcome->serial_seconds;
    find_errors(&all, outcome->b);
    collect(&all, outcome->b);
    for (int run = 1; run < RUNS; run++) {
        run_child(way, cores, outcome, 0);
        collect(&all, outcome->b);
    }
    const int over_runs = all.results;
    const double spread_of_runs = spread(&all);
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        run_child(way, counts[c], outcome, 0);
        collect(&all, outcome->b);
    }
    printf("%s,%s,%s,%s,%s,%d,%.6f,%.6f,%.3g,%.3g,%d,%.3g,%d,%.3g\n", rows, values, way->order,
           way->sum, way->method, cores, seconds, serial_seconds, all.worst, all.middle, over_runs,
           spread_of_runs, all.results, spread(&all));
}

int main(int count, char **arguments) {
    static const struct way ways[] = {{"any", "plain", "auto"},
                                      {"any", "plain", "expansion"},
                                      {"any", "plain", "atomic"},
                                      {"fixed", "plain", "auto"},
                                      {"fixed", "plain", "dwa-lip-fixed"},
                                      {"fixed", "plain", "expansion-fixed"},
                                      {"serial", "plain", "auto"},
                                      {"serial", "plain", "localwrite"},
                                      {"serial", "plain", "graph-localwrite"},
                                      {"serial", "plain", "wavefront"},
                                      {"serial", "compensated", "localwrite"},
                                      {"serial", "compensated", "graph-localwrite"}};
    const int cores = count > 1 ? atoi(arguments[1]) : 2;
    struct outcome *outcome =
        mmap(NULL, sizeof *outcome, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (outcome == MAP_FAILED)
        return 1;
    puts("rows,values,order,sum,method,threads,seconds,serial_seconds,largest_error,median_error,"
         "results_in_20_runs,spread_of_runs,results_at_all_threads,spread_of_threads");
    for (int shuffled = 0; shuffled < 2; shuffled++)
        for (int ill = 0; ill < 2; ill++) {
            make_rows(shuffled);
            make_values(ill);
            for (size_t w = 0; w < sizeof ways / sizeof *ways; w++)
                try_way(&ways[w], cores, shuffled ? "shuffled" : "sorted", ill ? "ill" : "well",
                        outcome);
        }
    return 0;
}
