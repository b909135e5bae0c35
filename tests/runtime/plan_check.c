/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan_check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Returns the owner of the byte at `offset` from the group's first element, according to the map of
 * its units. */
static uint32_t owner_in_map(const struct plan *plan, uint32_t group, ptrdiff_t offset) {
    const struct group_map *mapped = &plan->map.of[group];
    const ptrdiff_t unit = (offset - mapped->first) / (ptrdiff_t)mapped->bytes;
    assert_in_range(unit, 0, (ptrdiff_t)mapped->count - 1);
    const uint32_t owner = plan->map.owner[mapped->begin + (size_t)unit];
    assert_in_range(owner, 0, plan->owners - 1);
    return owner;
}

/* Returns the owner of the byte at `offset` from the array's first element; fails if there are
 * several. */
static uint32_t owner_at(const struct plan *plan, uint32_t array, ptrdiff_t offset) {
    const uint32_t group = plan->group_of[array];
    if (plan->map.owner)
        return owner_in_map(plan, group, offset + plan->shift[array]);
    const ptrdiff_t *bound = plan->bound + (size_t)group * (plan->owners + 1);
    uint32_t found = 0, count = 0;
    for (uint32_t owner = 0; owner < plan->owners; owner++)
        if (bound[owner] <= offset + plan->shift[array] &&
            offset + plan->shift[array] < bound[owner + 1]) {
            found = owner;
            count++;
        }
    assert_int_equal(count, 1);
    return found;
}

/* The stage and thread in which an iteration is executed, and how often. */
struct visit {
    int stage, thread, times;
};

static void record_visits(const struct plan *plan, struct visit *visit) {
    for (int thread = 0; thread < plan->threads; thread++) {
        const struct schedule *schedule = &plan->schedule[thread];
        for (size_t c = 0; c < schedule->chunk_count; c++) {
            struct run_reader runs = redcc_runs_of(schedule, &schedule->chunk[c]);
            for (redcc_iterations run; redcc_runs_read(&runs, &run, 1) > 0;) {
                assert_int_equal(run.count_and_check & 1, 0);
                for (redcc_u32 i = 0; i < run.count_and_check / 2; i++) {
                    struct visit *it = &visit[schedule->chunk[c].origin + run.begin + i];
                    *it = (struct visit){(int)schedule->chunk[c].stage, thread, it->times + 1};
                }
            }
        }
    }
}

/* Checks that iteration t updates the element after the iteration that updated it last. *last is 1
 * + that iteration's number, or 0 if there is none; afterwards t + 1. */
static void check_update(const struct visit *visit, long t, long *last) {
    const struct visit *before = *last > 0 ? &visit[*last - 1] : NULL;
    if (before && *last != t + 1 && before->stage >= visit[t].stage) {
        assert_int_equal(before->stage, visit[t].stage);
        assert_int_equal(before->thread, visit[t].thread);
    }
    *last = t + 1;
}

/* Checks a plan by levels: each iteration is executed once. Of two iterations that touch a common
 * element, the first is in an earlier stage, or precedes the second in the same thread. */
static void check_levels(const struct problem *problem, const struct plan *plan) {
    const size_t first = (size_t)problem->doubles;
    const size_t second = (size_t)problem->second_rows * (size_t)problem->second_width;
    struct visit *visit = calloc((size_t)problem->trip + 1, sizeof *visit);
    long *last = calloc(first + second + 1, sizeof *last);
    long *const last_second =
        problem->second_in_first ? last + (problem->second - problem->first) : last + first;
    record_visits(plan, visit);
    for (long t = 0; t < problem->trip; t++) {
        const bool idle = problem->start[t] == problem->start[t + 1] && t + 1 < problem->trip;
        assert_int_equal(visit[t].times, !idle);
        for (int k = problem->start[t]; k < problem->start[t + 1]; k++) {
            for (long c = 0; c < problem->width; c++)
                check_update(visit, t, &last[problem->row[k] * problem->width + c]);
            for (long c = 0; c < problem->second_width; c++)
                check_update(visit, t, &last_second[problem->other[k] * problem->second_width + c]);
        }
    }
    free(visit);
    free(last);
}

/* Marks the owners of the elements that iteration t writes; returns their number. */
static int mark_owners(const struct problem *problem, const struct plan *plan, long t, char *mark) {
    int count = 0;
    memset(mark, 0, plan->owners);
    for (int k = problem->start[t]; k < problem->start[t + 1]; k++)
        for (uint32_t array = 0; array < plan->array_count; array++) {
            const long width = array ? problem->second_width : problem->width;
            const long row = array ? problem->other[k] : problem->row[k];
            for (long c = 0; c < width; c++) {
                const uint32_t owner = owner_at(plan, array, 8 * (row * width + c));
                count += !mark[owner];
                mark[owner] = 1;
            }
        }
    return count;
}

static void mark_visits(const struct problem *problem, const struct plan *plan, char *visits,
                        char *checked) {
    for (uint32_t own = 0; own < plan->schedules; own++) {
        const struct schedule *schedule = &plan->schedule[own];
        redcc_int before = -1;
        for (size_t c = 0; c < schedule->chunk_count; c++) {
            const struct chunk *chunk = &schedule->chunk[c];
            if (c > 0 && chunk->stage != chunk[-1].stage)
                before = -1;
            struct run_reader runs = redcc_runs_of(schedule, chunk);
            for (redcc_iterations run; redcc_runs_read(&runs, &run, 1) > 0;) {
                redcc_int t = chunk->origin + run.begin;
                assert_true(run.count_and_check / 2 > 0);
                for (redcc_u32 i = 0; i < run.count_and_check / 2; i++, t++) {
                    assert_in_range(t, 0, problem->trip - 1);
                    if (plan->method->keeps == REDCC_ORDER_SERIAL)
                        assert_true(t > before);
                    before = t;
                    visits[t * plan->schedules + own]++;
                    checked[t * plan->schedules + own] = run.count_and_check & 1;
                }
            }
        }
    }
}

void check_plan(const struct problem *problem, const struct plan *plan) {
    assert_non_null(plan);
    if (plan->method->in_levels) {
        check_levels(problem, plan);
        return;
    }
    if (redcc_goes_without_schedules(plan->method))
        return;
    const size_t cells = (size_t)problem->trip * plan->schedules;
    char *visits = calloc(cells, 1), *checked = calloc(cells, 1);
    char *mark = calloc(plan->owners, 1);
    mark_visits(problem, plan, visits, checked);
    for (long t = 0; t < problem->trip; t++) {
        const int owners = mark_owners(problem, plan, t, mark);
        const char *visit = visits + t * plan->schedules,
                   *is_checked = checked + t * plan->schedules;
        int times = 0;
        for (uint32_t own = 0; own < plan->schedules; own++)
            times += visit[own];
        if (plan->method->keeps != REDCC_ORDER_SERIAL) {
            assert_true(times == 1 || (times == 0 && owners == 0 && t + 1 < problem->trip));
            continue;
        }
        if (owners == 0) {
            assert_int_equal(times, t + 1 == problem->trip);
            continue;
        }
        for (uint32_t own = 0; own < plan->schedules; own++) {
            assert_int_equal(visit[own], mark[own]);
            assert_true(is_checked[own] || !mark[own] || owners == 1);
        }
    }
    free(visits);
    free(checked);
    free(mark);
}
