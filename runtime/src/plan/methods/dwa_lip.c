/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * DWA-LIP: data write affinity with loop-index prefetching, section 4.2.1 and figure 10 of
 * *Parallelization Issues of a Code for Physically-based Simulation of Fabrics* (docs/paper.md).
 * The arrays are cut into one block per thread. Bmin is the lowest block that an iteration writes,
 * and Bmin + deltaB the highest. If the blocks from Bmin to Bmin + deltaB of two pairs (Bmin,
 * deltaB) do not overlap, the iterations of these pairs are called write dissimilar, and may run in
 * parallel:
 *
 *     for deltaB = 0 .. blocks - 1
 *         for stage = 0 .. deltaB
 *             in parallel: for Bmin = stage, stage + deltaB + 1, stage + 2 (deltaB + 1), ...
 *                 execute the iterations of (Bmin, deltaB), in order
 *             barrier
 *
 * (In the figure, the loop over Bmin advances by deltaB. Then two successive pairs would share a
 * block, so here it advances by deltaB + 1.) Stages without iterations are left out.
 */
#include "plan/methods/dwa_lip.h"

#include <assert.h>

#include "base/memory.h"

/* The number of the stage, in the order above, to which the pair (Bmin, deltaB) belongs. `lowest`
 * is Bmin, and `delta` is deltaB. */
static uint32_t stage_of(uint32_t lowest, uint32_t delta) {
    return delta * (delta + 1) / 2 + lowest % (delta + 1);
}

/* One thread's iterations, sorted by their pair. */
struct pairs {
    uint32_t blocks;  /* total number of blocks */
    uint32_t members; /* number of threads of the team; block b belongs to thread number b % members
                         of the team */
    uint32_t member;
    struct schedule *pair; /* [(block / members) * blocks + deltaB] the iterations of each pair */
};

static uint32_t rounds(const struct pairs *pairs) {
    return (pairs->blocks + pairs->members - 1) / pairs->members;
}

bool redcc_visit_pairs(const struct evidence *evidence, int from, redcc_pair_taker *take,
                       void *context) {
    const struct summary *summary = evidence->summary[from];
    const struct sets *sets = &summary->sets;
    for (size_t b = 0; b < summary->block_count; b++) {
        const struct block *block = &summary->block[b];
        for (size_t s = block->span_begin; s < block->span_end; s++) {
            const struct span span = summary->span[s];
            const bool is_idle = span.set == 0;
            if (is_idle && !evidence->every_iteration)
                continue;
            const uint32_t lowest = is_idle ? 0 : redcc_set_minimum(sets, span.set);
            const uint32_t delta = is_idle ? 0 : redcc_set_maximum(sets, span.set) - lowest;
            assert(lowest + delta < sets->owners);
            if (!take(context, lowest, delta, block->origin + span.begin,
                      redcc_span_count(summary, block, s)))
                return false;
        }
    }
    return true;
}

static bool take_pair(void *context, uint32_t lowest, uint32_t delta, redcc_int begin,
                      redcc_int count) {
    struct pairs *pairs = context;
    if (lowest % pairs->members != pairs->member)
        return true;
    struct schedule *pair = &pairs->pair[lowest / pairs->members * pairs->blocks + delta];
    return redcc_schedule_add(pair, 0, begin, count, false);
}

static bool put_in_stages(const struct pairs *pairs, struct schedule *schedule) {
    for (uint32_t delta = 0; delta < pairs->blocks; delta++)
        for (uint32_t stage = 0; stage <= delta; stage++)
            for (uint32_t round = 0; round < rounds(pairs); round++) {
                const uint32_t lowest = round * pairs->members + pairs->member;
                const struct schedule *pair = &pairs->pair[round * pairs->blocks + delta];
                if (lowest % (delta + 1) == stage &&
                    !redcc_schedule_append(schedule, pair, stage_of(lowest, delta)))
                    return false;
            }
    return true;
}

bool redcc_dwa_lip_prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    const int team = redcc_team_of(plan->threads, plan->teams.count, thread);
    const int first = redcc_team_first(plan->threads, plan->teams.count, team);
    const int end = redcc_team_first(plan->threads, plan->teams.count, team + 1);
    assert(first <= thread && thread < end);
    struct pairs pairs = {.blocks = plan->owners,
                          .members = (uint32_t)(end - first),
                          .member = (uint32_t)(thread - first)};
    const size_t count = (size_t)rounds(&pairs) * pairs.blocks;
    pairs.pair = redcc_memory_alloc_zeroed(count, sizeof *pairs.pair);
    bool enough = pairs.pair != NULL;
    for (int from = first; enough && from < end; from++)
        enough = redcc_visit_pairs(evidence, from, take_pair, &pairs);
    if (enough && !evidence->every_iteration && thread == evidence->threads - 1 &&
        redcc_last_touches_nothing(evidence))
        enough = redcc_schedule_add(&pairs.pair[0], 0, evidence->trip - 1, 1, false);
    enough = enough && put_in_stages(&pairs, &plan->schedule[thread]);
    for (size_t p = 0; pairs.pair && p < count; p++)
        redcc_schedule_end(&pairs.pair[p]);
    redcc_memory_free(pairs.pair);
    redcc_schedule_finish(&plan->schedule[thread]);
    return enough;
}

const struct method redcc_method_dwa_lip = {
    .name = "dwa-lip", .keeps = REDCC_ORDER_ANY, .prepare = redcc_dwa_lip_prepare};
