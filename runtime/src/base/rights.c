/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/rights.h"

#include "base/processor.h"

bool redcc_rights_assumed;

#if defined(__x86_64__)

/* The instructions are written as bytes, because assemblers and compilers accept their names only
 * with an option. */
static uint32_t read_rights(void) {
    uint32_t rights, unused;
    __asm__ volatile(".byte 0x0f, 0x01, 0xee" /* rdpkru */ : "=a"(rights), "=d"(unused) : "c"(0));
    return rights;
}

static void write_rights(uint32_t rights) {
    __asm__ volatile(".byte 0x0f, 0x01, 0xef" /* wrpkru */
                     :
                     : "a"(rights), "c"(0), "d"(0)
                     : "memory");
}

static bool are_there(void) {
    return redcc_rights_assumed || redcc_has_protection_keys();
}

uint32_t redcc_rights(void) {
    return are_there() ? read_rights() : 0;
}

void redcc_rights_set(uint32_t rights) {
    if (are_there() && read_rights() != rights)
        write_rights(rights);
}

#else

uint32_t redcc_rights(void) {
    return 0;
}

void redcc_rights_set(uint32_t rights) {
    (void)rights;
}

#endif
