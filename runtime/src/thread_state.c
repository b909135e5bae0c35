/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The members of a loop: made once, used by every execution. */
#include "loop.h"

#include "base/memory.h"

static struct member *member_new(struct loop_state *state, const redcc_loop *loop, int thread) {
    struct member *member = redcc_memory_take_zeroed(1, sizeof *member);
    if (!member)
        return NULL;
    member->execution = &state->execution;
    member->thread = thread;
    member->node = -1;
    member->sources = redcc_memory_take_zeroed(loop->source_count, sizeof *member->sources);
    member->base = redcc_memory_take_zeroed(loop->array_count, sizeof *member->base);
    member->owner = redcc_memory_take_zeroed(loop->array_count, sizeof *member->owner);
    member->fingerprint = redcc_memory_take_zeroed(loop->source_count, sizeof *member->fingerprint);
    member->taking = redcc_memory_take_zeroed(loop->source_count, sizeof *member->taking);
    member->hooks.hook = redcc_memory_take_zeroed(loop->array_count, sizeof *member->hooks.hook);
    return member;
}

static void member_free(struct member *member) {
    if (!member)
        return;
    redcc_memory_give(member->sources);
    redcc_memory_give(member->base);
    redcc_memory_give(member->owner);
    redcc_memory_give(member->fingerprint);
    redcc_memory_give(member->taking);
    redcc_memory_give(member->hooks.hook);
    redcc_memory_give(member);
}

bool redcc_members_ensure(struct loop_state *state, const redcc_loop *loop, int count) {
    if (count <= state->member_count)
        return true;
    struct member **more = redcc_memory_resize(state->member, (size_t)count * sizeof(*more));
    if (!more)
        return false;
    state->member = more;
    while (state->member_count < count) {
        struct member *member = member_new(state, loop, state->member_count);
        if (!member || !member->sources || !member->base || !member->owner ||
            !member->fingerprint || !member->taking || !member->hooks.hook) {
            member_free(member);
            return false;
        }
        state->member[state->member_count++] = member;
    }
    return true;
}

void redcc_members_end(struct loop_state *state) {
    for (int thread = 0; thread < state->member_count; thread++)
        member_free(state->member[thread]);
    redcc_memory_give(state->member);
    state->member = NULL;
    state->member_count = 0;
}

void redcc_inspection_end(struct execution *execution) {
    const struct loop_state *state = execution->state;
    for (int thread = 0; thread < state->member_count; thread++) {
        struct member *member = state->member[thread];
        redcc_sample_end(&member->sample);
        redcc_sweep_end(&member->sweep);
        redcc_memory_give(member->entries);
        redcc_memory_give(member->seen);
        redcc_memory_give(member->executed);
        member->entries = NULL;
        member->seen = NULL;
        member->executed = NULL;
    }
    redcc_divide_end(&execution->divide);
    redcc_levels_end(&execution->levels);
    redcc_partition_end(&execution->partition);
    redcc_memory_give(execution->samples);
    redcc_memory_give(execution->summaries);
    redcc_memory_give(execution->seen);
    execution->samples = NULL;
    execution->summaries = NULL;
    execution->seen = NULL;
}

void redcc_meet(struct member *member, void (*alone)(struct execution *)) {
    struct execution *execution = member->execution;
    if (redcc_barrier_arrive(&execution->barrier, member->threads)) {
        alone(execution);
        redcc_barrier_release(&execution->barrier);
    }
    member->phase = execution->next;
}
