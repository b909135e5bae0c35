/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* One memory object at two addresses: two adjacent mappings (a ring buffer), a segment attached
 * twice, a file mapped both shared and private, and a mapping that mremap copies. POSIX and
 * Linux. */
// METHODS: auto binning localwrite localwrite-steal graph-localwrite wavefront atomic dwa-lip expansion
// THREADS: 1 2 3 7 33
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/shm.h>
#include <unistd.h>

enum { N = 20000, H = 8192, BYTES = H * (int)sizeof(long), ROUNDS = 3 };
static int k[N], m[N];

/* Updates both mappings of the ring. */
__attribute__((noinline)) static void ring(long *h) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        h[k[t] + (t & 1) * H] += t;
}

/* Updates only one mapping: for comparison, runs in parallel. */
__attribute__((noinline)) static void half_of_a_ring(long *h) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += t;
}

__attribute__((noinline)) static void two_arrays(long *a, long *b) {
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        a[k[t]] += t;
        b[m[t]] -= t;
    }
}

__attribute__((noinline)) static void two_arrays_apart(long *a, long *b) {
    for (int t = 0; t < N; t++) { // EXPECT: parallel
        a[k[t]] += t;
        b[m[t]] -= t;
    }
}

/* The loop's updates change what it reads. */
__attribute__((noinline)) static void reads(long *h, const long *x) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        h[k[t]] += x[m[t]] & 1023;
}

__attribute__((noinline)) static void reads_apart(long *h, const long *x) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += x[m[t]] & 1023;
}

/* Reads two rows. The second one is another mapping of h's memory. */
__attribute__((noinline)) static void reads_rows(long *h, long *const *row) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        h[k[t]] += row[t & 1][m[t]] & 1023;
}

/* Each iteration makes valid, through one mapping, a subscript that the next one reads through the other. */
enum { LINKS = BYTES / (int)sizeof(int), FAR = 1000000000 };
static int map_of[LINKS];
__attribute__((noinline)) static void chain(int n, int *count, const int *link) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        count[map_of[link[i]]] += FAR;
}

static long checksum;
static void take(const long *h, int count) {
    for (int i = 0; i < count; i++)
        checksum = checksum * 31 + h[i];
    printf("%ld\n", checksum);
}

static long *map(void *at, int bytes, int flags, int file) {
    void *place = mmap(at, (size_t)bytes, PROT_READ | PROT_WRITE, flags, file, 0);
    if (place == MAP_FAILED)
        exit(1);
    return place;
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = (int)(t * 7919LL % 97);
        m[t] = (int)(t * 104729LL % 89);
    }
    const int file = memfd_create("ring", 0);
    if (file < 0 || ftruncate(file, 3 * BYTES) != 0)
        return 1;
    long *const both = map(NULL, 2 * BYTES, MAP_PRIVATE | MAP_ANONYMOUS, -1);
    map(both, BYTES, MAP_SHARED | MAP_FIXED, file);
    map(both + H, BYTES, MAP_SHARED | MAP_FIXED, file);
    long *const heap = calloc(H, sizeof *heap);
    for (int round = 0; round < ROUNDS; round++) {
        ring(both);
        half_of_a_ring(both);
        two_arrays(both, both + H);
        two_arrays_apart(both, heap);
    }
    take(both, H);
    take(heap, H);

    const int segment = shmget(IPC_PRIVATE, BYTES, IPC_CREAT | 0600);
    if (segment >= 0) {
        long *const here = shmat(segment, NULL, 0), *const there = shmat(segment, NULL, 0);
        shmctl(segment, IPC_RMID, NULL);
        for (int round = 0; round < ROUNDS; round++) {
            two_arrays(here, there);
            reads(here, there);
            reads_apart(here, heap);
        }
        take(here, H);
    }

    long *const original = map(NULL, BYTES, MAP_SHARED | MAP_ANONYMOUS, -1);
    long *const copy = mremap(original, 0, BYTES, MREMAP_MAYMOVE);
    if (copy == MAP_FAILED)
        return 1;
    long *const row[2] = {heap, copy};
    for (int round = 0; round < ROUNDS; round++) {
        two_arrays(copy, original);
        reads_rows(original, row);
        reads_apart(copy, heap);
    }
    take(original, H);

    int *const count = (int *)original, *const link = (int *)copy;
    for (int i = 0; i < LINKS; i++) {
        count[i] = i == 0 ? 0 : i - FAR;
        map_of[i] = i + 1;
    }
    chain(LINKS - 1, count, link);
    take(original, H);

    /* Pages of a private mapping that have not been written show the file's content. */
    long *const shared = map(NULL, BYTES, MAP_SHARED, file);
    const long *const private = map(NULL, BYTES, MAP_PRIVATE, file);
    for (int round = 0; round < ROUNDS; round++) {
        reads(shared, private);
        reads_apart(shared, heap);
    }
    take(shared, H);
    return 0;
}
