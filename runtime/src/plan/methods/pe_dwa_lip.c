/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Partially expanded DWA-LIP. There are N copies of the arrays; the arrays themselves count as the
 * first copy. The threads form N teams. Each team executes its share of the iterations by DWA-LIP
 * on its own copy, which is cut into one block per thread of the team. This gives fewer blocks,
 * fewer stages and fewer conflicts than DWA-LIP by all threads.
 */
#include "plan/methods/dwa_lip.h"

#include <stdlib.h>

static int parse(const char *text) {
    char *end;
    const long copies = strtol(text, &end, 10);
    return end != text && *end == '\0' && copies >= 1 && copies <= 1 << 20 ? (int)copies : 0;
}

static int teams(int threads, int parameter) {
    return parameter < threads ? parameter : threads;
}

/* The number of owners, which is the number of threads of the largest team. */
static uint32_t owners(int threads, int parameter) {
    const int count = teams(threads, parameter);
    return (uint32_t)((threads + count - 1) / count);
}

const struct method redcc_method_pe_dwa_lip = {.name = "pe-dwa-lip",
                                               .parameter = "N",
                                               .keeps = REDCC_ORDER_ANY,
                                               .copies = COPY_TEAM,
                                               .parse = parse,
                                               .usual = 2,
                                               .teams = teams,
                                               .owners = owners,
                                               .prepare = redcc_dwa_lip_prepare};
