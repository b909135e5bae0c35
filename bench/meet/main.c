/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * PROGRAM CALLS [CALLS...]: the numbers CALLS ascend. For each of them, prints the total seconds of
 * that many calls, from the first one on, and a hash of the bits of the results.
 */
#include "meet.h"

#include <stdint.h>
#include <stdio.h>
#include <time.h>

double draw(void) {
    static uint64_t state = 88172645463325252u; /* xorshift64, G. Marsaglia 2003 */
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

void *room(size_t bytes) {
    void *memory = calloc(1, bytes);
    if (!memory)
        exit(1);
    return memory;
}

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static uint64_t hash(void) {
    size_t size;
    const unsigned char *bytes = results(&size);
    uint64_t h = 0xcbf29ce484222325u;
    for (size_t b = 0; b < size; b++)
        h = (h ^ bytes[b]) * 0x100000001b3u;
    return h;
}

int main(int argc, char **argv) {
    double seconds = 0;
    int calls = 0;
    make();
    for (int a = 1; a < argc; a++) {
        for (; calls < atoi(argv[a]); calls++) {
            if (calls > 0)
                change();
            const double begin = now();
            call();
            seconds += now() - begin;
        }
        printf("%d %.6f %016llx\n", calls, seconds, (unsigned long long)hash());
    }
}
