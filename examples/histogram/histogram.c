/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Weighted histogram of 4 million events: the energy in each of 4096 channels. Prints a checksum of
 * all bits of the result, and on standard error the seconds that it took.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { EVENTS = 4000000, CHANNELS = 4096, RUNS = 25 };

/* The loop that redcc parallelises: the channel of an event is known only at run time. */
static void fill(int n, const int *channel, const float *energy, double *histogram) {
    for (int t = 0; t < n; t++)
        histogram[channel[t]] += 1e-3 * energy[t] * energy[t];
}

static uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u; /* Numerical Recipes' generator */
    return *state >> 8;
}

static double seconds_now(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static uint64_t checksum(const double *values, int n) {
    uint64_t sum = 0, bits;
    for (int i = 0; i < n; i++) {
        memcpy(&bits, &values[i], sizeof bits);
        sum = sum * 31 + bits;
    }
    return sum;
}

int main(void) {
    int *channel = malloc(EVENTS * sizeof *channel);
    float *energy = malloc(EVENTS * sizeof *energy);
    double *histogram = calloc(CHANNELS, sizeof *histogram);
    if (!channel || !energy || !histogram)
        return 1;
    uint32_t state = 1;
    for (int t = 0; t < EVENTS; t++) {
        channel[t] = (int)(next_random(&state) % CHANNELS);
        energy[t] = (float)next_random(&state) / 16777216.0f;
    }
    const double begin = seconds_now();
    for (int run = 0; run < RUNS; run++)
        fill(EVENTS, channel, energy, histogram);
    fprintf(stderr, "%.3f s\n", seconds_now() - begin);
    printf("histogram %016llx\n", (unsigned long long)checksum(histogram, CHANNELS));
    free(channel);
    free(energy);
    free(histogram);
    return 0;
}
