/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * DWA-LIP with a result that does not depend on the number of threads, because the arrays are
 * always cut into N blocks. Each element gets its contributions in the order of the stages of
 * figure 10 of the paper (dwa_lip.c), and within a stage in the order of the loop.
 *
 * There are no barriers: all iterations of one pair (Bmin, deltaB) are a task, which is executed by
 * the thread to which block Bmin belongs. Each thread executes its tasks in the order of the
 * stages. For each of its blocks, a task waits for the last task before it, in this order, that
 * writes the block.
 */
#include "plan/methods/dwa_lip.h"

#include "base/memory.h"

#include <stdlib.h>

enum { USUAL = 64, MOST = 1024 };

static int parse(const char *text) {
    char *end;
    const long blocks = strtol(text, &end, 10);
    return end != text && *end == '\0' && blocks >= 1 && blocks <= MOST ? (int)blocks : 0;
}

static uint32_t owners(int threads, int parameter) {
    (void)threads;
    return (uint32_t)parameter;
}

static uint32_t flags(uint32_t blocks) {
    return blocks * blocks;
}

/* A thread's data about all pairs. The number of a pair is Bmin * blocks + deltaB. */
struct view {
    uint32_t blocks;
    uint32_t first, end;   /* the blocks [first, end) belong to the thread */
    bool *filled;          /* [blocks * blocks] does the pair have any iterations? */
    struct schedule *pair; /* [(end - first) * blocks] the iterations of the thread's own pairs */
    uint32_t *latest;      /* [blocks] 1 + the last pair that writes the block; 0: none so far */
    uint32_t *wait;        /* [waits] the tasks for which the current task waits */
    uint32_t waits;        /* at most `blocks` */
};

static bool own(const struct view *view, uint32_t lowest) {
    return view->first <= lowest && lowest < view->end;
}

static bool take_pair(void *context, uint32_t lowest, uint32_t delta, redcc_int begin,
                      redcc_int count) {
    struct view *view = context;
    view->filled[lowest * view->blocks + delta] = true;
    if (!own(view, lowest))
        return true;
    struct schedule *pair = &view->pair[(lowest - view->first) * view->blocks + delta];
    return redcc_schedule_add(pair, 0, begin, count, false);
}

/* Lists the tasks of other threads that this pair must wait for: for each of its blocks, the last
 * task that wrote it. Called for pairs in the order of the stages. A task that wrote several blocks
 * may be listed more than once, which does no harm. */
static void find_waits(struct view *view, uint32_t lowest, uint32_t delta) {
    uint32_t before = 0;
    view->waits = 0;
    for (uint32_t block = lowest; block <= lowest + delta; block++) {
        const uint32_t last = view->latest[block];
        if (last != 0 && last != before && !own(view, (last - 1) / view->blocks))
            view->wait[view->waits++] = last - 1;
        before = last;
        view->latest[block] = 1 + lowest * view->blocks + delta;
    }
}

static bool add_task(struct view *view, struct schedule *schedule, uint32_t lowest,
                     uint32_t delta) {
    const struct schedule *pair = &view->pair[(lowest - view->first) * view->blocks + delta];
    if (!redcc_schedule_begin_task(schedule, view->wait, view->waits) ||
        !redcc_schedule_append(schedule, pair, 0))
        return false;
    redcc_schedule_end_task(schedule, lowest * view->blocks + delta);
    return true;
}

static bool put_in_order(struct view *view, struct schedule *schedule) {
    for (uint32_t delta = 0; delta < view->blocks; delta++)
        for (uint32_t stage = 0; stage <= delta; stage++)
            for (uint32_t lowest = stage; lowest + delta < view->blocks; lowest += delta + 1) {
                if (!view->filled[lowest * view->blocks + delta])
                    continue;
                find_waits(view, lowest, delta);
                if (own(view, lowest) && !add_task(view, schedule, lowest, delta))
                    return false;
            }
    return true;
}

static bool alloc_tables(struct view *view) {
    const size_t blocks = view->blocks;
    view->filled = redcc_memory_alloc_zeroed(blocks * blocks, sizeof *view->filled);
    view->pair = redcc_memory_alloc_zeroed((view->end - view->first) * blocks, sizeof *view->pair);
    view->latest = redcc_memory_alloc_zeroed(blocks, sizeof *view->latest);
    view->wait = redcc_memory_alloc(blocks * sizeof *view->wait);
    return view->filled && view->pair && view->latest && view->wait;
}

static void free_tables(struct view *view) {
    const size_t pairs = (size_t)(view->end - view->first) * view->blocks;
    for (size_t p = 0; view->pair && p < pairs; p++)
        redcc_schedule_end(&view->pair[p]);
    redcc_memory_free(view->filled);
    redcc_memory_free(view->pair);
    redcc_memory_free(view->latest);
    redcc_memory_free(view->wait);
}

static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    struct schedule *schedule = &plan->schedule[thread];
    struct view view = {.blocks = plan->owners,
                        .first = redcc_part_first(plan->owners, plan->threads, thread),
                        .end = redcc_part_first(plan->owners, plan->threads, thread + 1)};
    bool enough = alloc_tables(&view);
    for (int from = 0; enough && from < evidence->threads; from++)
        enough = redcc_visit_pairs(evidence, from, take_pair, &view);
    enough = enough && put_in_order(&view, schedule);
    if (enough && !evidence->every_iteration && thread == evidence->threads - 1 &&
        redcc_last_touches_nothing(evidence))
        enough = redcc_schedule_begin_task(schedule, NULL, 0) &&
                 redcc_schedule_add(schedule, 0, evidence->trip - 1, 1, false);
    free_tables(&view);
    redcc_schedule_finish(schedule);
    return enough;
}

const struct method redcc_method_dwa_lip_fixed = {.name = "dwa-lip-fixed",
                                                  .parameter = "N",
                                                  .keeps = REDCC_ORDER_FIXED,
                                                  .parse = parse,
                                                  .usual = USUAL,
                                                  .owners = owners,
                                                  .flags = flags,
                                                  .prepare = prepare};
