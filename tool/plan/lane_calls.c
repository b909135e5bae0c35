/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/lane_calls.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/library.h"
#include "plan/lanes.h"
#include "plan/work.h"

enum { MOST_DEPTH = 8, MANY = 1000000 };

/** Bits for the values of errno after a failing call: EDOM, ERANGE. */
enum { DOMAIN = 1, RANGE = 2 };

static bool is_among(const char *const *names, size_t count, const char *name) {
    for (size_t i = 0; i < count; i++)
        if (strcmp(names[i], name) == 0)
            return true;
    return false;
}

/** The values of errno that a call of the function may set (C17 7.12). */
static unsigned errors_of(const ir_unit *unit, const ir_function *callee) {
    static const char *const domain[] = {"sqrt", "sqrtf", "cos", "cosf", "sin", "sinf"};
    static const char *const range[] = {"exp",  "expf",  "exp2",  "exp2f",
                                        "cosh", "coshf", "hypot", "hypotf"};
    const library_function *library = library_find(unit, callee);
    if (library && !library->sets_errno)
        return 0;
    return is_among(domain, sizeof domain / sizeof *domain, callee->name) ? DOMAIN
           : is_among(range, sizeof range / sizeof *range, callee->name)  ? RANGE
                                                                          : DOMAIN | RANGE;
}

const char *lane_known_call(const ir_function *callee) {
    static const char *const known[] = {"sqrt", "fabs", "sqrtf", "fabsf"};
    return callee->is_from_system && !callee->linkage.is_renamed && !callee->body &&
                   is_among(known, sizeof known / sizeof *known, callee->name)
               ? callee->name
               : NULL;
}

bool lane_may_call(const ir_unit *unit, const ir_node *call) {
    const ir_function *callee = ir_called_function(call);
    const bool has_integer = callee && (strncmp(callee->name, "ldexp", 5) == 0 ||
                                        strncmp(callee->name, "scalb", 5) == 0);
    return callee && callee->is_from_system && !has_integer && library_find(unit, callee) &&
           lane_is_real(call->type) && call->child_count > 1;
}

/** Numbers of calls per iteration. Only calls of functions without a body in the file count, in the
 * loop and in the functions that it calls. */
typedef struct calls {
    int64_t failing;     /* calls that may set errno */
    int64_t by_lane;     /* calls without a vector form */
    unsigned errors;     /* the values that errno may get */
    const ir_node *last; /* the body's last call that may fail */
} calls;

static void add_calls(const lane_scope *l, const ir_node *node, int64_t times, int depth,
                      bool of_updates, calls *found) {
    assert(times >= 1 && times <= MANY);
    const ir_function *callee = node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION
                                    ? node->children[0]->function
                                    : NULL;
    if (node->kind == IR_CALL && depth == 0 && (lane_updating(l, node) != NULL) != of_updates)
        return;
    if (callee && callee->body && depth < MOST_DEPTH)
        add_calls(l, callee->body, times, depth + 1, of_updates, found);
    else if (node->kind == IR_CALL) {
        const unsigned errors =
            callee && !callee->body ? errors_of(l->plan->unit, callee) : DOMAIN | RANGE;
        found->errors |= errors;
        found->failing += errors ? times : 0;
        if (errors && depth == 0)
            found->last = node;
        found->by_lane += callee && lane_known_call(callee) ? 0 : times;
    }
    if (ir_is_loop(node)) {
        const int64_t trip = work_constant_trip(node);
        times = times * (trip ? trip : MANY) < MANY ? times * (trip ? trip : MANY) : MANY;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        add_calls(l, node->children[i], times, depth, of_updates, found);
}

void lane_check_errors(lane_scope *l) {
    calls computing = {0, 0, 0, NULL}, updating = {0, 0, 0, NULL};
    add_calls(l, l->body, 1, 0, false, &computing);
    add_calls(l, l->body, 1, 0, true, &updating);
    const bool in_both = computing.errors && updating.errors;
    if ((computing.errors | updating.errors) == (DOMAIN | RANGE) &&
        (in_both || computing.failing > 1))
        lane_problem(l, NO_LANES_CALL, computing.last ? computing.last : l->body);
}

int64_t lane_count_calls(const lane_scope *l) {
    calls computing = {0, 0, 0, NULL};
    add_calls(l, l->body, 1, 0, false, &computing);
    return computing.by_lane;
}
