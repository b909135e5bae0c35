/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/facts.h"

#include <assert.h>

const char *reduction_operator_spelling(reduction_operator op) {
    static const char *const spellings[] = {
#define X(NAME, SPELLING) [REDUCTION_##NAME] = SPELLING,
#include "analysis/base/operators.def"
#undef X
        [REDUCTION_NONE] = NULL};
    _Static_assert(sizeof spellings / sizeof *spellings == REDUCTION_NONE + 1, "all operators");
    assert(op <= REDUCTION_NONE);
    return spellings[op];
}
