/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inspection, the phases in which all touches are told once more and kept: for owners cut from the
 *  access graph (graph/divide.h), or for iterations in levels (graph/levels.h). */
#include "inspect/inspect.h"

#include "choose/budget.h"

#include <string.h>

static const double uneven = 1.25;       /* of an equal share of the iterations */
static const double shorter = 0.9;       /* than by the owners that were cut */
static const double level_touch = 20e-9; /* seconds that putting in levels takes for a touch */

/* Units of the leading array for each thread. If they are rows of a mesh, spare parts cost 1 %. */
enum { LEAST_UNITS_WITH_SPARES = 32768 };

/* About how many touches of leading or of further groups a thread will tell, by the sample. */
static size_t expected_touches(const struct member *member, bool leading) {
    const struct execution *execution = member->execution;
    const struct partition *partition = &execution->partition;
    double touches = 0, iterations = 1;
    for (int thread = 0; thread < execution->threads; thread++) {
        const struct sample *sample = &execution->state->member[thread]->sample;
        for (size_t i = 0; i < sample->count; i++)
            if ((partition->group_of[sample->item[i].array] == partition->leader) == leading)
                touches += (double)sample->keep_each;
        iterations += sample->iterations;
    }
    const double share = (double)(redcc_own_end(member) - redcc_own_begin(member));
    const double expected = share * (touches / iterations) * 1.02;
    return (size_t)expected + (size_t)share / 16;
}

/* Owners by address will do, or what is chosen without the graph. False: make that plan. */
static bool go_on_without(struct execution *execution) {
    if (execution->method && execution->method->in_levels) {
        redcc_refuse(execution, REASON_LEVELS);
        return true;
    }
    if (execution->method) {
        execution->chosen =
            execution->method->spares ? &redcc_method_spare_localwrite : &redcc_method_localwrite;
        return false;
    }
    execution->by_graph = false;
    redcc_choose_no_graph(&execution->state->chooser, execution->request.trip);
    redcc_choose_and_go_on(execution);
    return true;
}

bool redcc_begin_gathering(struct execution *execution) {
    switch (redcc_divide_begin(&execution->divide, &execution->partition, execution->touched,
                               execution->threads, execution->request.trip)) {
    case DIVIDE_NO_MEMORY:
        redcc_refuse(execution, REASON_NO_MEMORY);
        return true;
    case DIVIDE_UNSUITABLE:
        return go_on_without(execution);
    case DIVIDE_DONE:
        break;
    }
    execution->divide.barrier = &execution->barrier;
    if (execution->chosen->in_levels) /* whatever they take: the method was named */
        execution->divide.most_told = (size_t)REDCC_NO_UNIT / (size_t)execution->threads;
    execution->next = PHASE_GATHER;
    return true;
}

void redcc_gather(struct member *member) {
    struct divide *divide = &member->execution->divide;
    member->failed = !redcc_told_begin(
        &divide->told[member->thread], &divide->units, divide->partition, redcc_own_begin(member),
        expected_touches(member, true), expected_touches(member, false), divide->most_told);
    for (uint32_t array = 0; array < divide->partition->array_count; array++)
        member->owner[array] = (redcc_owner){.first = 0}; /* all touches are entered */
    member->handed = 0;
    member->phase = PHASE_GATHERING;
}

/* The iterations of an owner lie scattered over the loop. */
static bool spares_are_worth(const struct execution *execution, double share, double spared) {
    const struct estimate found = {.share = share, .spared = spared, .changes = 1};
    return redcc_choose_spares(&execution->state->chooser, execution->request.trip,
                               execution->threads, &found);
}

/* auto: tries spare owners where parts are large; what they cost is seen when they are there. */
static void add_spares(struct execution *execution) {
    struct partition *partition = &execution->partition;
    const uint32_t threads = (uint32_t)execution->threads;
    if (execution->method || partition->spares || partition->room > REDCC_OWNERS_MOST ||
        execution->divide.units.leading / threads < LEAST_UNITS_WITH_SPARES ||
        !spares_are_worth(execution, 1.0 / threads, 0))
        return;
    redcc_partition_add_spares(partition);
    execution->chosen = &redcc_method_spare_graph_localwrite;
}

