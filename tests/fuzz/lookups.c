/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Functions that change their parameters and local variables before they use them as subscripts, in
 * ways that the analysis can or cannot follow. Only in programs with seed % 6 == 4. */
#include "fuzz/kernel.h"

static const char *known_condition(kernel *k) {
    static const char *const conditions[] = {"at > 9", "count & 1", "at < j", "list[at] > at",
                                             "x[at] > 0.25"};
    return conditions[below(k, 5)];
}

/* Changes `at` and `j`, which stay within the tables. */
static const char *change(kernel *k, int depth) {
    const int mask = k->elements - 1;
    switch (below(k, depth > 0 ? 12 : 8)) {
    case 0:
        return text(k, "at = (at + %d) & %d;", 1 + below(k, 40), mask);
    case 1:
        return text(k, "at = list[at] & %d;", mask);
    case 2:
        return text(k, "j = (at >> 1) + %d;", below(k, 3));
    case 3:
        return "at /= 2;";
    case 4:
        return text(k, "j ^= at & %d;", 1 + below(k, 7));
    case 5:
        return text(k, "at = (int)(x[j] * 8 + 64) & %d;", mask);
    case 6:
        return chance(k, 50) ? "if (at > 3)\n        at--;" : "if (j > 5)\n        --j;";
    case 7:
        return text(k, "at *= 3, at &= %d;", mask);
    case 8:
        return text(k, "if (%s) {\n    %s\n    } else if (%s) {\n    %s\n    }", known_condition(k),
                    change(k, depth - 1), known_condition(k), change(k, depth - 1));
    case 9:
        return text(k, "if (%s) {\n    %s\n    }", known_condition(k), change(k, depth - 1));
    case 10:
        return text(
            k, "switch (count & 3) {\n    case 1:\n    %s\n    break;\n    default:\n    %s\n    }",
            change(k, depth - 1), change(k, depth - 1));
    default:
        return text(k, "for (int c = 0; c < count; c += 5) {\n    %s\n    }", change(k, depth - 1));
    }
}

static void put_look_up(kernel *k, const char *function) {
    static const char *const types[] = {"int", "long", "unsigned", "short", "unsigned char"};
    const char *const type = types[below(k, 5)];
    const int mask = k->elements - 1 < 127 ? k->elements - 1 : 127;
    put(k, &k->globals,
        "static double %s(const double *x, const int *list, int at, int count) {\n"
        "    %s j = (%s)(count & %d);\n    (void)list;\n",
        function, type, type, mask);
    for (int left = 1 + below(k, 4); left > 0; left--) {
        put(k, &k->globals, "    %s\n", change(k, 2));
        put(k, &k->globals, "    j &= %d;\n", mask);
        if (chance(k, 10))
            put(k, &k->globals, "    if (%s)\n        return 0.75;\n", known_condition(k));
    }
    put(k, &k->globals, "    return %s;\n}\n",
        chance(k, 60)   ? "x[at]"
        : chance(k, 50) ? "x[at] - x[j]"
                        : "(count > 4 ? x[j] : 0.5)");
}

void look_up_by_changed(kernel *k) {
    const array *a = any_reduction(k);
    const bool is_updated =
        a->type == E_DOUBLE && a->shape == SHAPE_FLAT && !a->is_no_integer && chance(k, 15);
    const char *function = new_name(k, "look");
    const array *lists[] = {&k->chain, &k->flag};
    put_look_up(k, function);
    const char *name = new_name(k, "d");
    put(k, &k->body, "double %s = damp(%s(%s, %s, (int)(%s) & %d, 1 + (int)((%s) & 15)));\n", name,
        function, is_updated ? a->base : k->other.base, lists[below(k, 2)]->base,
        chance(k, 60) ? position(k) : subscript(k), k->elements / 2 - 1, subscript(k));
    add_name(&k->scope.values, name);
}
