/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/compensate.h"

#include <assert.h>
#include <math.h>

static size_t share_begin(const struct plan *plan, const struct rounding *rounding, int thread) {
    return (size_t)redcc_share((redcc_int)rounding->count, plan->threads, thread);
}

void redcc_rounding_clear(const struct plan *plan, int thread, void *const *bases) {
    assert(0 <= thread && thread < plan->threads);
    for (uint32_t group = 0; group < plan->array_count; group++) {
        struct rounding *rounding = &plan->rounding[group];
        const size_t end = share_begin(plan, rounding, thread + 1);
        for (size_t i = share_begin(plan, rounding, thread); rounding->value && i < end; i++)
            rounding->value[i] = 0;
        if (thread == 0)
            rounding->first = (char *)bases[group] + rounding->offset;
    }
}

static void add_float(float *element, double rounding) {
    *element = (float)((double)*element + rounding);
}

static void add_double(double *element, double rounding) {
    *element += rounding;
}

void redcc_rounding_add(const struct plan *plan, int thread) {
    assert(0 <= thread && thread < plan->threads);
    for (uint32_t group = 0; group < plan->array_count; group++) {
        const struct rounding *rounding = &plan->rounding[group];
        const size_t end = share_begin(plan, rounding, thread + 1);
        for (size_t i = share_begin(plan, rounding, thread); rounding->value && i < end; i++) {
            if (rounding->value[i] == 0 || !isfinite(rounding->value[i]))
                continue; /* an untouched element must not be written, and an infinite or NaN error
                             must not be added */
            if (rounding->type == REDCC_FLOAT)
                add_float((float *)(void *)rounding->first + i, rounding->value[i]);
            else
                add_double((double *)(void *)rounding->first + i, rounding->value[i]);
        }
    }
}

/* The index of the element at `address` in rounding->value. */
static size_t number_of(const struct rounding *rounding, const void *address) {
    return (size_t)((const char *)address - rounding->first) /
           redcc_rounding_element(rounding->type);
}

void redcc_rounding_begin(const struct rounding *rounding, void *address, size_t count) {
    double *before = rounding->before + number_of(rounding, address);
    assert(number_of(rounding, address) + count <= rounding->count);
    if (rounding->type == REDCC_FLOAT)
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

/* *element holds the contribution. Adds `before`, the element's saved value, to it and returns the
 * rounding error. If the contribution is the neutral element, the error is 0 and *element gets the
 * saved value. */
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

void redcc_rounding_end(const struct rounding *rounding, void *address, size_t count) {
    const size_t first = number_of(rounding, address);
    assert(first + count <= rounding->count);
    for (size_t i = 0; i < count; i++) {
        const double before = rounding->before[first + i];
        rounding->value[first + i] += rounding->type == REDCC_FLOAT
                                          ? add_to_float((float *)address + i, before)
                                          : add_to_double((double *)address + i, before);
    }
}
