/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/budget.h"

#include "base/clock.h"

#include <pthread.h>

static const double share = 0.02;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static double begin; /* 0: not yet known */
static double gained;

/* When the program began, as far as it has been computing since. */
static double began(double now) {
    struct timespec used = {0};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return now - (double)used.tv_sec - 1e-9 * (double)used.tv_nsec;
}

double redcc_budget(void) {
    const double now = redcc_seconds();
    pthread_mutex_lock(&lock);
    if (begin == 0)
        begin = began(now);
    const double left = share * (now - begin) + gained;
    pthread_mutex_unlock(&lock);
    return left;
}

void redcc_budget_gain(double seconds) {
    pthread_mutex_lock(&lock);
    gained += seconds;
    pthread_mutex_unlock(&lock);
}
