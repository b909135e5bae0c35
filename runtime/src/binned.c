/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The pipeline's stage for binned loops. It calls bins/, and hands over to the other stages. */
#include "loop.h"

#include "base/clock.h"

#include <assert.h>
#include <errno.h>

/* Called after the last round. From then on redcc_next hands out, to the first thread only, the
 * iterations that were not binned, or the loop's repetition for validation. */
static void end(struct thread_state *thread, redcc_worker *worker) {
    struct execution *execution = thread->execution;
    const struct binning *binning = &execution->state->binning;
    const redcc_int trip = execution->call.request.trip;
    const redcc_int binned = binning->round.begin;
    const bool begun = binned > 0;
    /* else operands in blocks would be mixed with others */
    assert(!redcc_in_shares(&execution->call) || !begun || binned == trip);
    if (thread->thread == 0 && begun && execution->run.validation.began)
        redcc_run_check(worker, binned);
    else
        redcc_run_rest(worker, thread->thread == 0 && begun ? binned : trip);
    if (thread->thread > 0)
        return;
    execution->binned = begun;
    execution->reason = binning->reason;
    execution->inspection.overlap = binning->overlap;
}

void redcc_hold_written(void *execution, uint32_t array, struct range written) {
    struct execution *it = execution;
    redcc_validation_grow(&it->run.validation, it->call.request.loop, it->call.request.bases,
                          (struct written){array, written, !redcc_in_shares(&it->call)},
                          it->run.validated);
}

/* The first thread executes the iterations of a stretch between two rounds. The other threads wait
 * for it at the beginning of the next round. */
static void stretch(struct thread_state *thread, redcc_worker *worker) {
    const struct round *round = &thread->execution->state->binning.round;
    const redcc_int begin = thread->thread == 0 ? round->begin : round->end;
    redcc_run_stretch(worker, begin, round->end);
}

/* Restores the thread's state after redcc_next has handed out the iterations of a stretch. */
static void resume(struct thread_state *thread) {
    thread->runner.step = STEP_BEGIN;
    redcc_float_control_take(thread->execution->call.float_control);
}

int redcc_bins_next(redcc_worker *worker, redcc_bins *bins, const void *operands) {
    struct thread_state *thread = worker->execution;
    if (!thread || thread->stage != STAGE_BINS)
        return 0;
    const bool resumes = thread->binner->phase == BINS_STRETCH;
    if (resumes)
        resume(thread);
    if (thread->runner.step != STEP_BEGIN)
        return 0;
    struct execution *execution = thread->execution;
    struct run *run = &execution->run;
    if (worker->last == 0 && !resumes) { /* the first call of this execution */
        errno = 0;
        if (thread->thread == 0)
            run->ready = redcc_seconds();
    } else if (errno) {
        redcc_note_error(run, worker->last);
    }
    if (redcc_bins_step(&execution->state->binning, thread->binner, worker, bins, operands)) {
        for (uint32_t s = 0; s < execution->state->binning.loop->stream_count; s++)
            bins[s].calls = worker->call->calls;
        worker->variant = (redcc_variant){.operands = redcc_call_operands(&execution->call)};
        return REDCC_TO_PUSH;
    }
    if (thread->binner->phase != BINS_STRETCH) {
        end(thread, worker);
        return 0;
    }
    stretch(thread, worker);
    return REDCC_TO_EXECUTE;
}
