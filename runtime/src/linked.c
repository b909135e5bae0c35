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

static const redcc_expectation *expectation_of(const redcc_linkage *linkage, const char *name) {
    for (redcc_size i = 0; i < linkage->expected_count; i++)
        if (strcmp(linkage->expected[i].name, name) == 0)
            return &linkage->expected[i];
    return NULL;
}

static bool is_expected(const redcc_record *record, const redcc_expectation *expected) {
    return expected && expected->digest[0] == record->digest[0] &&
           expected->digest[1] == record->digest[1];
}

/* Are `count` callees of the function `caller` linked as expected? `caller` is NULL for those of
 * the loops. */
static bool are_linked(const redcc_linkage *linkage, const redcc_callee *called, redcc_size count,
                       const redcc_expectation *caller, int depth,
                       const redcc_expectation **other) {
    for (redcc_size i = 0; i < count; i++) {
        const redcc_record *record = called[i].record;
        const redcc_expectation *expected = caller ? NULL : &linkage->expected[i];
        if (record)
            expected = expectation_of(linkage, record->name);
        *other = expected ? expected : caller;
        if (!record || record->own != called[i].called || depth >= MOST_DEEP ||
            !is_expected(record, expected) ||
            !are_linked(linkage, record->callees, record->callee_count, expected, depth + 1, other))
            return false;
    }
    return true;
}

int redcc_are_linked(const redcc_linkage *linkage, const redcc_expectation **other) {
    assert(linkage->count <= linkage->expected_count);
    return are_linked(linkage, linkage->called, linkage->count, NULL, 0, other);
}
