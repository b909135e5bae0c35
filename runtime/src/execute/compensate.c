/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/compensate.h"

#include "base/memory.h"

#include <math.h>

static size_t size_of(redcc_type type) {
    return type == REDCC_FLOAT ? sizeof(float) : sizeof(double);
}

/* Is array `array` one that can be a group's, or lie in it, in step? */
static bool fits(const struct plan *plan, const redcc_array *arrays, uint32_t group,
                 uint32_t array) {
    const redcc_array *it = &arrays[array], *lead = &arrays[group];
    const size_t size = size_of(lead->type);
    return it->operation == REDCC_SUM && it->type == lead->type && it->element == size &&
           it->unit % size == 0 && plan->shift[array] % (ptrdiff_t)size == 0;
}

static bool is_compensated(const struct plan *plan, const redcc_array *arrays, uint32_t group) {
    const struct offsets touched = plan->touched[group];
    const redcc_type type = arrays[group].type;
    if (plan->group_of[group] != group || touched.first >= touched.end ||
        (type != REDCC_FLOAT && type != REDCC_DOUBLE))
        return false;
    const ptrdiff_t size = (ptrdiff_t)size_of(type);
    bool all_fit = touched.first % size == 0 && touched.end % size == 0;
    for (uint32_t array = 0; array < plan->array_count; array++)
        if (plan->group_of[array] == group)
            all_fit = all_fit && fits(plan, arrays, group, array);
    return all_fit;
}

bool redcc_lost_new(struct plan *plan, const redcc_array *arrays) {
    plan->lost = redcc_memory_take_zeroed(plan->array_count, sizeof *plan->lost);
    if (!plan->lost)
        return false;
    for (uint32_t group = 0; group < plan->array_count; group++) {
        if (!is_compensated(plan, arrays, group))
            continue;
        struct lost *lost = &plan->lost[group];
        const struct offsets touched = plan->touched[group];
        *lost = (struct lost){.type = arrays[group].type, .offset = touched.first};
        lost->count = (size_t)(touched.end - touched.first) / size_of(lost->type);
        lost->value = redcc_memory_take(lost->count * sizeof *lost->value);
        lost->before = redcc_memory_take(lost->count * sizeof *lost->before);
        if (!lost->value || !lost->before)
            return false;
    }
    return true;
}

void redcc_lost_free(struct plan *plan) {
    for (uint32_t group = 0; plan->lost && group < plan->array_count; group++) {
        redcc_memory_give(plan->lost[group].value);
        redcc_memory_give(plan->lost[group].before);
    }
    redcc_memory_give(plan->lost);
    plan->lost = NULL;
}

size_t redcc_lost_bytes(const struct plan *plan) {
    size_t bytes = 0;
    for (uint32_t group = 0; plan->lost && group < plan->array_count; group++)
        bytes += redcc_memory_size(plan->lost[group].value) +
                 redcc_memory_size(plan->lost[group].before);
    return bytes;
}

static size_t share_begin(const struct plan *plan, const struct lost *lost, int thread) {
    return (size_t)redcc_share((redcc_int)lost->count, plan->threads, thread);
}

void redcc_lost_clear(const struct plan *plan, int thread, void *const *bases) {
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
    for (uint32_t group = 0; group < plan->array_count; group++) {
        const struct lost *lost = &plan->lost[group];
        const size_t end = share_begin(plan, lost, thread + 1);
        for (size_t i = share_begin(plan, lost, thread); lost->value && i < end; i++) {
            if (lost->value[i] == 0 || !isfinite(lost->value[i]))
                continue; /* what is not touched must not be written */
            if (lost->type == REDCC_FLOAT)
                bring_float((float *)(void *)lost->first + i, lost->value[i]);
            else
                bring_double((double *)(void *)lost->first + i, lost->value[i]);
        }
    }
}

/* The number of the element at `address`. */
static size_t number_of(const struct lost *lost, const void *address) {
    return (size_t)((const char *)address - lost->first) / size_of(lost->type);
}

void redcc_lost_begin(const struct lost *lost, void *address, size_t count) {
    double *before = lost->before + number_of(lost, address);
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

/* What a + b is off by when rounded to `sum` (Knuth's TwoSum). */
static double error_of(double a, double b, double sum) {
    const double b_part = sum - a, a_part = sum - b_part;
    return (a - a_part) + (b - b_part);
}

/* Each returns what is lost. Where nothing was added that is 0, and the element what it was. */
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
    for (size_t i = 0; i < count; i++) {
        const double before = lost->before[first + i];
        lost->value[first + i] += lost->type == REDCC_FLOAT
                                      ? add_to_float((float *)address + i, before)
                                      : add_to_double((double *)address + i, before);
    }
}
