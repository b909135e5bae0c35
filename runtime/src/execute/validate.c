/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/validate.h"

#include "base/memory.h"
#include "base/trace.h"
#include "execute/compensate.h"
#include "plan/elements.h"
#include "plan/plan.h"

#include <float.h>
#include <math.h> /* HUGE_VAL; the library is linked to libc alone */
#include <stdio.h>
#include <string.h>

static size_t bytes_of(const struct plan *plan, uint32_t group) {
    const struct offsets touched = plan->touched[group];
    const bool some = plan->group_of[group] == group && touched.first < touched.end;
    return some ? (size_t)(touched.end - touched.first) : 0;
}

static void give_back(struct validation *validation, const struct plan *plan) {
    for (uint32_t group = 0; validation->memory && group < plan->array_count; group++)
        redcc_memory_give(validation->memory[group]);
    redcc_memory_give(validation->memory);
    *validation = (struct validation){0};
}

static bool some_are_scattered(const struct plan *plan, void *const *bases) {
    for (uint32_t array = 0; array < plan->array_count; array++)
        if (redcc_is_scattered(bases[array]))
            return true;
    return false;
}

void redcc_validation_begin(struct validation *validation, const struct plan *plan,
                            void *const *bases, struct validated *validated) {
    if (some_are_scattered(plan, bases)) {
        validated->passed_over++;
        return;
    }
    validation->memory = redcc_memory_take_zeroed(plan->array_count, sizeof *validation->memory);
    validation->began = validation->memory != NULL;
    for (uint32_t group = 0; validation->began && group < plan->array_count; group++) {
        const size_t bytes = bytes_of(plan, group);
        if (bytes == 0)
            continue;
        validation->memory[group] = redcc_memory_take(bytes);
        validation->began = validation->memory[group] != NULL;
        if (validation->began)
            memcpy(validation->memory[group], (char *)bases[group] + plan->touched[group].first,
                   bytes);
    }
    if (!validation->began)
        give_back(validation, plan);
}

void redcc_validation_swap(struct validation *validation, const struct plan *plan,
                           void *const *bases) {
    for (uint32_t group = 0; group < plan->array_count; group++) {
        char *memory = validation->memory[group];
        char *array = (char *)bases[group] + plan->touched[group].first;
        for (size_t i = 0; memory && i < bytes_of(plan, group); i++) {
            const char held = array[i];
            array[i] = memory[i];
            memory[i] = held;
        }
    }
}

/* ---- differences --------------------------------------------------------------------------- */

/* How many floats, doubles lie from one to the other: their bits are numbered in order. */
#define STEPS(NAME, T, BITS, LOWEST)                                                               \
    static double NAME(const char *p, const char *q) {                                             \
        T a, b;                                                                                    \
        BITS i, j;                                                                                 \
        memcpy(&a, p, sizeof a);                                                                   \
        memcpy(&b, q, sizeof b);                                                                   \
        memcpy(&i, p, sizeof i);                                                                   \
        memcpy(&j, q, sizeof j);                                                                   \
        if (a != a || b != b)                                                                      \
            return a != a && b != b ? 0 : HUGE_VAL;                                                \
        i = i < 0 ? LOWEST - i : i;                                                                \
        j = j < 0 ? LOWEST - j : j;                                                                \
        return i > j ? (double)i - (double)j : (double)j - (double)i;                              \
    }
STEPS(float_steps, float, int32_t, INT32_MIN)
STEPS(double_steps, double, int64_t, INT64_MIN)

static double long_double_steps(const char *p, const char *q) {
    long double a, b;
    memcpy(&a, p, sizeof a);
    memcpy(&b, q, sizeof b);
    if (a != a || b != b)
        return a != a && b != b ? 0 : HUGE_VAL;
    if (a == b)
        return 0;
    const long double off = a > b ? a - b : b - a;
    const long double left = a < 0 ? -a : a, right = b < 0 ? -b : b;
    const long double size = left > right ? left : right;
    return (double)(off / LDBL_EPSILON / (size < LDBL_MIN ? LDBL_MIN : size));
}

