/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Scalars in addition to the array: summed, assigned in some iterations, used after the loop, or
 * carried from one iteration to the next. */
#include "fuzz/attacks/attack.h"

static const char *const types[] = {"double", "float",         "unsigned",
                                    "long",   "unsigned char", "short"};

static operand sum(attack *a) {
    note(a, "scalars/sum");
    const int type = below(a, 6);
    const char *e = type < 2 ? "w[t] * 0.5" : text(a, "k[t] + %d", below(a, 9));
    put(a, PART_BEFORE, "%s s$ = %d;\n", types[type], below(a, 3));
    if (chance(a, 30))
        put(a, PART_BODY, "if (k[t] %% 3)\n");
    put(a, PART_BODY, "s$ %s %s;\n", chance(a, 80) ? "+=" : "-=", e);
    put(a, PART_AFTER, "attack_note((double)s$);\n");
    return (operand){"k[t]", true, true, NULL};
}

static operand last(attack *a) {
    note(a, "scalars/last");
    const int type = below(a, 6);
    put(a, PART_BEFORE, "%s v$ = 2;\n", types[type]);
    const bool always = chance(a, 40);
    if (!always)
        put(a, PART_BODY, "if (k[t] %% %d == 0)\n", 2 + below(a, 30));
    put(a, PART_BODY, "v$ = (%s)(k[t] + %d);\n", types[type], below(a, 5));
    if (chance(a, 80))
        put(a, PART_AFTER, "attack_note((double)v$);\n");
    return (operand){always ? text(a, "((int)v$ & 1023)") : "(int)t", true, false, NULL};
}

/* The scalar is assigned in most iterations and read in each, so earlier iterations matter. */
static operand carried(attack *a) {
    note(a, "scalars/carried");
    static const char *const forms[] = {
        "if (k[t] %% 5)\nv$ = k[t];\n",
        "if (t > 0)\nv$ = k[t];\n",
        "for (int i$ = 0; i$ < k[t]; i$++)\nv$ = i$;\n",
        "switch (k[t] & 1) {\ncase 0:\nv$ = k[t];\nbreak;\n}\n",
        "(void)(k[t] > 2 && (v$ = k[t]));\n",
        "k[t] & 1 ? (v$ = k[t]) : 0;\n",
        "while (v$ < k[t])\nv$ += 2;\n",
        "if (k[t] & 1) {\nif (k[t] & 2)\nv$ = 3;\n} else {\nv$ = 4;\n}\n",
    };
    put(a, PART_BEFORE, "int v$ = %d;\n", below(a, 9));
    put(a, PART_BODY, "%s", text(a, forms[below(a, 8)]));
    return (operand){text(a, "v$"), true, false, NULL};
}

static operand largest(attack *a) {
    note(a, "scalars/largest");
    put(a, PART_BEFORE, "int m$ = -1, at$ = 0;\n");
    put(a, PART_BODY, "if (k[t] > m$) {\nm$ = k[t];\n%s}\n",
        text(a, chance(a, 50) ? "at$ = (int)t;\n" : ""));
    put(a, PART_AFTER, "attack_note(m$);\nattack_note(at$);\n");
    return (operand){chance(a, 20) ? text(a, "m$") : "k[t]", true, true, NULL};
}

operand beside_scalars(attack *a) {
    switch (below(a, 5)) {
    case 0:
        return last(a);
    case 1:
        return carried(a);
    case 2:
        return largest(a);
    default:
        return sum(a);
    }
}
