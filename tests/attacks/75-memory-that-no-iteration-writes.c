// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Scalars that an iteration updates under a condition that never holds. Since the program does not
// write them, they may be in read-only memory, or another thread may write them under its lock. Sums,
// products, bits, minima and maxima; variables, members, elements and targets of pointers. For
// comparison: conditions that hold.
#include <pthread.h>
#include <stdio.h>
#include <sys/mman.h>

enum { N = 20000, K = 300, PAGE = 1 << 16 };
static int s[N];
static double x[N], h[K];

struct totals {
    double sum, product, most, least;
    float narrow;
    long count;
    unsigned bits, both;
    unsigned char small;
    int list[4], at;
    _Bool any;
};

/* Each object begins a page; together they fill the section to its last page. */
#define HELD static __attribute__((section("held"), aligned(PAGE)))
extern char __start_held[], __stop_held[];
HELD int first_or_last = 1;
HELD struct totals totals = {.product = 1};
HELD int errors = 3;
HELD double highest = 2, lowest = 1;
HELD int place = -1;
HELD unsigned char few = 250;
HELD float narrow = -0.0f;
HELD long all_bits = -1, some_bits = 0;
HELD int last_or_first = 1;

static int hold(int access) {
    const long size = __stop_held - __start_held;
    return mprotect(__start_held, (size_t)(size / PAGE * PAGE), access);
}

static void counter(int n, double limit) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        if (x[t] > limit)
            errors++;
    }
}

static void variables(int n, double limit) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        if (x[t] > limit) {
            few += 3;
            narrow += (float)x[t];
            all_bits &= t;
            some_bits |= t;
        }
    }
}

static void extrema(int n, double limit) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        if (x[t] > limit) {
            if (x[t] > highest) {
                highest = x[t];
                place = t;
            }
            lowest = x[t] <= lowest ? x[t] : lowest;
        }
    }
}

static void in_a_loop(int n, double limit) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        for (int c = 0; c < 3; c++)
            if (x[t] + c > limit)
                some_bits += c + t;
    }
}

static void members(int n, double limit) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        if (x[t] > limit) {
            totals.sum += x[t];
            totals.count -= 2;
            totals.list[2] ^= t;
        }
    }
}

static void behind_continue(int n, double limit) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        if (x[t] <= limit)
            continue;
        totals.product *= x[t];
        totals.bits |= 4u << (t & 7);
    }
}

static void through_a_pointer(int n, double limit, struct totals *to) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        if (x[t] > limit) {
            to->count++;
        }
    }
}

static void write_all(double limit) {
    counter(N, limit);
    variables(N, limit);
    extrema(N, limit);
    in_a_loop(N, limit);
    members(N, limit);
    behind_continue(N, limit);
    through_a_pointer(N, limit, &totals);
}

static void print(void) {
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    const struct totals *of = &totals;
    printf("%d %d %a %a %d %a %ld %ld\n", errors, few, highest, lowest, place, (double)narrow, all_bits,
           some_bits);
    printf("%a %a %ld %u %d %d %d %d\n", of->sum, of->product, of->count, of->bits, of->list[1],
           of->list[2], first_or_last, last_or_first);
}

/* Meanwhile another thread counts under its lock, which the loop need not know. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static volatile int is_over;

static void *count(void *argument) {
    while (!is_over) {
        pthread_mutex_lock(&lock);
        errors++;
        totals.count++;
        ++*(long *)argument;
        pthread_mutex_unlock(&lock);
    }
    return NULL;
}

int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = (int)((t * 7919LL + t / 3) % K);
        x[t] = 1.0 + (t * 31 % 997) * 0.01;
    }
    if (hold(PROT_READ))
        return 1;
    write_all(1e9);
    through_a_pointer(N, 1e9, NULL);
    if (hold(PROT_READ | PROT_WRITE))
        return 1;
    print();
    write_all(10.5);
    write_all(-1);
    print();

    pthread_t other;
    long counted = 0;
    const int before = errors;
    const long before_count = totals.count;
    if (pthread_create(&other, NULL, count, &counted))
        return 1;
    for (int round = 0; round < 40; round++) {
        counter(N, 1e9);
        members(N, 1e9);
    }
    is_over = 1;
    pthread_join(other, NULL);
    printf("%ld %ld\n", errors - before - counted, totals.count - before_count - counted);
    return 0;
}
