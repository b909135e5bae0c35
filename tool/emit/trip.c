/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Computes the trip count exactly as in the sequential loop.
 *
 * The counter takes the values lower, lower + step, ... while (counter <comparison> bound) holds,
 * in the type that C's usual conversions give the comparison. Everything is computed in redcc_int
 * (64 bits, signed). In some cases the count is set to 0, or a condition on the counter's final
 * value fails, so that the original loop runs: if the loop wraps around or never ends; if it
 * compares differently in an unsigned type than in redcc_int; if a variable stride is less than 1;
 * if a do loop has a single iteration because its first value does not satisfy the condition.
 *
 * If each iteration begins with the step (steps_at_start), the count is computed from the counter's
 * value before the loop, redcc__entry, as if the step came last. redcc__lower is one step further.
 */
#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "emit/call.h"
#include "emit/text/origin.h"
#include "plan/lookup.h"

enum {
    INT_SIZE = 4, /* size of an int on every target with OpenMP */
    WIDE_SIZE = 8 /* redcc_int */
};

/** If adding a step could overflow, the loop runs sequentially when the absolute value of lower or
 * bound is greater than this. */
static const char limit[] = "((redcc_int)1 << 61)";

typedef struct integer_type {
    bool is_signed;
    int64_t size;
} integer_type;

static bool is_address(const ir_type *type) {
    return type->kind == IR_POINTER || type->kind == IR_ARRAY;
}

static integer_type promote(const ir_type *type) {
    if (is_address(type))
        return (integer_type){false, WIDE_SIZE};
    if (type->kind == IR_BOOLEAN || type->size < INT_SIZE)
        return (integer_type){true, INT_SIZE};
    return (integer_type){type->is_signed, type->size};
}

/** C's usual arithmetic conversions (C17 6.3.1.8), by size: equal sizes count as equal ranks. */
static integer_type common_type(integer_type a, integer_type b) {
    if (a.size != b.size)
        return a.size > b.size ? a : b;
    return (integer_type){a.is_signed && b.is_signed, a.size};
}

/** Is every value of `inner` a value of `outer`? */
static bool holds_all(const ir_type *outer, const ir_type *inner) {
    if (inner->kind == IR_BOOLEAN)
        return true;
    if (outer->is_signed == inner->is_signed)
        return outer->size >= inner->size;
    return outer->is_signed && outer->size > inner->size;
}

static bool is_constant(const ir_node *node) {
    return node && (node->flags & IR_HAS_VALUE);
}

/** Is the node a constant >= 0 that conversion to `type` does not change? */
static bool is_natural_constant(const ir_node *node, const ir_type *type) {
    if (!is_constant(node) || node->value < 0)
        return false;
    const int64_t bits = 8 * type->size - (type->is_signed ? 1 : 0);
    return bits >= 63 || node->value >> bits == 0;
}

/** Conditions joined by &&. */
typedef struct conditions {
    buffer text;
} conditions;

