/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Two pointers to mapped memory: to one memory object at two addresses, or to two objects. Between
 * calls the mapping may change at unchanged addresses. */
#include "fuzz/attacks/attack.h"

enum {
    COUNT = 1024, /* elements of each mapping, as in attack_map */
    KINDS = 4     /* kinds of attack_map; kind 0: two objects */
};

static int any_kind(attack *a) {
    return chance(a, 30) ? 0 : 1 + below(a, KINDS - 1);
}

operand mapped(attack *a) {
    const bool is_read = chance(a, 50);
    const int kind = any_kind(a);
    note(a, is_read ? "mapped/read" : "mapped/written");
    put(a, PART_GLOBALS, "static unsigned long *both$[2];\n");
    put(a, PART_PARAMETERS, ", unsigned long *s$, unsigned long *d$, const int *m$, const int *o$");
    put(a, PART_ARGUMENTS, ", both$[0], both$[1], m$, o$");
    put_table(a, "m", COUNT, 0);
    put_table(a, "o", COUNT, 0);
    put(a, PART_SETUP, "attack_map(both$, %d);\n", kind);
    may_change(a, "attack_map(both$, %d);", any_kind(a));
    may_change(a, "attack_map(both$, %d);", any_kind(a));
    put(a, PART_AFTER,
        "for (int i$ = 0; i$ < %d; i$++)\nattack_note((double)(s$[i$] & 0xffffff));\n", COUNT);
    put(a, PART_BODY,
        chance(a, 50) ? "s$[m$[t]] = s$[m$[t]] * 3 + (unsigned long)t;\n"
                      : "s$[m$[t]] += (unsigned long)t;\n");
    if (is_read)
        return (operand){text(a, chance(a, 50) ? "(int)(d$[t] & 63)" : "(int)(d$[o$[t]] & 63)"),
                         true, false, NULL};
    put(a, PART_BODY, "d$[o$[t]] = d$[o$[t]] * 5 + (unsigned long)t;\n");
    return (operand){"1", true, false, NULL};
}
