/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops as programmers write them: updates by functions that find the array in a record, extrema of
 * scalars, and pointers that step through arrays. Only in programs with seed % 11 == 0, so that
 * other seeds yield the same programs as before. */
#include "fuzz/kernel.h"

/* Appends mat_add(&m, r, c, v), with m->values[r * m->width + c] += v. */
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

/* Appends if (x > big) { big = x; at = i; }, or similar statements. */
static void scalar_extremum(kernel *k) {
    static const char *const comparisons[] = {">", ">", "<", ">=", "<="};
    const char *big = new_name(k, "big"), *at = new_name(k, "at"), *x = new_name(k, "x");
    const char *op = comparisons[below(k, 5)];
    const char *type = chance(k, 70) ? "double" : chance(k, 50) ? "float" : "int";
    const char *e = type[0] == 'i' ? integer(k, 1) : value(k, 1);
    const char *counter = chance(k, 95) ? k->scope.positions.name[0] : subscript(k);
    declare_outside(k, type, big, chance(k, 50) ? "0" : chance(k, 50) ? "-100" : "100");
    put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, big);
    put(k, &k->body, "const %s %s = (%s)(%s);\n", type, x, type, e);
    if (chance(k, 15))
        put(k, &k->body, "if (%s)\n", condition(k));
    if (chance(k, 20)) {
        put(k, &k->body, "%s = %s %s %s ? %s : %s;\n", big, x, op, big, x, big);
    } else if (chance(k, 15)) {
        put(k, &k->body, "%s = %s %s %s ? %s : %s;\n", big, big, op, x, big, x);
    } else if (chance(k, 30)) {
        put(k, &k->body, "if (%s %s %s)\n%s = %s;\n", x, op, big, big, x);
    } else {
        declare_outside(k, chance(k, 60) ? "int" : "long", at, "-1");
        put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, at);
        put(k, &k->body, "if (%s %s %s) {\n%s = (%s);\n%s = %s;\n}\n", big, op, x, at, counter, big,
            x);
    }
    if (chance(k, 8))
        put(k, &k->body, "live[0] += (double)%s;\n", big);
    add_name(&k->scope.values, type[0] == 'd' ? x : "0.5");
}

/* Appends h[*p++ & 63] += v, or h[s[j++ % 64] & 63] += v where the statement may be executed more
 * often than the loop has iterations. */
static void walk(kernel *k) {
    const array *a = any_reduction(k);
    const char *p = new_name(k, "walk"), *x = new_name(k, "x"), *own = k->subscript[0].base;
    const bool is_pointer = !k->is_wide && !k->scope.in_loop && k->subscript[0].shape == SHAPE_FLAT;
    if (a->shape != SHAPE_FLAT || *a->operation == '<' || *a->operation == '>')
        return;
    const char *type = elements[k->subscript[0].type].spelling;
    declare_outside(k, is_pointer ? text(k, "const %s *", type) : "int", p, is_pointer ? own : "0");
    const char *here = is_pointer ? text(k, "*%s", p) : k->flag.base;
    const char *step = is_pointer ? text(k, "*%s++", p)
                                  : text(k, "%s[(unsigned)%s++ %% %du]", k->flag.base, p, k->size);
    const int mask = k->elements - 1;
    if (chance(k, 10))
        put(k, &k->body, "if (%s)\n", condition(k));
    if (chance(k, 45)) {
        put(k, &k->body, "%s[%s & %d] %s= %s;\n", a->base, step, mask, a->operation,
            contribution(k, a));
    } else if (chance(k, 50)) {
        put(k, &k->body, "{\nconst int %s = %s;\n%s[%s & %d] %s= %s;\n}\n", x, step, a->base, x,
            mask, a->operation, contribution(k, a));
    } else {
        put(k, &k->body, "%s[%s & %d] %s= %s & 3;\n", a->base, subscript(k), mask, a->operation,
            step);
    }
    if (is_pointer && chance(k, 8))
        put(k, &k->body, "live[0] += %s;\n", here);
    put(k, &k->after,
        is_pointer ? "    live[%d] = (double)(%s - %s);\n" : "    live[%d] = (double)%s;\n",
        k->live++ % 8, p, own);
}

void idiom(kernel *k) {
    if (chance(k, 40))
        walk(k);
    else if (chance(k, 45))
        scalar_extremum(k);
    else
        update_by_member(k);
}
