/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Local pointers, set in an iteration, that step in headers and bodies next to other variables of
 * the headers. Also blocks of rows or of parts of records. Only in programs with seed % 9 == 4. */
#include "fuzz/kernel.h"

typedef struct walk {
    const array *array;
    const char *pointer, *counter, *first, *length, *beside; /* beside: w += 0.5 in the header */
} walk;

static const char *type_behind(const array *a) {
    return a->shape == SHAPE_RECORDS ? a->record : elements[a->type].spelling;
}

/* Declares the bounds: first + 2 * length is less than the number of elements. */
static void put_bounds(kernel *k, walk *w) {
    w->first = new_name(k, "first");
    w->length = new_name(k, "length");
    put(k, &k->body, "const int %s = (%s) & %d;\n", w->first, subscript(k), k->elements / 2 - 1);
    put(k, &k->body, "const int %s = (%s) & %d;\n", w->length, subscript(k),
        (k->elements / 4 - 1) & 7);
}

static void put_pointer(kernel *k, walk *w) {
    const array *a = w->array;
    w->pointer = new_name(k, "p");
    if (a->shape == SHAPE_ROWS)
        put(k, &k->body, "%s (*%s)[3]", type_behind(a), w->pointer);
    else
        put(k, &k->body, "%s *%s", type_behind(a), w->pointer);
    put(k, &k->body, chance(k, 50) ? " = %s + %s;\n" : " = &%s[%s];\n", a->base, w->first);
    if (chance(k, 10)) /* another start */
        put(k, &k->body, "if (%s)\n%s = %s + %s / 2;\n", condition(k), w->pointer, a->base,
            w->first);
}

static const char *target(kernel *k, const walk *w) {
    switch (w->array->shape) {
    case SHAPE_ROWS:
        return text(k, chance(k, 50) ? "(*%s)[%d]" : "%s[0][%d]", w->pointer, below(k, 3));
    case SHAPE_RECORDS:
        return text(k, "%s->%c", w->pointer, chance(k, 50) ? 'x' : 'y');
    default:
        return text(k, chance(k, 50) ? "(*%s)" : "%s[0]", w->pointer);
    }
}

static void put_walk(kernel *k, walk *w) {
    const char *step = chance(k, 15) ? text(k, "%s += 2", w->pointer) : text(k, "%s++", w->pointer);
    const bool in_header = chance(k, 75);
    w->counter = new_name(k, "c");
    put(k, &k->body, "for (int %s = 0; %s < %s; %s++%s%s%s) {\n", w->counter, w->counter, w->length,
        w->counter, in_header ? ", " : "", in_header ? step : "",
        w->beside ? text(k, ", %s += 0.5", w->beside) : "");
    k->scope.in_loop = true;
    if (chance(k, 15))
        put(k, &k->body, "if (%s)\n%s;\n", condition(k),
            in_header ? "continue" : text(k, "%s = %s", w->pointer, w->pointer));
    for (int left = 1 + chance(k, 30); left > 0; left--)
        put(k, &k->body, "%s;\n", update(k, w->array, target(k, w)));
    if (!in_header)
        put(k, &k->body, "%s;\n", step);
    put(k, &k->body, "}\n");
}

/* Appends loops over rows of two blocks, or over parts of their records, with some arithmetic. */
static void put_blocks(kernel *k, const walk *w) {
    const array *a = w->array;
    const char *other = new_name(k, "other"), *i = new_name(k, "i"), *j = new_name(k, "j");
    const char *e = new_name(k, "e");
    const char *form = a->shape == SHAPE_ROWS      ? "%s[%s][1]"
                       : a->shape == SHAPE_RECORDS ? "%s[%s].y"
                                                   : "%s[%s]";
    put(k, &k->body, "for (int %s = 0; %s < 3; %s++) {\n", w->counter, w->counter, w->counter);
    k->scope.in_loop = true;
    put(k, &k->body, "const int %s = (%s + 5 * %s) & %d;\n", other, w->first, w->counter,
        k->elements / 2 - 1);
    put(k, &k->body, "for (int %s = %s; %s < %s + %s; %s++)\n", i, w->first, i, w->first, w->length,
        i);
    put(k, &k->body, "for (int %s = %s; %s < %s + 5; %s++) {\n", j, other, j, other, j);
    put(k, &k->body, "const double %s = (%s * 0.5 + %s * 0.25) * 0.5 - 0.125;\n", e, value(k, 1),
        value(k, 1));
    add_name(&k->scope.values, e);
    put(k, &k->body, "%s;\n", update(k, a, text(k, form, a->base, i)));
    put(k, &k->body, "%s;\n", update(k, a, text(k, form, a->base, j)));
    put(k, &k->body, "}\n}\n");
}

void walk_along_elements(kernel *k) {
    const scope outside = k->scope;
    walk w = {.array = any_reduction(k)};
    put_bounds(k, &w);
    if (chance(k, 30)) {
        w.counter = new_name(k, "c");
        put_blocks(k, &w);
        k->scope = outside;
        return;
    }
    if (chance(k, 50)) {
        w.beside = new_name(k, "w");
        put(k, &k->body, "double %s = 0.25;\n", w.beside);
    }
    put_pointer(k, &w);
    put_walk(k, &w);
    k->scope = outside;
    if (chance(k, 25)) /* one element after the last one, or before the first */
        put(k, &k->body, "%s;\n", update(k, w.array, target(k, &w)));
    if (w.beside && chance(k, 40)) {
        const array *a = any_reduction(k);
        put(k, &k->body, "%s;\n",
            update(k, a, place(k, a, text(k, "(int)%s & %d", w.beside, k->elements - 1))));
    }
}
