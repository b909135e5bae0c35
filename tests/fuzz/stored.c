/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Elements that an iteration stores and reads again, and elements that only seem to be the same. */
#include "fuzz/kernel.h"

#include <string.h>

#define LENGTH(stored) (int)(sizeof(stored) / sizeof *(stored))

/* Declares an array of the program for stored subscripts or values, which is compared in the
 * end. */
static const char *new_stored(kernel *k, bool is_value) {
    static const char *const integers[] = {"int", "int", "short", "unsigned char", "long"};
    static const char *const floats[] = {"double", "double", "float"};
    const char *name = new_name(k, "stored");
    const char *type = is_value ? floats[below(k, LENGTH(floats))] : integers[below(k, 5)];
    put(k, &k->globals, "static %s %s[%d];\n", type, name, k->size);
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", name, name, name);
    return name;
}

/* Returns the iteration's own element, or one that others store to as well. */
static const char *element_of(kernel *k, const char *stored) {
    const char *p = k->scope.positions.name[0];
    if (k->scope.subscripts.count && chance(k, 25))
        return text(k, "%s[%s]", stored, any_name(k, &k->scope.subscripts));
    return below(k, 3) ? text(k, "%s[%s]", stored, p)
                       : text(k, "%s[%s + %d]", stored, p, below(k, 9));
}

void stored_again(kernel *k) {
    const bool is_value = chance(k, 50);
    const char *stored = is_value && chance(k, 30) ? k->out.base : new_stored(k, is_value);
    const char *e = element_of(k, stored);
    put(k, &k->body, "%s = %s;\n", e, is_value ? value(k, 1) : subscript(k));
    add_name(is_value ? &k->scope.values : &k->scope.subscripts, e);
}

void nearly_stored_again(kernel *k) {
    const char *stored = new_stored(k, false);
    const char *p = k->scope.positions.name[0];
    const char *e = text(k, "%s[%s]", stored, p), *read = e;
    switch (below(k, 6)) {
    case 0: /* another element */
        put(k, &k->body, "%s = %s;\n", e, subscript(k));
        read = text(k, "%s[%s + 1]", stored, p);
        break;
    case 1: { /* stored in some iterations only */
        const char *when = condition(k);
        put(k, &k->body, "if (%s) {\n%s = %s;\n}\n", when, e, subscript(k));
        break;
    }
    case 2: { /* the subscript changes before the read */
        const char *at = new_name(k, "k");
        put(k, &k->body, "int %s = %s;\n", at, subscript(k));
        e = read = text(k, "%s[%s]", stored, at);
        put(k, &k->body, "%s = %s;\n%s ^= 1;\n", e, subscript(k), at);
        break;
    }
    case 3: { /* stored under another name */
        const char *name = new_name(k, "p");
        put(k, &k->body, "__typeof__(&%s[0]) %s = &%s;\n", stored, name, e);
        put(k, &k->body, "%s = %s;\n", e, subscript(k));
        read = text(k, "*%s", name);
        break;
    }
    case 4: /* computed from the old value */
        put(k, &k->body, "%s = (%s + %s) & %d;\n", e, e, subscript(k), k->elements - 1);
        break;
    default: { /* read first: the value of the previous call */
        const char *name = new_name(k, "k");
        put(k, &k->body, "int %s = %s;\n", name, e);
        put(k, &k->body, "%s = %s;\n", e, subscript(k));
        read = name;
        break;
    }
    }
    add_name(&k->scope.subscripts, read);
}

/* Returns a store, mostly of a constant or an invariant value. */
static const char *store_to(kernel *k, const char *drained, const char *own, bool is_floating) {
    const char *stays = new_name(k, "stays"), *p = k->scope.positions.name[0];
    put(k, &k->locals, "    const %s %s = %d;\n", is_floating ? "double" : "int", stays,
        below(k, 4));
    const char *to = chance(k, 8) ? text(k, "%s[%s + 1]", drained, p) : own;
    const int which = below(k, 6);
    const char *store = which == 4 && is_floating ? text(k, "%s = %s;\n", to, value(k, 0))
                        : which == 0              ? text(k, "%s = 0;\n", to)
                        : which == 1              ? text(k, "%s = %s;\n", to, stays)
                        : which == 2              ? text(k, "%s *= 0.5;\n", to)
                                                  : text(k, "%s -= %s;\n", to, stays);
    const int when = below(k, 6);
    if (when > 1)
        return store;
    const char *what = when ? text(k, "%s > %s", own, stays) : text(k, "%s & 1", p);
    return chance(k, 50) ? text(k, "if (%s)\n%s", what, store)
                         : text(k, "if (%s) {\n%s}\n", what, store);
}