static void require(conditions *list, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static void require(conditions *list, const char *format, ...) {
    char text[128];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    buffer_text(&list->text, list->text.length > 0 ? " && " : "");
    buffer_text(&list->text, text);
}

/** Facts about the header, computed once. */
typedef struct header {
    const counted_loop *counted;
    const ir_type *counter;
    const ir_type *bound;
    bool compares_unsigned;
    bool compares_wide; /* the comparison is in 64 bits */
    bool ascends;
    bool inclusive;
    const char *first;     /* the name of the value with which the count begins */
    const char *stride;    /* |step| as text, or NULL if it is 1 */
    bool lower_is_natural; /* lower is a constant >= 0 */
    bool ends_at_bound;    /* the counter's value after the loop is the bound itself */
} header;

static header header_of(arena *a, const counted_loop *counted) {
    assert(counted->step != 0 && (!counted->stride || counted->step == 1 || counted->step == -1));
    header h = {
        .counted = counted, .counter = counted->counter->type, .bound = counted->bound->type};
    const integer_type common = common_type(promote(h.counter), promote(h.bound));
    h.compares_unsigned = !common.is_signed;
    h.compares_wide = common.size == WIDE_SIZE;
    h.ascends = counted->step > 0;
    h.inclusive =
        counted->comparison == IR_OP_LESS_EQUAL || counted->comparison == IR_OP_GREATER_EQUAL;
    const int64_t step = h.ascends ? counted->step : -counted->step;
    h.stride = counted->stride ? "redcc__stride"
               : step == 1     ? NULL
                               : arena_format(a, "%lld", (long long)step);
    h.first = counted->steps_at_start ? "redcc__entry" : "redcc__lower";
    h.lower_is_natural = !counted->steps_first && is_natural_constant(counted->lower, h.counter);
    h.ends_at_bound = !h.stride && !h.inclusive;
    return h;
}

/** Adds the conditions under which the difference of lower and bound does not overflow. */
static void require_of_ends(conditions *list, const header *h) {
    const bool lower_may_be_negative =
        !h->lower_is_natural && (h->counter->is_signed || h->counter->size == WIDE_SIZE);
    const bool bound_is_natural = is_natural_constant(h->counted->bound, h->bound);
    if (h->compares_unsigned && lower_may_be_negative)
        require(list, "%s >= 0", h->first);
    if (h->compares_unsigned && h->compares_wide && !h->ascends && !bound_is_natural)
        require(list, "redcc__bound >= 0");
    const bool is_simple = h->ends_at_bound && !h->counted->ahead &&
                           (h->ascends ? h->lower_is_natural : bound_is_natural);
    if (!h->compares_wide || is_simple)
        return;
    const char *low = h->ascends ? h->first : "redcc__bound";
    const char *high = h->ascends ? "redcc__bound" : h->first;
    if (!h->compares_unsigned && !(h->ascends ? h->lower_is_natural : bound_is_natural))
        require(list, "%s >= -%s", low, limit);
    require(list, "%s <= %s", high, limit);
}

/** Adds conditions on the counter's value after the loop. */
static void require_of_final(conditions *list, const header *h, const char *counter_type) {
    if (h->counted->ends_below && !h->counter->is_signed)
        return; /* the loop ends when a step below 0 wraps around */
    if (h->compares_unsigned && !h->ascends && !h->ends_at_bound)
        require(list, "redcc__final >= 0");
    const bool bound_fits =
        holds_all(h->counter, h->bound) && !(h->compares_unsigned && h->counter->is_signed);
    if (h->counter->size < WIDE_SIZE && !(h->ends_at_bound && bound_fits))
        require(list, "redcc__final == (%s)redcc__final", counter_type);
}

static const char *comparison_text(arena *a, const header *h) {
    return arena_format(a, "%s %c%s redcc__bound", h->first, h->ascends ? '<' : '>',
                        h->inclusive ? "=" : "");
}

/** Returns the trip count of a loop that iterates: span / stride + 1 if the bound is inclusive,
 * otherwise (span - 1) / stride + 1. `span` is the distance from lower to bound. If h->stride is
 * NULL, the stride is 1. */
static const char *count_text(arena *a, const header *h) {
    const char *span = h->ascends ? arena_format(a, "redcc__bound - %s", h->first)
                                  : arena_format(a, "%s - redcc__bound", h->first);
    if (!h->stride)
        return h->inclusive ? arena_format(a, "%s + 1", span) : span;
    return arena_format(a, h->inclusive ? "(%s) / %s + 1" : "(%s - 1) / %s + 1", span, h->stride);
}

static const char *final_text(arena *a, const header *h, const char *count) {
    const char *sign = h->ascends ? "+" : "-";
    if (!h->stride)
        return arena_format(a, "%s %s %s", h->first, sign, count);
    return arena_format(a, "%s %s %s * %s", h->first, sign, h->stride, count);
}

const char *counter_after(loop_text *loop) {
    const header h = header_of(loop->arena, &loop->facts->counted);
    if (!loop->continues)
        return "redcc__final";
    const char *value = final_text(loop->arena, &h, "redcc__made");
    return h.counted->steps_first /* the condition of the next iteration steps it again */
               ? arena_format(loop->arena, "%s %c (redcc__made < redcc__trip)", value,
                              h.ascends ? '-' : '+')
               : value;
}

static const char *first_text(loop_text *loop, const header *h) {
    const ir_node *lower = h->counted->lower;
    if (!lower)
        return arena_format(loop->arena, "(redcc_int)%s",
                            origin_variable(loop->arena, h->counted->counter));
    const char *text = loop_operand(loop, lower);
    if (h->lower_is_natural && lower->kind == IR_NUMBER)
        return text;
    if (lower->type->kind != IR_FLOATING && holds_all(h->counter, lower->type))
        return arena_format(loop->arena, "(redcc_int)%s", text);
    return arena_format(loop->arena, "(redcc_int)(%s)%s", loop->counter_type, text);
}

/** The counter's value in the first iteration, or before a step at its start. */
static const char *lower_text(loop_text *loop, const header *h) {
    const char *first = first_text(loop, h);
    return h->counted->steps_first ? arena_format(loop->arena, "(redcc_int)((redcc_word)%s %c 1)",
                                                  first, h->ascends ? '+' : '-')
                                   : first;
}

static const char *users_bound_text(loop_text *loop, const header *h) {
    const char *text = loop_operand(loop, h->counted->bound);
    if (!h->compares_unsigned || !promote(h->bound).is_signed || is_constant(h->counted->bound))
        return arena_format(loop->arena, "(redcc_int)%s", text);
    return arena_format(loop->arena, "(redcc_int)(%s)%s",
                        h->compares_wide ? "redcc_word" : "redcc_u32", text);
}

/* Returns the value with which the counter is compared: for `counter + ahead < bound`, this is
 * bound - ahead. If the subtraction wraps around, the result exceeds `limit`. */
static const char *bound_text(loop_text *loop, const header *h) {
    const char *text = users_bound_text(loop, h);
    return h->counted->ahead == 0 ? text
                                  : arena_format(loop->arena, "(redcc_int)((redcc_word)%s - %lld)",
                                                 text, (long long)h->counted->ahead);
}

/** Writes the trip count. A variable stride is evaluated only if the loop would evaluate it. */
static void write_count(loop_text *loop, writer *out, const header *h, const char *ends) {
    const char *count = count_text(loop->arena, h);
    const loop_exits *exits = loop->facts->slice.exits;
    if (!h->counted->stride) {
        writer_line(out,
                    exits && exits->open ? "redcc__trip = %s ? REDCC_OPEN(%s) : 0;"
                                         : "redcc__trip = %s ? %s : 0;",
                    ends, count);
        return;
    }
    writer_line(out, "redcc__stride = %s ? (redcc_int)%s : 0,", ends,
                loop_operand(loop, h->counted->stride));
    writer_line(out, "redcc__trip = redcc__stride > 0 && redcc__stride <= %s ? %s : 0;", limit,
                count);
}

/** Declares the counter's value in the first iteration if its step is at the start. There need not
 * be an iteration; hence the arithmetic in words. */
static void write_first_value(writer *out, const header *h) {
    if (h->counted->steps_at_start)
        writer_line(out,
                    "const redcc_int redcc__lower = (redcc_int)((redcc_word)redcc__entry %c "
                    "(redcc_word)%s);",
                    h->ascends ? '+' : '-', h->stride ? h->stride : "1");
}

const char *write_trip_count(loop_text *loop, writer *out, const char *site) {
    const header h = header_of(loop->arena, &loop->facts->counted);
    conditions ends = {0};
    require_of_ends(&ends, &h);
    require(&ends, "%s", comparison_text(loop->arena, &h));
    const bool counts_up =
        !h.stride && h.ascends && strcmp(ends.text.data, "redcc__lower < redcc__bound") == 0;
    const bool is_open = loop->facts->slice.exits && loop->facts->slice.exits->open;
    if (counts_up && !h.inclusive && !is_open) {
        writer_line(out, "REDCC_COUNT_UP(%s, %s);",
                    macro_argument(loop->arena, lower_text(loop, &h)),
                    macro_argument(loop->arena, bound_text(loop, &h)));
    } else {
        writer_line(out, "const redcc_int %s = %s,", h.first, lower_text(loop, &h));
        writer_line(out, "redcc__bound = %s,", bound_text(loop, &h));
        write_count(loop, out, &h, ends.text.data);
        write_first_value(out, &h);
    }
    buffer_free(&ends.text);

    conditions entry = {0};
    require(&entry, "REDCC_IS_WORTH%s(%s, redcc__trip)",
            loop->facts->has_short_iterations ? "_LIGHT" : "", site);
    const size_t before = entry.text.length;
    require_of_final(&entry, &h, loop->counter_type);
    if (counts_up && !is_open)
        ; /* REDCC_COUNT_UP has declared redcc__final */
    else if (entry.text.length > before || has_affine_extents(loop) ||
             (counter_outlives(loop->facts) && !loop->continues))
        writer_line(out, "const redcc_int redcc__final = %s;",
                    final_text(loop->arena, &h, "redcc__trip"));
    return buffer_take(loop->arena, &entry.text);
}
