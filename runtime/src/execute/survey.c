/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/survey.h"

#include "base/memory.h"
#include "base/share.h"

#include <assert.h>

static bool make_room(struct survey *survey, redcc_int blocks, int threads) {
    if (survey->room < blocks || survey->stops < threads) {
        redcc_survey_free(survey);
        *survey =
            (struct survey){.block = redcc_memory_alloc((size_t)blocks * sizeof *survey->block),
                            .is_open = redcc_memory_alloc((size_t)blocks * sizeof *survey->is_open),
                            .stop = redcc_memory_alloc((size_t)threads * sizeof *survey->stop)};
    }
    if (!survey->block || !survey->is_open || !survey->stop)
        return false;
    survey->room = redcc_max(survey->room, blocks);
    survey->stops = threads > survey->stops ? threads : survey->stops;
    return true;
}

void redcc_survey_begin(struct survey *survey, redcc_int trip, int threads,
                        struct barrier *barrier) {
    const redcc_int blocks = (trip + REDCC_SELECTED - 1) / REDCC_SELECTED;
    survey->stands = threads > 1 && blocks >= threads && make_room(survey, blocks, threads);
    survey->blocks = blocks;
    survey->threads = threads;
    survey->barrier = barrier;
}

void redcc_survey_free(struct survey *survey) {
    redcc_memory_free(survey->block);
    redcc_memory_free(survey->is_open);
    redcc_memory_free(survey->stop);
}

redcc_int redcc_survey_first(const struct survey *survey, int thread) {
    return redcc_share(survey->blocks, survey->threads, thread) * REDCC_SELECTED;
}

redcc_int redcc_survey_end(struct survey *survey, int thread, redcc_int stop) {
    assert(survey->stands && stop >= redcc_survey_first(survey, thread));
    survey->stop[thread] = stop;
    redcc_barrier_wait(survey->barrier, survey->threads);
    /* a thread that left no fence stops where the next share begins */
    int first = 0;
    while (first + 1 < survey->threads &&
           survey->stop[first] == redcc_survey_first(survey, first + 1))
        first++;
    return survey->stop[first];
}