static void after_gathering(struct execution *execution) {
    const struct divide *divide = &execution->divide;
    bool failed = false, too_much = false;
    for (int thread = 0; thread < execution->threads; thread++) {
        const struct member *member = execution->state->member[thread];
        const struct told *told = &divide->told[thread];
        failed = failed || member->failed || told->failed;
        too_much = too_much || told->too_much ||
                   told->iterations != redcc_own_end(member) - redcc_own_begin(member);
    }
    execution->next = PHASE_DIVIDE;
    if (failed)
        redcc_refuse(execution, REASON_NO_MEMORY);
    else if (!too_much)
        add_spares(execution);
    else if (!go_on_without(execution))
        redcc_make_plan(execution);
}

int redcc_gathering(redcc_worker *worker) {
    struct member *member = worker->execution;
    const redcc_int begin = redcc_own_begin(member), end = redcc_own_end(member);
    if (!member->failed && member->handed == 0 && begin < end) {
        member->handed = end - begin;
        return redcc_hand_out(worker, begin, end, 1, member->owner);
    }
    if (member->handed > 0)
        redcc_flush(worker);
    redcc_meet(member, after_gathering);
    return 0;
}

static bool begin_levels(struct execution *execution) {
    return redcc_levels_begin(&execution->levels, execution->divide.told, execution->threads,
                              execution->request.loop->flags & REDCC_EVERY_ITERATION);
}

/* Alone: each iteration's level depends on those before it. */
static void put_in_levels(struct execution *execution) {
    if (begin_levels(execution)) {
        redcc_divide_tidy(&execution->divide);
        redcc_make_plan(execution);
    } else {
        redcc_refuse(execution, REASON_NO_MEMORY);
    }
}

/* auto: the owners that were cut leave one thread this share of the iterations. Would it be quicker
 * by levels? If so they are there. */
static bool levels_serve_better(struct execution *execution, double share) {
    const double all = (double)execution->request.trip;
    if (execution->method || share * execution->threads <= uneven ||
        redcc_budget() < execution->touches * all * (redcc_graph_touch + level_touch))
        return false;
    return begin_levels(execution) &&
           redcc_levels_length(&execution->levels, execution->threads) < shorter * share * all;
}

/* auto: are the spare owners that were tried not worth what they cost? Then all join them to those
 * that they are behind. */
static bool goes_without_spares(struct execution *execution) {
    struct partition *partition = &execution->partition;
    if (execution->method || !partition->spares)
        return false;
    const redcc_int with = redcc_executed_in_all(execution);
    redcc_int without = 0;
    for (int thread = 0; thread < execution->threads; thread++)
        without += redcc_sweep_executed(&execution->divide.sweep[thread], 1 + partition->spares);
    const double trip = (double)execution->request.trip;
    if (spares_are_worth(execution, (double)without / execution->threads / trip,
                         (double)(with - without) / trip))
        return false;
    redcc_partition_join_spares(partition);
    execution->chosen = &redcc_method_graph_localwrite;
    execution->next = PHASE_JOIN;
    return true;
}

static void after_divide(struct execution *execution) {
    if (!execution->divide.going) {
        redcc_refuse(execution, REASON_NO_MEMORY);
        return;
    }
    if (goes_without_spares(execution))
        return;
    execution->divided = !levels_serve_better(execution, redcc_largest_share(execution));
    if (!execution->divided) {
        execution->chosen = &redcc_method_wavefront;
        redcc_choose_levels(&execution->state->chooser, execution->request.trip);
    }
    redcc_divide_tidy(&execution->divide);
    redcc_make_plan(execution);
}

static void count_divided(struct member *member, enum divide_result result) {
    const struct execution *execution = member->execution;
    memset(member->executed, 0, execution->partition.owners * sizeof *member->executed);
    if (result == DIVIDE_DONE)
        redcc_sweep_count(&execution->divide.sweep[member->thread], member->executed);
    redcc_meet(member, after_divide);
}

void redcc_divide_share(struct member *member) {
    if (member->execution->chosen->in_levels) {
        redcc_meet(member, put_in_levels);
        return;
    }
    struct divide *divide = &member->execution->divide;
    count_divided(member, redcc_divide(divide, member->thread, member->seen));
}

void redcc_join_share(struct member *member) {
    struct divide *divide = &member->execution->divide;
    count_divided(member, redcc_divide_join(divide, member->thread, member->seen));
}
