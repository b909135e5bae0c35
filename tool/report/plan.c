/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Translated loops are in four classes: parallel, with a plan that is kept; parallel, with a plan
 * for each execution; parallel without a plan; executed sequentially. */
#include "report/plan.h"

#include <assert.h>

#include "analysis/base/expression.h"

/** The smallest number of short iterations that the runtime accepts (LEAST_TRIP in
 *  runtime/src/settings.c). */
enum { LEAST_TRIP = 1024 };

/** The number of iterations if it is constant, else -1. */
static int64_t constant_trip(const counted_loop *counted) {
    assert(counted->step != 0);
    int64_t lower, bound;
    if (!counted->lower || counted->stride || counted->counter->type->kind != IR_INTEGER ||
        !expression_constant(counted->lower, &lower) ||
        !expression_constant(counted->bound, &bound) || lower > INT32_MAX || lower < INT32_MIN ||
        bound > INT32_MAX || bound < INT32_MIN)
        return -1;
    const int64_t step = counted->step > 0 ? counted->step : -counted->step;
    int64_t distance = counted->step > 0 ? bound - lower : lower - bound;
    if (counted->comparison == IR_OP_LESS_EQUAL || counted->comparison == IR_OP_GREATER_EQUAL)
        distance++;
    return distance <= 0 ? 0 : (distance + step - 1) / step;
}

static plan_answer remade(arena *a, const loop_slice *slice) {
    const unkept_read *read = &slice->unkept;
    plan_answer answer = {.word = "remade", .range = read->range};
    if (slice->exits) {
        answer.cause = "an iteration may end the loop here, or print";
        answer.advice = "check the data in a loop of its own first";
        return answer;
    }
    if (!read->name) {
        answer.cause = "what decides which elements are updated cannot be compared";
        return answer;
    }
    answer.cause = arena_format(a,
                                "what is read of '%s' here decides which elements are updated, and "
                                "cannot be compared",
                                read->name);
    answer.advice = "compute the subscripts into an array of integers in a loop of its own first";
    return answer;
}

plan_answer verdict_plan(arena *a, const loop_verdict *verdict) {
    if (verdict->kind != VERDICT_TRANSFORM)
        return (plan_answer){0};
    const loop_facts *facts = verdict->facts;
    const int64_t trip = constant_trip(&facts->counted);
    if (facts->has_short_iterations && trip >= 0 && trip < LEAST_TRIP)
        return (plan_answer){
            .word = "never",
            .cause = arena_format(a, "it has %lld short iterations: too few for threads to gain",
                                  (long long)trip)};
    if (!facts->inspector.exists)
        return (plan_answer){.word = "none"};
    if (!facts->slice.is_verifiable)
        return remade(a, &facts->slice);
    return (plan_answer){.word = "kept"};
}
