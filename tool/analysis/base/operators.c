/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/facts.h"

const char *reduction_operator_spelling(reduction_operator op) {
    static const char *const spellings[] = {
#define X(NAME, SPELLING) [REDUCTION_##NAME] = SPELLING,
#include "analysis/base/operators.def"
#undef X
        [REDUCTION_NONE] = NULL};
    return spellings[op];
}
