/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/compensate.h"

#include <assert.h>
#include <math.h>

static size_t share_begin(const struct plan *plan, const struct lost *lost, int thread) {
    return (size_t)redcc_share((redcc_int)lost->count, plan->threads, thread);
}

void redcc_lost_clear(const struct plan *plan, int thread, void *const *bases) {
    assert(0 <= thread && thread < plan->threads);
    for (uint32_t group = 0; group < plan->array_count; group++) {
        struct lost *lost = &plan->lost[group];
        const size_t end = share_begin(plan, lost, thread + 1);
        for (size_t i = share_begin(plan, lost, thread); lost->value && i < end; i++)
            lost->value[i] = 0;
        if (thread == 0)
            lost->first = (char *)bases[group] + lost->offset;
    }
}

static void bring_float(float *element, double lost) {
    *element = (float)((double)*element + lost);
}

static void bring_double(double *element, double lost) {
    *element += lost;
}

void redcc_lost_bring(const struct plan *plan, int thread) {
    assert(0 <= thread && thread < plan->threads);
    for (uint32_t group = 0; group < plan->array_count; group++) {
        const struct lost *lost = &plan->lost[group];
        const size_t end = share_begin(plan, lost, thread + 1);
        for (size_t i = share_begin(plan, lost, thread); lost->value && i < end; i++) {
            if (lost->value[i] == 0 || !isfinite(lost->value[i]))
                continue; /* an untouched element must not be written */
            if (lost->type == REDCC_FLOAT)
                bring_float((float *)(void *)lost->first + i, lost->value[i]);
            else
                bring_double((double *)(void *)lost->first + i, lost->value[i]);
        }
    }
}

/* The number of the element at `address`. */
static size_t number_of(const struct lost *lost, const void *address) {
    return (size_t)((const char *)address - lost->first) / redcc_lost_element(lost->type);
}

void redcc_lost_begin(const struct lost *lost, void *address, size_t count) {
    double *before = lost->before + number_of(lost, address);
    assert(number_of(lost, address) + count <= lost->count);
    if (lost->type == REDCC_FLOAT)
        for (size_t i = 0; i < count; i++) {
            before[i] = (double)((float *)address)[i];
            ((float *)address)[i] = -0.0f;
        }
    else
        for (size_t i = 0; i < count; i++) {
            before[i] = ((double *)address)[i];
            ((double *)address)[i] = -0.0;
        }
}

/* The rounding error of a + b = `sum` (Knuth's TwoSum). */
static double error_of(double a, double b, double sum) {
    const double b_part = sum - a, a_part = sum - b_part;
    return (a - a_part) + (b - b_part);
}

/* Each returns the rounding error. If nothing was added it is 0, and the element unchanged. */
static double add_to_float(float *element, double before) {
    const double value = (double)*element, sum = before + value;
    *element = (float)sum;
    return (sum - (double)*element) + error_of(before, value, sum);
}

static double add_to_double(double *element, double before) {
    const double value = *element;
    *element = before + value;
    return error_of(before, value, *element);
}

void redcc_lost_end(const struct lost *lost, void *address, size_t count) {
    const size_t first = number_of(lost, address);
    assert(first + count <= lost->count);
    for (size_t i = 0; i < count; i++) {
        const double before = lost->before[first + i];
        lost->value[first + i] += lost->type == REDCC_FLOAT
                                      ? add_to_float((float *)address + i, before)
                                      : add_to_double((double *)address + i, before);
    }
}
