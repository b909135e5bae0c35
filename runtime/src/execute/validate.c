/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/validate.h"

#include "base/memory.h"
#include "base/trace.h"
#include "execute/compensate.h"
#include "plan/elements.h"
#include "plan/plan.h"

#include <assert.h>
#include <float.h>
#include <math.h> /* for HUGE_VAL; no function is used, since the library does not link to libm */
#include <stdio.h>
#include <string.h>

static size_t bytes_of(const struct plan *plan, uint32_t group) {
    const struct offsets touched = plan->touched[group];
    const bool some = plan->group_of[group] == group && touched.first < touched.end;
    return some ? (size_t)(touched.end - touched.first) : 0;
}

static void give_back(struct validation *validation) {
    for (uint32_t i = 0; validation->held && i < validation->count; i++)
        redcc_memory_free(validation->held[i].memory);
    redcc_memory_free(validation->held);
    *validation = (struct validation){0};
}

static void give_up(struct validation *validation) {
    give_back(validation);
    validation->gave_up = true;
}

static void begin(struct validation *validation, uint32_t count, const char *method) {
    validation->held = redcc_memory_alloc_zeroed(count, sizeof *validation->held);
    validation->began = validation->held != NULL;
    validation->gave_up = !validation->began;
    validation->method = method;
    validation->count = count;
}

/* Extends the saved range to `bytes` bytes at `place`. False: out of memory. */
static bool hold(struct held *held, char *place, size_t bytes) {
    char *memory = redcc_memory_alloc(bytes);
    if (!memory)
        return false;
    memcpy(memory, place, bytes);
    if (held->memory) /* the loop has written to this range since it was saved */
        memcpy(memory + (held->place - place), held->memory, held->bytes);
    redcc_memory_free(held->memory);
    held->memory = memory;
    held->place = place;
    held->bytes = bytes;
    return true;
}

/* If one of `count` arrays is scattered, gives up and counts the execution. */
static bool pass_over(struct validation *validation, uint32_t count, void *const *bases,
                      struct validated *validated) {
    for (uint32_t array = 0; array < count; array++)
        if (redcc_is_scattered(bases[array])) {
            validation->gave_up = true;
            validated->passed_over++;
            return true;
        }
    return false;
}

void redcc_validation_begin(struct validation *validation, const struct plan *plan,
                            void *const *bases, struct validated *validated) {
    if (pass_over(validation, plan->array_count, bases, validated))
        return;
    begin(validation, plan->array_count, plan->method->name);
    for (uint32_t group = 0; validation->began && group < plan->array_count; group++) {
        const size_t bytes = bytes_of(plan, group);
        struct held *held = &validation->held[group];
        held->in_order = plan->method->keeps == REDCC_ORDER_SERIAL &&
                         !(plan->rounding && plan->rounding[group].value);
        if (bytes > 0 && !hold(held, (char *)bases[group] + plan->touched[group].first, bytes))
            give_up(validation);
    }
}

void redcc_validation_grow(struct validation *validation, const redcc_loop *loop,
                           void *const *bases, struct written written,
                           struct validated *validated) {
    assert(written.array < loop->array_count);
    if (validation->gave_up || written.bytes.first >= written.bytes.end)
        return;
    if (!validation->began && !pass_over(validation, loop->array_count, bases, validated))
        begin(validation, loop->array_count, "binning");
    if (!validation->began)
        return;
    struct held *held = &validation->held[written.array];
    const struct range before =
        held->memory ? (struct range){(uintptr_t)held->place, (uintptr_t)held->place + held->bytes}
                     : written.bytes;
    const struct range all = redcc_range_union(before, written.bytes);
    held->in_order = written.in_order;
    if (held->memory && all.first == before.first && all.end == before.end)
        return;
    if (!hold(held, (char *)all.first, all.end - all.first))
        give_up(validation);
}

void redcc_validation_swap(struct validation *validation) {
    for (uint32_t i = 0; i < validation->count; i++) {
        struct held *held = &validation->held[i];
        for (size_t at = 0; held->memory && at < held->bytes; at++) {
            const char now = held->place[at];
            held->place[at] = held->memory[at];
            held->memory[at] = now;
        }
    }
}

/* ---- differences --------------------------------------------------------------------------- */

/* Defines a function for the distance between two floating-point values, in steps from one
 * representable value to the next; infinite if only one of them is NaN. The bits of non-negative
 * values, read as integers, have the order of the values; those of negative values have the reverse
 * order. */
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

/* The difference in units in the last place (ulps). For types that are not floating-point types, it
 * is 0 or infinite. */
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

/* Do the two elements differ in bits that count? Two NaNs of type float or double do not differ,
 * and the padding of a long double does not count. */
static bool differ(redcc_type type, size_t size, const char *p, const char *q) {
    const size_t counted = type == REDCC_LONG_DOUBLE && LDBL_MANT_DIG == 64 ? 10 : size;
    return memcmp(p, q, counted) != 0 && !(is_nan(type, p) && is_nan(type, q));
}

/* ---- the comparison ------------------------------------------------------------------------ */

static size_t element_size(const redcc_array *array) {
    const struct element_rule *rule = redcc_element_rule(array->operation, array->type);
    return rule ? rule->size : array->element;
}

/* Compares one array. Returns whether the result is as promised. */
static bool compare(const struct held *held, const redcc_array *array, const void *base,
                    struct validated *validated) {
    const size_t size = element_size(array);
    const bool bits_are_promised = held->in_order || array->type <= REDCC_UINT64;
    bool kept = true;
    for (size_t at = 0; at + size <= held->bytes; at += size) {
        const char *found = held->memory + at, *expected = held->place + at;
        if (!differ(array->type, size, found, expected))
            continue;
        const double off = ulps(array->type, size, found, expected);
        if (off > validated->largest) {
            validated->largest = off;
            validated->array = array->name;
            validated->element = (expected - (const char *)base) / (ptrdiff_t)size;
        }
        kept = kept && !bits_are_promised;
    }
    return kept;
}

void redcc_validation_end(struct validation *validation, const redcc_loop *loop, void *const *bases,
                          struct validated *validated) {
    assert(validation->count <= loop->array_count);
    bool kept = true;
    struct validated now = {.largest = 0};
    for (uint32_t i = 0; i < validation->count; i++) {
        struct held *held = &validation->held[i];
        if (!held->memory)
            continue;
        kept = compare(held, &loop->arrays[i], bases[i], &now) && kept;
        memcpy(held->place, held->memory, held->bytes);
    }
    redcc_trace(TRACE_VALIDATION, loop, "%s by %s: largest difference %.4g ulps%s%s",
                kept ? "as promised" : "the promise is broken", validation->method, now.largest,
                now.array ? " in " : "", now.array ? now.array : "");
    validated->executions++;
    validated->broken += !kept;
    if (now.largest > validated->largest) {
        validated->largest = now.largest;
        validated->element = now.element;
        snprintf(validated->name, sizeof validated->name, "%s", now.array);
    }
    give_back(validation);
}
