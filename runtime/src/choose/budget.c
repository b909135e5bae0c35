/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/budget.h"

#include "base/clock.h"
#include "base/spin.h"

static const double share = 0.02;

static struct spin lock;
static double begin; /* 0: not yet known */
static double gained;

/* When the program began, as far as it has been computing since. */
static double began(double now) {
    const struct timespec used = redcc_system_clock(CLOCK_PROCESS_CPUTIME_ID);
    return now - (double)used.tv_sec - 1e-9 * (double)used.tv_nsec;
}

double redcc_budget(void) {
    const double now = redcc_seconds();
    redcc_spin_lock(&lock);
    if (begin == 0)
        begin = began(now);
    const double left = share * (now - begin) + gained;
    redcc_spin_unlock(&lock);
    return left;
}

void redcc_budget_gain(double seconds) {
    redcc_spin_lock(&lock);
    gained += seconds;
    redcc_spin_unlock(&lock);
}
