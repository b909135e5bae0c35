/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Checks that functions of other files are linked to the definitions that were analysed. Each
 * object describes its functions and their addresses (redcc_record). The digests of the records are
 * compared with the loop's expectations, and the addresses with the targets of the calls. */
#include <assert.h>
#include <redcc/runtime.h>

#include <stdbool.h>
#include <string.h>

/* Maximum depth of nested calls. (Loops that call mutually recursive functions are not translated.)
 */
enum { MOST_DEEP = 64 };

static bool is_expected(const redcc_record *record, const redcc_expectation *expected,
                        redcc_size count) {
    for (redcc_size i = 0; i < count; i++)
        if (strcmp(expected[i].name, record->name) == 0)
            return expected[i].digest[0] == record->digest[0] &&
                   expected[i].digest[1] == record->digest[1];
    return false;
}

static bool are_linked(const redcc_callee *called, redcc_size count,
                       const redcc_expectation *expected, redcc_size expected_count, int depth) {
    for (redcc_size i = 0; i < count; i++) {
        const redcc_record *record = called[i].record;
        if (!record || record->own != called[i].called || depth >= MOST_DEEP ||
            !is_expected(record, expected, expected_count) ||
            !are_linked(record->callees, record->callee_count, expected, expected_count, depth + 1))
            return false;
    }
    return true;
}

int redcc_are_linked(const redcc_callee *called, redcc_size count,
                     const redcc_expectation *expected, redcc_size expected_count) {
    assert((called || count == 0) && (expected || expected_count == 0));
    return are_linked(called, count, expected, expected_count, 0);
}
