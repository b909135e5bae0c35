/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* redcc with deliberate faults, linked with --wrap=emit_file: if the text generated for a loop
 * contains plants[].word, the first plants[].right in it is replaced by plants[].wrong. */
#define _GNU_SOURCE /* memmem */
#include <string.h>

#include "emit/emit.h"

emit_result __real_emit_file(arena *a, const ir_unit *unit, const analysis_result *analysis,
                             const plan_options *options);
emit_result __wrap_emit_file(arena *a, const ir_unit *unit, const analysis_result *analysis,
                             const plan_options *options);

static const struct {
    const char *word, *right, *wrong;
} plants[] = {
    {"plant: it does not compile", "int redcc__done", "int redcc__dome"},
    {"plant: another name", "REDCC_BASE(0, here)", "REDCC_BASE(0, hers)"},
    {"plant: another subscript", "(redcc_int)won, sizeof", "(redcc_int)two, sizeof"},
    {"plant: another subscript", "_ROW(0, hers, won)", "_ROW(0, hers, two)"},
    {"plant: only in front", "_ROW(0, hers, won)", "_ROW(0, hers, two)"},
    {"plant: another type of a value", "((int)((redcc_u32)", "(0l + ((redcc_u32)"},
    {"plant: another type", "struct near own = places", "struct afar own = places"},
};

static void spoil(char *text, size_t length) {
    for (size_t i = 0; i < sizeof plants / sizeof *plants; i++) {
        if (!memmem(text, length, plants[i].word, strlen(plants[i].word)))
            continue;
        char *at = memmem(text, length, plants[i].right, strlen(plants[i].right));
        if (at)
            memcpy(at, plants[i].wrong, strlen(plants[i].wrong));
    }
}

emit_result __wrap_emit_file(arena *a, const ir_unit *unit, const analysis_result *analysis,
                             const plan_options *options) {
    emit_result result = __real_emit_file(a, unit, analysis, options);
    char *text = (char *)arena_copy(a, result.text, result.length);
    for (unsigned i = 0; i < result.loop_count; i++)
        spoil(text + result.loops[i].begin, result.loops[i].end - result.loops[i].begin);
    result.text = text;
    return result;
}
