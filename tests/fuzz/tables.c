/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Small tables that one loop fills and later loops read, by subscripts or through pointers that
 * step. Some loops do not fill all elements that are read. Only in programs with seed % 8 == 3. */
#include "fuzz/kernel.h"

typedef enum way { BY_SUBSCRIPT, BY_HEADER, BY_USE, BY_END, SET_BEFORE, WAYS } way;

typedef struct table {
    const char *name, *length, *low, *start; /* start: first value of the pointers */
    const char *pointers[2], *counter;
    bool is_integer, is_outside;
    const char *step; /* the pointers' step */
} table;

/* Declares the table, initialised so that no element is undefined, whatever the loops leave out. */
static table declare_table(kernel *k) {
    const char *name = new_name(k, "w"), *counter = new_name(k, "c"), *low = new_name(k, "low");
    const bool is_integer = chance(k, 40), is_outside = chance(k, 75);
    const char *type = is_integer ? "int" : "double";
    table w = {.name = name,
               .counter = counter,
               .low = low,
               .is_integer = is_integer,
               .is_outside = is_outside};
    put(k, is_outside ? &k->locals : &k->body, "    %s %s[64] = {0};\n", type, name);
    for (int i = 0; i < 2; i++) {
        w.pointers[i] = new_name(k, "p");
        put(k, is_outside ? &k->locals : &k->body, "    %s *%s = 0;\n", type, w.pointers[i]);
    }
    put(k, &k->locals, "    int %s = 0;\n", counter);
    w.length = new_name(k, "length");
    put(k, &k->body, "const int %s = (%s) & 7;\n", w.length, subscript(k));
    put(k, &k->body, "int %s = (%s) & 7;\n(void)%s;\n", low, subscript(k), low);
    const int which = below(k, 4);
    w.start = which == 0   ? text(k, "%s + 2", name)
              : which == 1 ? text(k, "&%s[1]", name)
              : which == 2 ? text(k, "%s + %s", name, low)
                           : name;
    w.step = chance(k, 25) ? "+= 2" : "++";
    return w;
}

/* Appends the loop's header and, before it, the statement that sets the pointer. */
static void put_head(kernel *k, const table *w, way by, const char *p) {
    const char *start = chance(k, 6) ? text(k, "%s + 1", w->start) : w->start;
    const char *length = chance(k, 6) ? text(k, "%s + 1", w->length) : w->length;
    const char *step = chance(k, 6) ? "+= 3" : w->step;
    if (by == SET_BEFORE)
        put(k, &k->body, "%s = %s;\n", p, start);
    if (by == SET_BEFORE && chance(k, 8))
        put(k, &k->body, "if (%s)\n%s++;\n", condition(k), p);
    if (by == SET_BEFORE || by == BY_SUBSCRIPT)
        put(k, &k->body, "for (%s = 0; %s < %s; %s++", w->counter, w->counter, length, w->counter);
    else
        put(k, &k->body, "for (%s = %s, %s = 0; %s < %s; %s++", p, start, w->counter, w->counter,
            length, w->counter);
    if (by == BY_HEADER)
        put(k, &k->body, ", %s %s", p, step);
    put(k, &k->body, ") {\n");
    if (by != BY_USE && chance(k, 6))
        put(k, &k->body, "if (%s)\n%s;\n", condition(k),
            chance(k, 50) ? "continue" : text(k, "%s = %s", w->counter, w->counter));
}

static const char *element_of(kernel *k, const table *w, way by, const char *p) {
    if (by == BY_SUBSCRIPT)
        return text(k, chance(k, 95) ? "%s[%s]" : "%s[%s + 1]", w->name, w->counter);
    if (by == BY_USE || by == SET_BEFORE)
        return text(k, "*%s++", p);
    return text(k, chance(k, 90) ? (chance(k, 50) ? "*%s" : "%s[0]") : "%s[1]", p);
}

static void put_end(kernel *k, const table *w, way by, const char *p) {
    if (by == BY_END && chance(k, 6))
        put(k, &k->body, "if (%s)\n", condition(k));
    if (by == BY_END)
        put(k, &k->body, "%s %s;\n", p, w->step);
    put(k, &k->body, "}\n");
}

static void put_writer(kernel *k, const table *w, way by) {
    const char *p = w->pointers[0];
    put_head(k, w, by, p);
    if (chance(k, 6))
        put(k, &k->body, "if (%s)\n", condition(k));
    put(k, &k->body, "%s = %s;\n", element_of(k, w, by, p),
        w->is_integer ? subscript(k) : text(k, "(%s) * 0.5", value(k, 1)));
    put_end(k, w, by, p);
}

static void put_reader(kernel *k, const table *w, way by) {
    const scope outside = k->scope;
    const array *a = any_reduction(k);
    const char *p = w->pointers[below(k, 2)], *v = new_name(k, "v");
    put_head(k, w, by, p);
    k->scope.in_loop = true;
    put(k, &k->body, "const %s %s = %s;\n", w->is_integer ? "int" : "double", v,
        element_of(k, w, by, p));
    if (!w->is_integer)
        add_name(&k->scope.values, v);
    const char *where = w->is_integer ? text(k, "%s & %d", v, k->elements - 1) : subscript(k);
    put(k, &k->body, "%s;\n(void)%s;\n", update(k, a, place(k, a, where)), v);
    put_end(k, w, by, p);
    k->scope = outside;
}

void tables_by_pointers(kernel *k) {
    const scope outside = k->scope;
    const table w = declare_table(k);
    const way by = (way)below(k, WAYS);
    put_writer(k, &w, by);
    if (chance(k, 10))
        put(k, &k->body, "%s = (%s) & 7;\n", w.low, subscript(k));
    for (int left = 1 + chance(k, 40); left > 0; left--)
        put_reader(k, &w, chance(k, 85) ? by : (way)below(k, WAYS));
    if (w.is_outside && chance(k, 8))
        put(k, &k->after, "    live[%d] = (double)%s[3];\n", k->live++ % 8, w.name);
    k->scope = outside;
}
