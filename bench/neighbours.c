/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Times a loop that gains by running in parallel, while other programs use the same cores
 * (bench/neighbours.sh).
 *
 *    neighbours ITERATIONS EXECUTIONS
 *
 * prints the total time of all executions in seconds (with the time between them), a hash of the
 * results' bits, and how many times per second a thread lost its core (involuntary context
 * switches).
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static void add(int n, const int *row, const double *x, double *sum) {
    for (int t = 0; t < n; t++)
        sum[row[t]] += sqrt(x[t]) / (1 + x[t] * x[t]);
}

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static uint64_t hash_of(const double *value, int count) {
    uint64_t hash = 0;
    for (int i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &value[i], sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}

int main(int count, char **word) {
    if (count != 3) {
        fputs("neighbours ITERATIONS EXECUTIONS\n", stderr);
        return 2;
    }
    const int n = atoi(word[1]), executions = atoi(word[2]), rows = n / 8 + 1;
    int *row = malloc((size_t)n * sizeof *row);
    double *x = malloc((size_t)n * sizeof *x), *sum = calloc((size_t)rows, sizeof *sum);
    if (!row || !x || !sum)
        return 1;
    for (int t = 0; t < n; t++) {
        row[t] = (t / 8 + t % 3) % rows;
        x[t] = 1 + t % 1000 * 0.37;
    }
    const double began = seconds();
    for (int i = 0; i < executions; i++)
        add(n, row, x, sum);
    const double ended = seconds();
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    printf("%.6f %016llx %.0f\n", ended - began, (unsigned long long)hash_of(sum, rows),
           (double)used.ru_nivcsw / (ended - began));
    free(row);
    free(x);
    free(sum);
    return 0;
}
