/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Inner loops: of constant length, over rows of a sparse matrix, along chains. */
#include "fuzz/kernel.h"

static void put_body(kernel *k, scope outside) {
    k->scope.in_loop = k->scope.can_skip = true;
    put(k, &k->body, "{\n");
    block(k, 1 + below(k, 2));
    put(k, &k->body, "}\n");
    k->scope = outside;
}

static void constant_loop(kernel *k) {
    const scope outside = k->scope;
    const char *c = new_name(k, "c");
    const bool is_outer = chance(k, 30);
    if (is_outer)
        declare_outside(k, "int", c, k->without ? "0" : NULL);
    put(k, &k->body, "for (%s%s = 0; %s < 3; %s++) ", is_outer ? "" : "int ", c, c, c);
    add_name(&k->scope.smalls, c);
    put_body(k, outside);
}

/* An element of a row, mostly the one at the loop's counter. */
static const char *part_of_row(kernel *k, const array *a, const char *index, const char *c) {
    const int which = below(k, 12);
    return which == 0   ? text(k, "%s[%s][2 - %s]", a->base, index, c)
           : which == 1 ? text(k, "%s[%s][%d]", a->base, index, below(k, 3))
           : which == 2
               ? text(k, "%s[(%s + (int)%s) & %d][%s]", a->base, index, c, k->elements - 1, c)
               : text(k, "%s[%s][%s]", a->base, index, c);
}

void loop_over_parts(kernel *k) {
    static const char *const types[] = {"int", "int", "int", "unsigned", "long", "unsigned char"};
    const array *a = any_reduction(k);
    if (a->shape != SHAPE_ROWS)
        return;
    const scope outside = k->scope;
    const char *c = new_name(k, "c");
    const char *indices[] = {subscript(k), subscript(k)};
    const char *type = types[below(k, 6)];
    const int from = chance(k, 20), step = chance(k, 10) ? 2 : 1;
    const bool is_outer = chance(k, 30);
    if (is_outer)
        declare_outside(k, type, c, k->without ? "0" : NULL);
    put(k, &k->body, "for (%s%s%s = %d; %s < 3; %s += %d) {\n", is_outer ? "" : type,
        is_outer ? "" : " ", c, from, c, c, step);
    add_name(&k->scope.smalls, c);
    k->scope.in_loop = k->scope.can_skip = true;
    for (int left = 1 + below(k, 3); left > 0; left--) {
        if (chance(k, 12))
            plain_update(k);
        else
            put(k, &k->body, "%s;\n", update(k, a, part_of_row(k, a, indices[below(k, 2)], c)));
        if (chance(k, 5))
            put(k, &k->body, "if (%s)\ncontinue;\n", condition(k));
    }
    put(k, &k->body, "}\n");
    k->scope = outside;
}

static void row_loop(kernel *k) {
    const scope outside = k->scope;
    const char *c = new_name(k, "c");
    const char *row = k->scope.positions.name[0];
    const char *extra = chance(k, 20) ? text(k, " + (int)(%s & 1)", row) : "";
    put(k, &k->body, "for (int %s = %s[%s]; %s < %s[%s + 1]%s; %s++) ", c, k->first.base, row, c,
        k->first.base, row, extra, c);
    add_name(&k->scope.positions, c);
    put_body(k, outside);
}

static void chain_loop(kernel *k) {
    const scope outside = k->scope;
    const char *c = new_name(k, "k");
    const char *start = subscript(k);
    put(k, &k->body, "int %s = %s;\n", c, start);
    add_name(&k->scope.subscripts, c);
    const char *step = text(k, "%s = %s[%s];\n", c, k->chain.base, c);
    const bool is_do = chance(k, 30);
    put(k, &k->body, is_do ? "do {\n" : "while (%s > 0) {\n", c);
    k->scope.in_loop = true;
    k->scope.can_skip = false;
    block(k, 1);
    put(k, &k->body, "%s", step);
    if (chance(k, 20))
        put(k, &k->body, "if (%s == 3)\nbreak;\n", c);
    put(k, &k->body, is_do ? "} while (%s > 0);\n" : "}\n", c);
    k->scope = outside;
}

/* A variable declared outside the loop holds the subscript of the previous iteration. */
static void lagging_loop(kernel *k) {
    const scope outside = k->scope;
    const char *c = new_name(k, "c");
    const char *lag = new_name(k, "k");
    put(k, &k->body, "int %s = 0;\nfor (int %s = 0; %s < 3; %s++) ", lag, c, c, c);
    add_name(&k->scope.subscripts, lag);
    add_name(&k->scope.smalls, c);
    k->scope.in_loop = k->scope.can_skip = true;
    put(k, &k->body, "{\n");
    block(k, 1);
    put(k, &k->body, "%s = %s;\n}\n", lag, subscript(k));
    k->scope = outside;
    add_name(&k->scope.subscripts, lag);
}

void inner_loop(kernel *k) {
    if (k->scope.in_loop && chance(k, 70)) {
        const array *a = any_reduction(k);
        const char *where = place(k, a, subscript(k));
        put(k, &k->body, "%s;\n", update(k, a, where));
        return;
    }
    const int which = below(k, 10);
    if (which < 5)
        constant_loop(k);
    else if (which < 7)
        row_loop(k);
    else if (which < 9 && !k->is_masked)
        chain_loop(k);
    else
        lagging_loop(k);
}