static double larger(double a, double b) {
    return a > b ? a : b;
}

/* In units in the last place; of what has none, 0 or infinity. */
static double ulps(redcc_type type, size_t size, const char *p, const char *q) {
    switch (type) {
    case REDCC_FLOAT:
        return float_steps(p, q);
    case REDCC_DOUBLE:
        return double_steps(p, q);
    case REDCC_LONG_DOUBLE:
        return long_double_steps(p, q);
    case REDCC_FLOAT_COMPLEX:
        return larger(float_steps(p, q), float_steps(p + size / 2, q + size / 2));
    case REDCC_DOUBLE_COMPLEX:
        return larger(double_steps(p, q), double_steps(p + size / 2, q + size / 2));
    default:
        return memcmp(p, q, size) == 0 ? 0 : HUGE_VAL;
    }
}

static bool is_nan(redcc_type type, const char *p) {
    float f = 0;
    double d = 0;
    if (type == REDCC_FLOAT)
        memcpy(&f, p, sizeof f);
    if (type == REDCC_DOUBLE)
        memcpy(&d, p, sizeof d);
    return f != f || d != d;
}

/* Do the two differ in a bit that counts? Not in those of numbers that are none, nor in the padding
 * of a long double. */
static bool differ(redcc_type type, size_t size, const char *p, const char *q) {
    const size_t counted = type == REDCC_LONG_DOUBLE && LDBL_MANT_DIG == 64 ? 10 : size;
    return memcmp(p, q, counted) != 0 && !(is_nan(type, p) && is_nan(type, q));
}

/* ---- the comparison ------------------------------------------------------------------------ */

static size_t element_size(const redcc_array *array) {
    const struct element_rule *rule = redcc_element_rule(array->operation, array->type);
    return rule ? rule->size : array->element;
}

/* Does a difference, however small, break the promise? */
static bool bits_are_promised(const struct plan *plan, uint32_t group, redcc_type type) {
    if (type <= REDCC_UINT64)
        return true;
    const bool compensated = plan->lost && plan->lost[group].value;
    return plan->method->keeps == REDCC_ORDER_SERIAL && !compensated;
}

/* Compares one group; returns whether its promise is kept. */
static bool compare(const struct plan *plan, uint32_t group, const redcc_array *array,
                    const char *found, const char *expected, struct validated *validated) {
    const size_t size = element_size(array), bytes = bytes_of(plan, group);
    bool kept = true;
    for (size_t at = 0; at + size <= bytes; at += size) {
        if (!differ(array->type, size, found + at, expected + at))
            continue;
        const double off = ulps(array->type, size, found + at, expected + at);
        if (off > validated->largest) {
            validated->largest = off;
            validated->array = array->name;
            validated->element = (plan->touched[group].first + (ptrdiff_t)at) / (ptrdiff_t)size;
        }
        kept = kept && !bits_are_promised(plan, group, array->type);
    }
    return kept;
}

void redcc_validation_end(struct validation *validation, const struct plan *plan,
                          const redcc_loop *loop, void *const *bases, struct validated *validated) {
    bool kept = true;
    struct validated now = {.largest = 0};
    for (uint32_t group = 0; group < plan->array_count; group++) {
        char *array = (char *)bases[group] + plan->touched[group].first;
        const char *found = validation->memory[group];
        if (!found)
            continue;
        kept = compare(plan, group, &loop->arrays[group], found, array, &now) && kept;
        memcpy(array, found, bytes_of(plan, group));
    }
    redcc_trace(TRACE_VALIDATION, loop, "%s by %s: largest difference %.4g ulps%s%s",
                kept ? "as promised" : "the promise is broken", plan->method->name, now.largest,
                now.array ? " in " : "", now.array ? now.array : "");
    validated->executions++;
    validated->broken += !kept;
    if (now.largest > validated->largest) {
        validated->largest = now.largest;
        validated->element = now.element;
        snprintf(validated->name, sizeof validated->name, "%s", now.array);
    }
    give_back(validation, plan);
}
