/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "operands.h"

#include <assert.h>

#include "base/forked.h"
#include "base/memory.h"
#include "base/system.h"
#include "loop.h"
#include "series.h"
#include "settings.h"

/* Without REDCC_MEMORY_LIMIT, operands use at most a quarter of the machine's memory, since the
 * loop's arrays and plans need memory, too. */
static bool are_too_many(size_t bytes) {
    const uint64_t there = redcc_settings()->memory_limit ? 0 : redcc_system_memory();
    return there > 0 && bytes > there / 4;
}

void *redcc_operands_take(redcc_loop *loop, redcc_int trip, redcc_size size) {
    if (trip <= 0)
        return NULL;
    (void)redcc_is_forked(); /* must precede any use of the parent's memory */
    const bool fits = (redcc_size)trip <= SIZE_MAX / 4 / size;
    assert(size > 0);
    void *operands =
        fits && !are_too_many((size_t)trip * size) ? redcc_memory_take((size_t)trip * size) : NULL;
    if (!operands)
        redcc_note_no_memory(loop);
    return operands;
}

void redcc_operands_give(void *operands) {
    redcc_memory_give(operands);
}

bool redcc_operands_take_all(redcc_loop *loop, const redcc_attempt *attempt) {
    bool is_there = true;
    for (redcc_u32 i = 0; i < attempt->operand_count; i++) {
        attempt->operands[i] =
            is_there ? redcc_operands_take(loop, attempt->trip, attempt->operand_bytes[i]) : NULL;
        is_there = attempt->operands[i];
    }
    for (redcc_u32 i = 0; i < attempt->series_count; i++) {
        attempt->series[i] = is_there ? redcc_series_take(loop, attempt->trip) : NULL;
        is_there = attempt->series[i];
    }
    if (!is_there)
        redcc_operands_give_all(attempt);
    return is_there;
}

void redcc_operands_give_all(const redcc_attempt *attempt) {
    for (redcc_u32 i = 0; i < attempt->operand_count; i++)
        redcc_operands_give(attempt->operands[i]);
    for (redcc_u32 i = 0; i < attempt->series_count; i++)
        redcc_series_give(attempt->series[i]);
}
