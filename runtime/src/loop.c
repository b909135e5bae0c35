/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The lifetime of a loop's state: it is created, acquired by one execution at a time, and freed.
 */
#include "loop.h"

#include "base/memory.h"
#include "bins/binning.h"
#include "settings.h"
#include "unmade.h"

#include <assert.h>

static void state_free(struct loop_state *state) {
    if (!state)
        return;
    struct execution *execution = &state->execution;
    struct request *request = &execution->call.request;
    redcc_cache_drop_all(&state->cache);
    redcc_sections_end(&state->sections);
    redcc_threads_end(state);
    redcc_memory_free(request->bases);
    redcc_memory_free(request->known);
    redcc_memory_free(request->key);
    redcc_partition_end(&execution->inspection.partition);
    redcc_memory_free(execution->inspection.touched);
    redcc_memory_free(execution->inspection.sources);
    redcc_fences_free(&execution->run.fences);
    redcc_survey_free(&execution->run.survey);
    redcc_memory_free(state->binning.known);
    redcc_memory_free(state->reported.file);
    redcc_memory_free(state->reported.function);
    redcc_memory_free(atomic_load(&state->reported.statistics.why.unlinked));
    redcc_memory_free(state);
}

/* Sets the pointers that connect the parts of an execution. */
static void join_parts(struct loop_state *state) {
    struct execution *execution = &state->execution;
    struct inspection *inspection = &execution->inspection;
    execution->state = state;
    inspection->call = execution->run.call = execution->reuse.call = &execution->call;
    inspection->barrier = execution->run.barrier = execution->reuse.barrier = &execution->barrier;
    execution->reuse.cache = &state->cache;
    execution->reuse.sources = inspection->sources;
    execution->reuse.written = inspection->touched;
    state->binning.call = &execution->call;
    state->binning.barrier = &execution->barrier;
    state->binning.effects.last_claimed = &execution->run.last_claimed;
    state->binning.effects.error = &execution->run.error;
}

/* The method that is named for the loop. A plan for localwrite exists for every loop with an
 * inspector, and every loop without one has a form for bins. */
static struct named_for_loop named_for(const redcc_loop *loop) {
    return (struct named_for_loop){.method = redcc_settings_for(loop)->method,
                                   .able = !(loop->flags & REDCC_NO_INSPECTOR)
                                               ? &redcc_method_localwrite
                                           : redcc_binned_of(loop) ? &redcc_method_binning
                                                                   : NULL};
}

static struct loop_state *state_new(redcc_loop *loop) {
    struct loop_state *state = redcc_memory_alloc_zeroed(1, sizeof *state);
    if (!state)
        return NULL;
    struct inspection *inspection = &state->execution.inspection;
    struct request *request = &state->execution.call.request;
    request->loop = loop;
    request->bases = redcc_memory_alloc(loop->array_count * sizeof *request->bases);
    request->known = redcc_memory_alloc(loop->source_count * sizeof *request->known);
    request->key = redcc_memory_alloc(loop->key_count * sizeof *request->key);
    inspection->touched = redcc_memory_alloc(loop->array_count * sizeof *inspection->touched);
    inspection->sources = redcc_memory_alloc(loop->source_count * sizeof *inspection->sources);
    state->reported.file = redcc_memory_copy_text(loop->file);
    state->reported.function = redcc_memory_copy_text(loop->function);
    state->reported.line = loop->line;
    state->reported.statistics.why.named = named_for(loop);
    join_parts(state);
    if (!redcc_bins_new(&state->binning, loop) ||
        !redcc_fences_new(&state->execution.run.fences, loop) || !request->bases ||
        !request->known || !request->key || !inspection->touched || !inspection->sources ||
        !state->reported.file || !state->reported.function) {
        state_free(state);
        return NULL;
    }
    return state;
}

struct loop_state *redcc_state_of(redcc_loop *loop) {
    void *state = __atomic_load_n(&loop->state, __ATOMIC_ACQUIRE);
    if (!redcc_is_unmade(state))
        return state;
    redcc_memory_exempt(true);
    struct loop_state *mine = state_new(loop);
    redcc_memory_exempt(false);
    if (!mine)
        return NULL;
    while (!__atomic_compare_exchange_n(&loop->state, &state, mine, 0, __ATOMIC_ACQ_REL,
                                        __ATOMIC_ACQUIRE))
        if (!redcc_is_unmade(state)) {
            state_free(mine);
            return state;
        }
    redcc_report_add(&mine->reported);
    return mine;
}

struct loop_state *redcc_made_state_of(redcc_loop *loop) {
    void *state = __atomic_load_n(&loop->state, __ATOMIC_ACQUIRE);
    return redcc_is_unmade(state) ? NULL : state;
}

void redcc_loop_make(redcc_loop *loop) {
    redcc_state_of(loop);
}

void redcc_loop_forget(redcc_loop *loop) {
    struct loop_state *state = redcc_made_state_of(loop);
    loop->state = NULL;
    if (!state)
        return;
    redcc_report_remove(&state->reported);
    state_free(state);
}

struct loop_state *redcc_loop_acquire(struct loop_state *state, redcc_loop *loop, bool always,
                                      enum reason *reason) {
    assert(!state->temporary);
    int idle = 0;
    if (atomic_compare_exchange_strong_explicit(&state->busy, &idle, 1, memory_order_acquire,
                                                memory_order_relaxed))
        return state;
    *reason = REASON_CONCURRENT;
    if (!always)
        return NULL;
    *reason = REASON_NO_MEMORY;
    struct loop_state *other = state_new(loop);
    if (other)
        other->temporary = true;
    return other;
}

void redcc_loop_release(struct loop_state *state) {
    if (state->temporary)
        state_free(state);
    else {
        assert(atomic_load(&state->busy) == 1);
        atomic_store_explicit(&state->busy, 0, memory_order_release);
    }
}
