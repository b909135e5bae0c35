/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "operands.h"

#include <assert.h>

#include "base/forked.h"
#include "base/memory.h"
#include "base/system.h"
#include "loop.h"
#include "series.h"
#include "settings.h"

size_t redcc_operands_most_bytes(void) {
    const uint64_t memory = redcc_settings()->memory_limit ? 0 : redcc_system_memory();
    return memory > 0 && memory < SIZE_MAX ? (size_t)memory / 4 : SIZE_MAX / 4;
}

/* Allocates memory for an operand of `size` bytes per iteration. Returns NULL if the trip count is
 * not positive, or if memory runs out, which is reported. */
static void *alloc_operand(redcc_loop *loop, redcc_int trip, redcc_size size) {
    if (trip <= 0)
        return NULL;
    (void)redcc_is_forked(); /* must precede any use of memory that the parent process allocated */
    assert(size > 0);
    const bool fits = (redcc_size)trip <= redcc_operands_most_bytes() / size;
    void *operands = fits ? redcc_memory_alloc((size_t)trip * size) : NULL;
    if (!operands)
        redcc_note_no_memory(loop);
    return operands;
}

bool redcc_operands_alloc_all(redcc_loop *loop, const redcc_attempt *attempt) {
    bool is_there = true;
    for (redcc_u32 i = 0; i < attempt->operand_count; i++) {
        attempt->operands[i] =
            is_there ? alloc_operand(loop, attempt->trip, attempt->operand_bytes[i]) : NULL;
        is_there = attempt->operands[i];
    }
    for (redcc_u32 i = 0; i < attempt->series_count; i++) {
        attempt->series[i] = is_there ? redcc_series_alloc(loop, attempt->trip) : NULL;
        is_there = attempt->series[i];
    }
    if (!is_there)
        redcc_operands_free_all(attempt);
    return is_there;
}

void redcc_operands_free_all(const redcc_attempt *attempt) {
    for (redcc_u32 i = 0; i < attempt->operand_count; i++)
        redcc_memory_free(attempt->operands[i]);
    for (redcc_u32 i = 0; i < attempt->series_count; i++)
        redcc_series_free(attempt->series[i]);
}
