/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compares the verdicts on the files of cases with their EXPECT comments. Usage: cases_test FILE...
 * Each file is analysed twice, and both results must be equal. */
#include <stdio.h>
#include <string.h>

#include "expectation.h"
#include "frontend/frontend.h"

static unsigned check_twice(arena *a, const ir_unit *unit, const analysis_result *first,
                            const analysis_options *options) {
    analysis_result second = analyse(a, unit, options);
    if (first->verdict_count != second.verdict_count)
        return 1;
    for (unsigned i = 0; i < second.verdict_count; i++)
        if (strcmp(expectation_describe(a, &first->verdicts[i]),
                   expectation_describe(a, &second.verdicts[i])) != 0)
            return 1;
    return 0;
}

static unsigned check_file(const char *path, bool is_verbose) {
    static const char *const flags[] = {"-std=gnu11"};
    const char *message = NULL;
    arena *a = arena_new();
    unsigned bad = 1;
    source *s = source_read(a, path, &message);
    frontend_result parsed = {0};
    if (s)
        parsed = frontend_parse(a, s, 1, flags);
    if (!parsed.unit) {
        fprintf(stderr, "%s: %s\n", path, message ? message : "cannot be parsed");
    } else {
        analysis_options options = expectation_options(a, s);
        analysis_result result = analyse(a, parsed.unit, &options);
        bad = expectation_check(a, parsed.unit, &result);
        if (check_twice(a, parsed.unit, &result, &options)) {
            fprintf(stderr, "%s: analysing it again gives another result\n", path);
            bad++;
        }
        for (unsigned i = 0; is_verbose && i < result.verdict_count; i++)
            printf("%s:%u: %s: %s%s%s\n", path,
                   source_position(s, result.verdicts[i].loop->range.begin).line,
                   result.verdicts[i].function->name, expectation_describe(a, &result.verdicts[i]),
                   result.verdicts[i].why.message ? ": " : "",
                   result.verdicts[i].why.message ? result.verdicts[i].why.message : "");
    }
    arena_free(a);
    return bad;
}

int main(int argc, char **argv) {
    unsigned bad = 0;
    bool is_verbose = argc > 1 && strcmp(argv[1], "-v") == 0;
    for (int i = is_verbose ? 2 : 1; i < argc; i++)
        bad += check_file(argv[i], is_verbose);
    if (bad)
        fprintf(stderr, "%u differences\n", bad);
    return bad != 0;
}