const char *read_then_stored(kernel *k) {
    static const char *const types[] = {"double", "double", "float", "int"};
    const char *type = types[below(k, LENGTH(types))], *p = k->scope.positions.name[0];
    const bool is_floating = strcmp(type, "int") != 0;
    const array *h = &k->reduction[0];
    const char *drained = new_name(k, "drained"), *object = text(k, "%s_all", drained);
    put(k, &k->globals, "static %s %s[%d];\n", type, object, k->size);
    put(k, &k->locals, "    for (int q = 0; q < %d; q++)\n        %s[q] = q * 7 %% 13;\n", k->size,
        object);
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", object, object, object);
    const bool is_one = k->is_masked && h->type == E_DOUBLE && h->shape == SHAPE_FLAT &&
                        strcmp(type, "double") == 0 && chance(k, 15);
    put(k, &k->locals, "    %s *%s = %s;\n", type, drained, is_one ? h->object : object);
    const char *own = chance(k, 70) ? text(k, "%s[%s]", drained, p)
                                    : text(k, "%s[%s + %d]", drained, p, below(k, 9));
    const char *read = new_name(k, "read");
    put(k, &k->body, "const double %s = %s;\n", read, is_one ? text(k, "damp(%s)", own) : own);
    add_name(&k->scope.values, read);
    return store_to(k, drained, own, is_floating);
}

/* sum += f(v, p): the call fills an array of the iteration, or one that is declared outside. */
void filling_operand(kernel *k) {
    const bool is_integer = chance(k, 30);
    const char *type = is_integer ? "int" : "double", *function = new_name(k, "fill");
    const char *sum = new_name(k, "filled"), *p = new_name(k, "part");
    put(k, &k->globals,
        "static %s %s(%s v, %s *p) {\n    p[0] = v + 1;\n    p[1] = 3 - v;\n    return v + 2;\n}\n",
        type, function, type, type);
    declare_outside(k, is_integer ? "long" : "double", sum, "0");
    put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, sum);
    put(k, chance(k, 75) ? &k->body : &k->locals, "%s %s[2] = {0};\n", type, p);
    if (chance(k, 20))
        put(k, &k->body, "if (%s)\n", condition(k));
    put(k, &k->body, "%s += %s(%s, %s);\n", sum, function, is_integer ? subscript(k) : value(k, 1),
        p);
    if (!is_integer)
        add_name(&k->scope.values, text(k, "%s[%d]", p, below(k, 2)));
    else if (chance(k, 40))
        add_name(&k->scope.subscripts, text(k, "(%s[0] & %d)", p, k->elements - 1));
}

/* Sums that are no variables: members, elements, and targets of pointers. */
void sum_in_memory(kernel *k) {
    static const char *const places[] = {"%s.x", "%s.y[1]", "%s.y[0]", "at_%s->x", "at_%s->y[2]"};
    static const char *const types[] = {"double", "double", "float", "long", "unsigned char"};
    const int type = below(k, LENGTH(types));
    const char *name = new_name(k, "total");
    put(k, chance(k, 30) ? &k->globals : &k->locals,
        "    %sstruct {\n        %s x, y[3];\n    } %s%s;\n", chance(k, 30) ? "static " : "",
        types[type], name, " = {0}");
    const int count = 1 + below(k, 2);
    const bool is_pointed_to = chance(k, 30);
    if (is_pointed_to)
        put(k, &k->locals, "    __typeof__(%s) *const at_%s = &%s;\n", name, name, name);
    for (int i = 0; i < count; i++) {
        const char *form = places[below(k, is_pointed_to ? LENGTH(places) : 3)];
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
        const char *place = text(k, form, name);
#pragma GCC diagnostic pop
        if (chance(k, 20))
            put(k, &k->body, "if (%s)\n", condition(k));
        put(k, &k->body, chance(k, 80) ? "%s += %s;\n" : "%s -= %s;\n", place,
            type < 3 ? value(k, 0) : subscript(k));
        if (chance(k, 8))
            add_name(&k->scope.values, text(k, "(double)%s", place));
    }
    put(k, &k->after, "    live[%d] = (double)%s.x + %s.y[0] * 2 + %s.y[1] + %s.y[2];\n",
        k->live++ % 8, name, name, name, name);
}
