/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops as programmers spell them: updates by functions that find the array in a record. Of
 * programs whose seeds are divisible by 11; the others stay what they were when these were added.
 */
#include "fuzz/kernel.h"

/* mat_add(&m, r, c, v), with m->values[r * m->width + c] += v. */
static void update_by_member(kernel *k) {
    const array *a = any_reduction(k);
    const char *function = new_name(k, "entry");
    const char *type = elements[a->type].spelling;
    if (a->shape != SHAPE_FLAT || *a->operation == '<' || *a->operation == '>' ||
        a->storage == STORAGE_VARIABLE_LENGTH)
        return;
    const char *when = chance(k, 10) ? "if (c < m->width)\n        " : "";
    put(k, &k->globals, "struct of_%s {\n    int width;\n    %s *values;\n};\n", function, type);
    put(k, &k->globals,
        "static void %s(struct of_%s *m, int r, %s c, %s v) {\n"
        "    %sm->values[(r * m->width + c) & %d] %s= v;\n}\n",
        function, function, chance(k, 70) ? "int" : "long", type, when, k->elements - 1,
        a->operation);
    put(k, &k->locals, "    struct of_%s of_%s = {%d, (%s *)%s}, *const m_%s = &of_%s;\n", function,
        function, 1 + below(k, 3), type, a->base, function, function);
    if (chance(k, 30))
        put(k, &k->body, "if (%s)\n", condition(k));
    put(k, &k->body, "%s(m_%s, (int)(%s), (int)(%s) & 1, %s);\n", function, function, subscript(k),
        subscript(k), contribution(k, a));
}

void idiom(kernel *k) {
    update_by_member(k);
}
