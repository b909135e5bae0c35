/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Functions of the program, in another file, that have names known to the compiler and read what
 * the loop writes. Also functions that are declared without side effects and read it. */
#include "fuzz/attacks/attack.h"

static const char *const names[] = {
    "parity((int)t)",  "expect((int)t)",  "clz((int)t)",        "popcount((int)t)",
    "ctzl((int)t)",    "inf((int)t)",     "huge_val((int)t)",   "isinf_sign((int)t)",
    "parityl((int)t)", "absf((double)t)", "expectf((double)t)",
};

operand names_like_builtins(attack *a) {
    note(a, "functions/name");
    put(a, PART_SETUP, "attack_watch(pool_%llu, sizeof pool_%llu);\n", (unsigned long long)a->seed,
        (unsigned long long)a->seed);
    const char *call = one_of(a, (int)(sizeof names / sizeof *names), names);
    if (chance(a, 25)) {
        put(a, PART_GLOBALS, "static int through$(unsigned t) {\nreturn (int)%s;\n}\n", call);
        return (operand){text(a, "through$((unsigned)t)"), true, false, NULL};
    }
    return (operand){text(a, "(int)%s", call), true, false, NULL};
}
