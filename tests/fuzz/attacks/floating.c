/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Subscripts computed from floating-point values: under conditions that exclude values which no
 * integer can represent, with exceptions that trap, and with another rounding mode between
 * calls. */
#include "fuzz/attacks/attack.h"

static void put_values(attack *a) {
    put(a, PART_GLOBALS, "static double f$[%d];\n", a->trips + SPARE);
    put(a, PART_SETUP,
        "attack_fill_doubles(f$, %d);\nfor (int i = 0; i < %d; i++)\nif (attack_below(9) == 0)\n"
        "f$[i] = attack_below(2) ? 1e20 : -1e300;\n",
        a->trips + SPARE, a->trips + SPARE);
}

static const char *in_range(attack *a) {
    static const char *const forms[] = {
        "f$[t] * f$[t] < 4.0",
        "f$[t] < 2.0 && f$[t] > -2.0",
        "!(f$[t] >= 2.0) && f$[t] >= -2.0",
        "f$[t] - 2.0 < 0 && f$[t] + 2.0 > 0",
    };
    return text(a, one_of(a, 4, forms));
}

static operand converted(attack *a) {
    note(a, "floating/converted");
    put_values(a);
    const double scale = (double)a->elements / 4 - 0.5;
    if (chance(a, 60)) {
        note(a, "floating/trapping");
        put(a, PART_GLOBALS,
            "int feenableexcept(int);\nint fedisableexcept(int);\nint feclearexcept(int);\n");
        put(a, PART_SETUP, "feclearexcept(1);\nfeenableexcept(1);\n");
        put(a, PART_FINISH, "fedisableexcept(1);\n");
    }
    const char *index = text(a, "(int)((f$[t] + 2.0) * %.3f)", scale);
    if (chance(a, 50)) {
        put(a, PART_BODY, "int j$ = 0;\nif (%s)\nj$ = %s;\n", in_range(a), index);
        return (operand){text(a, "j$"), true, true, NULL};
    }
    return (operand){index, true, true, text(a, "(%s)", in_range(a))};
}

/* The rounding mode is not visible in the loop's arguments. */
static operand rounded(attack *a) {
    static const char *const calls[] = {
        "(int)lrint(f$[t])", "(int)llrint(f$[t])",        "(int)nearbyint(f$[t])",
        "(int)rint(f$[t])",  "(int)lrintf((float)f$[t])", "(int)(f$[t] * 0.7 + 1e16 - 1e16)"};
    note(a, "floating/rounded");
    put(a, PART_INCLUDES, "#include <math.h>\n");
    put(a, PART_GLOBALS, "int fesetround(int);\nstatic double f$[%d];\n", a->trips + SPARE);
    put(a, PART_SETUP,
        "attack_fill_doubles(f$, %d);\nfor (int i = 0; i < %d; i++)\nf$[i] = (f$[i] + 1.0) * %d;\n",
        a->trips + SPARE, a->trips + SPARE, a->elements / 2 - 2);
    put(a, PART_FINISH, "fesetround(0);\n");
    may_change(a, "fesetround(0x400);");
    may_change(a, "fesetround(0x800);");
    may_change(a, "fesetround(0xc00);");
    return (operand){one_of(a, 5, calls), true, false, NULL};
}

operand floating_subscripts(attack *a) {
    operand o = chance(a, 60) ? converted(a) : rounded(a);
    o.text = text(a, "%s", o.text);
    return o;
}
