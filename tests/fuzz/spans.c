/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Inner loops along a row of elements, which the inspector records at once, and loops that only
 * resemble them. Only in programs with seed % 3 == 0, so that other seeds yield the same programs
 * as before. */
#include "fuzz/kernel.h"

typedef struct span {
    const char *first, *length,
        *counter;      /* variables: elements first ... first + length, inner counter */
    const char *index; /* subscript of the element at the counter */
    const char *set;   /* a variable that the header sets as well, or NULL */
    bool is_left;      /* the counter's value is used after the loop */
} span;

/* Declares the bounds: first + length is less than the number of elements. */
static void put_bounds(kernel *k, span *s) {
    s->first = new_name(k, "first");
    s->length = new_name(k, "length");
    put(k, &k->body, "const int %s = (%s) & %d;\n", s->first, subscript(k), k->elements / 2 - 1);
    put(k, &k->body, "const int %s = (%s) & %d;\n", s->length, subscript(k),
        (k->elements / 2 - 1) & (chance(k, 80) ? 7 : 63));
}

/* The header also sets the variable from which elements are counted, which had another value
 * before. Only in programs with seed % 3 == 0 and seed % 7 == 2. */
static void put_header_that_sets(kernel *k, span *s) {
    const char *first = new_name(k, "h");
    s->set = first;
    if (s->is_left) {
        put(k, &k->body, "int %s = %d;\n", first, below(k, 5));
        put(k, &k->body, "for (%s = 0, %s = %s; %s < %s; %s++) ", s->counter, first, s->first,
            s->counter, s->length, s->counter);
    } else {
        put(k, &k->body, "for (int %s = 0, %s = %s; %s < %s; %s++) ", s->counter, first, s->first,
            s->counter, s->length, s->counter);
    }
    s->index = chance(k, 60) ? text(k, "%s + %s", first, s->counter)
                             : text(k, "%s + %s", s->first, s->counter);
}

/* Appends the header of a loop from the row's first element, or from 0. */
static void put_header(kernel *k, span *s) {
    static const char *const types[] = {"int", "long", "size_t", "unsigned", "short"};
    static const char *const sums[] = {"%s + %s", "%s + (int)%s", "(%s - 1) + %s + 1"};
    const bool is_outer = chance(k, 40);
    const char *type = is_outer ? "int" : types[below(k, 5)];
    s->counter = new_name(k, "c");
    s->is_left = is_outer;
    if (is_outer)
        declare_outside(k, "int", s->counter, k->without ? "0" : NULL);
    if (k->sets_in_headers && chance(k, 70)) {
        put_header_that_sets(k, s);
        return;
    }
    const char *declared = is_outer ? "" : text(k, "%s ", type);
    if (chance(k, 40)) {
        const char *less = chance(k, 20) ? text(k, " - (%s > 0)", s->first) : "";
        put(k, &k->body, "for (%s%s = (%s)%s; %s < (%s)(%s + %s%s); %s++) ", declared, s->counter,
            type, s->first, s->counter, type, s->first, s->length, less, s->counter);
        s->index = s->counter;
        return;
    }
    const int from = below(k, 3);
    put(k, &k->body, "for (%s%s = %d; %s %s (%s)%s; %s) ", declared, s->counter, from, s->counter,
        chance(k, 40) ? "<=" : "<", type, s->length,
        text(k, chance(k, 90) ? "%s++" : "%s += 2", s->counter));
    s->index = chance(k, 15) ? text(k, "%s + %s / 2", s->first, s->counter)
                             : text(k, sums[below(k, 3)], s->first, s->counter);
}

static void put_updates(kernel *k, const span *s) {
    for (int i = chance(k, 30); i >= 0; i--) {
        const array *a = any_reduction(k);
        if (chance(k, 12))
            put(k, &k->body, "if (%s)\n", condition(k));
        put(k, &k->body, "%s;\n", update(k, a, place(k, a, s->index)));
    }
    if (chance(k, 5))
        put(k, &k->body, "if (%s)\nbreak;\n", condition(k));
}

void loop_along_a_row(kernel *k) {
    const scope outside = k->scope;
    span s = {0};
    put_bounds(k, &s);
    put_header(k, &s);
    if (s.set)
        add_name(&k->scope.smalls, text(k, "(%s & 1)", s.set));
    k->scope.in_loop = true;
    put(k, &k->body, "{\n");
    put_updates(k, &s);
    put(k, &k->body, "}\n");
    k->scope = outside;
    const array *a = any_reduction(k);
    if (s.is_left && chance(k, 60))
        put(k, &k->body, "%s;\n",
            update(k, a, place(k, a, text(k, "(%s * 3) & %d", s.counter, k->elements - 1))));
}
