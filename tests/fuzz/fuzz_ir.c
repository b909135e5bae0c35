/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A libFuzzer test of the reader of IR text; tests/fuzz/check-ir builds and runs it. Text that is
 * read, and that ir_check accepts, must be printed equally twice, and its analysis must not fail.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/analysis.h"
#include "ir_reader/ir_read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    arena *a = arena_new();
    const char *message = NULL;
    ir_unit *unit = ir_read(a, (const char *)data, size, &message);
    if (!unit && !message)
        abort(); /* refused without a message */
    if (unit && !ir_check(a, unit)) {
        buffer first = {0};
        buffer second = {0};
        ir_print(&first, unit);
        ir_unit *again = ir_read(a, first.data, first.length, &message);
        if (!again)
            abort();
        ir_print(&second, again);
        if (strcmp(first.data, second.data) != 0)
            abort();
        analyse(a, unit, NULL);
        buffer_free(&first);
        buffer_free(&second);
    }
    arena_free(a);
    return 0;
}
