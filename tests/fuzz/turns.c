/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Inner loops along lists: each inner iteration finds its rows, computes and updates them, or does
 * something that affects later inner iterations. Only in programs with seed % 7 == 6. */
#include "fuzz/kernel.h"

static void put_row(kernel *k, const char *name) {
    const char *e = subscript(k);
    if (chance(k, 25))
        declare_outside(k, "int", name, "0");
    else
        put(k, &k->body, "int ");
    put(k, &k->body, "%s = %s;\n", name, e);
    if (chance(k, 20))
        put(k, &k->body, "if (%s)\n%s = (%s + 3) & %d;\n", condition(k), name, name,
            k->elements - 1);
}

static void put_work(kernel *k, const char *name) {
    const char *a = value(k, 1), *b = value(k, 1);
    if (chance(k, 15))
        declare_outside(k, "double", name, "0");
    else
        put(k, &k->body, "double ");
    put(k, &k->body, "%s = %s * 0.5 + %s * 0.25;\n", name, a, b);
    put(k, &k->body, chance(k, 90) ? "%s = %s * 0.5 - 0.125;\n" : "%s += %s * 0.5;\n", name, name);
    add_name(&k->scope.values, name);
}

/* Appends a statement that cuts the turn short, or that affects other turns. */
static void put_turning_point(kernel *k, const char *row, const char *carried) {
    switch (below(k, 12)) {
    case 0:
        put(k, &k->body, "if (%s)\nbreak;\n", condition(k));
        break;
    case 1:
        put(k, &k->body, chance(k, 70) ? "%s += 0.25;\n" : "%s = %s * 0.5 + 0.25;\n", carried,
            carried);
        break;
    case 2:
        put(k, &k->body, "%s = (%s + 1) & %d;\n", row, row, k->elements - 1);
        break;
    case 3:
    case 4:
        put(k, &k->body, "if (%s)\ncontinue;\n", condition(k));
        break;
    case 5:
        statement(k);
        break;
    default:
        break;
    }
}

void loop_along_a_list(kernel *k) {
    const scope outside = k->scope;
    const char *c = new_name(k, "c"), *carried = new_name(k, "d");
    const char *row[] = {new_name(k, "k"), new_name(k, "k")};
    const bool is_first_outside = chance(k, 40);
    put(k, &k->body, "double %s = 0.5;\n", carried);
    if (is_first_outside)
        put_row(k, row[0]);
    put(k, &k->body, "for (int %s = 0; %s < %d; %s++) {\n", c, c, 2 + below(k, 4), c);
    k->scope.in_loop = k->scope.can_skip = true;
    for (int i = is_first_outside; i < 2; i++)
        put_row(k, row[i]);
    put_work(k, new_name(k, "d"));
    if (chance(k, 30))
        add_name(&k->scope.values, carried);
    put_turning_point(k, row[below(k, 2)], carried);
    for (int left = 1 + below(k, 3); left > 0; left--) {
        const array *a = any_reduction(k);
        const char *where = place(k, a, row[below(k, 2)]);
        if (chance(k, 25))
            put(k, &k->body, "if (%s)\n", condition(k));
        put(k, &k->body, "%s;\n", update(k, a, where));
        if (chance(k, 15))
            put_turning_point(k, row[below(k, 2)], carried);
    }
    put(k, &k->body, "}\n");
    k->scope = outside;
    add_name(&k->scope.values, carried);
}
