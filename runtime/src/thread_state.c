/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The states of a loop's threads, which are allocated once and used in every execution. */
#include "loop.h"

#include "base/memory.h"

#include <assert.h>

static bool has_all(const struct thread_state *thread) {
    const bool binned = thread->execution->state->binning.loop;
    return (!binned || thread->binner) && thread->inspector.sources && thread->inspector.nowhere &&
           thread->runner.base && thread->runner.owner && thread->runner.hooks.hook &&
           thread->runner.selection.window && thread->hasher.fingerprint && thread->hasher.partial;
}

static void thread_free(struct thread_state *thread) {
    if (!thread)
        return;
    redcc_memory_free(thread->inspector.sources);
    redcc_memory_free(thread->inspector.nowhere);
    redcc_memory_free(thread->runner.base);
    redcc_memory_free(thread->runner.owner);
    redcc_memory_free(thread->runner.hooks.hook);
    redcc_memory_free(thread->runner.selection.window);
    redcc_memory_free(thread->hasher.fingerprint);
    redcc_memory_free(thread->hasher.partial);
    if (thread->binner)
        redcc_binner_free(thread->binner, thread->execution->state->binning.loop);
    redcc_memory_free(thread);
}

static struct thread_state *thread_new(struct loop_state *state, const redcc_loop *loop,
                                       int number) {
    const size_t arrays = loop->array_count, sources = loop->source_count;
    struct thread_state *thread = redcc_memory_alloc_zeroed(1, sizeof *thread);
    if (!thread)
        return NULL;
    struct inspector *inspector = &thread->inspector;
    struct runner *runner = &thread->runner;
    struct hasher *hasher = &thread->hasher;
    thread->execution = &state->execution;
    thread->node = -1;
    thread->thread = inspector->thread = runner->thread = hasher->thread = number;
    runner->run = &state->execution.run;
    inspector->sources = redcc_memory_alloc_zeroed(sources, sizeof *inspector->sources);
    inspector->nowhere = redcc_memory_alloc_zeroed(arrays, sizeof *inspector->nowhere);
    runner->base = redcc_memory_alloc_zeroed(arrays, sizeof *runner->base);
    runner->owner = redcc_memory_alloc_zeroed(arrays, sizeof *runner->owner);
    runner->selection.window = redcc_memory_alloc_zeroed(arrays, sizeof *runner->selection.window);
    runner->hooks.hook = redcc_memory_alloc_zeroed(arrays, sizeof *runner->hooks.hook);
    hasher->fingerprint = redcc_memory_alloc_zeroed(sources, sizeof *hasher->fingerprint);
    hasher->partial = redcc_memory_alloc_zeroed(sources, sizeof *hasher->partial);
    if (state->binning.loop)
        thread->binner = redcc_binner_new(state->binning.loop, number);
    if (has_all(thread))
        return thread;
    thread_free(thread);
    return NULL;
}

/* Enlarges the state's tables of pointers to `count` entries. */
static bool lengthen(struct loop_state *state, size_t count) {
    struct thread_state **thread = redcc_memory_resize(state->thread, count * sizeof(*thread));
    state->thread = thread ? thread : state->thread;
    struct inspector **inspector =
        redcc_memory_resize(state->inspector, count * sizeof(*inspector));
    state->inspector = inspector ? inspector : state->inspector;
    struct hasher **hasher = redcc_memory_resize(state->hasher, count * sizeof(*hasher));
    state->hasher = hasher ? hasher : state->hasher;
    struct binner **binner = redcc_memory_resize(state->binning.binner, count * sizeof(*binner));
    state->binning.binner = binner ? binner : state->binning.binner;
    return thread && inspector && hasher && binner;
}

bool redcc_threads_ensure(struct loop_state *state, const redcc_loop *loop, int count) {
    assert(count >= 1);
    if (count > state->thread_count && !lengthen(state, (size_t)count))
        return false;
    for (; state->thread_count < count; state->thread_count++) {
        struct thread_state *thread = thread_new(state, loop, state->thread_count);
        assert(!thread || thread->thread == state->thread_count);
        if (!thread)
            return false;
        state->thread[state->thread_count] = thread;
        state->inspector[state->thread_count] = &thread->inspector;
        state->hasher[state->thread_count] = &thread->hasher;
        state->binning.binner[state->thread_count] = thread->binner;
        state->binning.binners = state->thread_count + 1;
    }
    return true;
}

void redcc_threads_end(struct loop_state *state) {
    for (int thread = 0; thread < state->thread_count; thread++)
        thread_free(state->thread[thread]);
    redcc_memory_free(state->thread);
    redcc_memory_free(state->inspector);
    redcc_memory_free(state->hasher);
    redcc_memory_free(state->binning.binner);
    state->binning.binner = NULL;
    state->binning.binners = 0;
    state->thread = NULL;
    state->inspector = NULL;
    state->hasher = NULL;
    state->thread_count = 0;
}
