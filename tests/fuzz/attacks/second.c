/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Kinds of the second series of attacks (docs/soundness.md): counters set inside their loops,
 * comparisons stored in integers of every type, and updates of memory that no iteration
 * executes. */
#include "fuzz/attacks/attack.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

/* Returns a condition on the double `$r`, which differs from iteration to iteration. */
static const char *condition(attack *a) {
    static const char *const forms[] = {"r$ < 0.25", "r$ > 0.5", "r$ < 0.5 && r$ > -0.5",
                                        "!(r$ < 0.125)", "r$ < -0.25 || r$ > 0.75"};
    return text(a, "%s", chance(a, 10) ? "n > 100" : forms[below(a, LENGTH(forms))]);
}

/* Makes an iteration heavy enough for lanes: a loop computes r$, which converges. */
static void put_value(attack *a, int rounds) {
    put(a, PART_BODY, "double r$ = w[t];\n");
    if (rounds > 0)
        put(a, PART_BODY,
            "for (int i$ = 0; i$ < %d; i$++)\nr$ = r$ * 0.75 - 0.125 * r$ * r$ + 0.0625;\n",
            rounds);
}

operand counters_set_inside(attack *a) {
    static const char *const jumps[] = {"if (%s)\nc$ = 40;\n",
                                        "if (%s)\nc$ += 2;\n",
                                        "if (%s)\nend$ = c$;\n",
                                        "c$ += (%s) ? 3 : 0;\n",
                                        "(void)((%s) && (c$ = 30));\n",
                                        "if (n > 50) {\nif (%s)\nc$++;\n}\n",
                                        "if (%s)\nfor (; c$ < 12; c$++)\n;\n"};
    note(a, "second/counter");
    put_value(a, chance(a, 50) ? 24 : 0);
    put(a, PART_BODY, "int end$ = %d, c$;\n", 8 + below(a, 24));
    put(a, PART_BODY, "for (c$ = 0; c$ < end$; c$++) {\nr$ = r$ * 0.5 + 0.25 * w[t + 1];\n");
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    put(a, PART_BODY, jumps[below(a, LENGTH(jumps))], condition(a));
#pragma GCC diagnostic pop
    put(a, PART_BODY, "}\n");
    if (chance(a, 30))
        return (operand){text(a, "c$"), true, false, NULL};
    return (operand){text(a, "r$"), false, false, NULL};
}

operand masks(attack *a) {
    static const char *const types[] = {
        "int",   "unsigned",    "unsigned",       "long",      "unsigned long", "unsigned char",
        "short", "signed char", "unsigned short", "long long", "size_t",        "_Bool"};
    static const char *const uses[] = {"(m$ - 2) / 3",  "-m$ >> 1",   "~m$",     "(m$ - 2) %% 5",
                                       "(m$ << 7) - 3", "m$ ? 5 : 2", "-m$ / 2", "(m$ - 1) >> 3"};
    note(a, "second/mask");
    put_value(a, chance(a, 70) ? 24 : 0);
    put(a, PART_BODY, "const %s m$ = %s;\n", types[below(a, LENGTH(types))], condition(a));
    const char *use = text(a, "%s", text(a, uses[below(a, LENGTH(uses))]));
    return (operand){text(a, "(int)((%s) & 1023)", use), true, false, NULL};
}

operand held(attack *a) {
    static const struct {
        const char *type, *initial, *update;
    } kinds[] = {
        {"int", "3", "held$++;\n"},
        {"long", "-1", "held$ -= k[t];\n"},
        {"unsigned char", "250", "held$ += k[t];\n"},
        {"unsigned", "7", "held$ ^= (unsigned)k[t];\n"},
        {"unsigned long", "~0ul", "held$ &= (unsigned long)k[t];\n"},
        {"double", "-0.0", "held$ += w[t];\n"},
        {"double", "0.0", "held$ -= w[t];\n"},
        {"float", "1.5f", "held$ *= (float)w[t];\n"},
        {"double", "9.0", "held$ = w[t] < held$ ? w[t] : held$;\n"},
        {"double", "-9.0", "if (w[t] >= held$)\nheld$ = w[t];\n"},
        {"int", "5", "held$ = (int)t;\n"},
    };
    const int which = below(a, LENGTH(kinds));
    note(a, "second/held");
    put(a, PART_GLOBALS, "static int never$[%d];\nstatic ATTACK_PAGE %s held$ = %s;\n",
        a->trips + SPARE, kinds[which].type, kinds[which].initial);
    put(a, PART_SETUP, "attack_hold();\n");
    put_value(a, chance(a, 50) ? 24 : 0);
    put(a, PART_BODY, "if (never$[t]%s) {\n",
        chance(a, 30) ? text(a, " && (%s)", condition(a)) : "");
    put(a, PART_BODY, "%s", text(a, kinds[which].update));
    put(a, PART_BODY, "}\n");
    put(a, PART_AFTER, "attack_note((double)held$);\n");
    return (operand){text(a, "r$"), false, false, NULL};
}
