/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Statements of programs with even seeds: more ways to access the same memory, and more spellings
 * of the same operation. */
#include "fuzz/kernel.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

static const char *spelling(const array *a) {
    return elements[a->type].spelling;
}

/* Returns an array of the same kind as `a` with this name. */
static array called(const array *a, const char *base) {
    array b = *a;
    b.base = base;
    return b;
}

static void put_update(kernel *k, const array *a, const char *index) {
    put(k, &k->body, "%s;\n", update(k, a, place(k, a, index)));
}

/* Declares a pointer to the elements of `a` outside the loop, initialised by `from`. */
static const char *declare_pointer(kernel *k, const array *a, const char *from) {
    const char *name = new_name(k, "p");
    if (a->shape == SHAPE_ROWS)
        put(k, &k->locals, "    %s (*%s)[3] = %s;\n", spelling(a), name, from);
    else
        put(k, &k->locals, "    %s *%s = %s;\n",
            a->shape == SHAPE_RECORDS ? a->record : spelling(a), name, from);
    return name;
}

/* ---- mostly accepted ------------------------------------------------------------------------- */

static void call_with_index(kernel *k) {
    const array *a = any_reduction(k);
    const char *function = new_name(k, "function");
    const char *type = spelling(a);
    if (a->shape != SHAPE_FLAT || *a->operation == '<' || *a->operation == '>')
        return;
    put(k, &k->globals, "static void %s(%s *h, int k, %s v) {\n    h[k] %s= v;\n}\n", function,
        type, type, a->operation);
    const char *index = subscript(k);
    put(k, &k->body, "%s(%s, (int)(%s), %s);\n", function, a->base, index, contribution(k, a));
}

static void from_the_end(kernel *k) {
    const array *a = any_reduction(k);
    const array b = called(a, declare_pointer(k, a, text(k, "%s + %d", a->base, k->elements - 1)));
    put_update(k, &b, text(k, "-(int)(%s)", subscript(k)));
}

static void rows_of_four(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "p");
    if (a->shape != SHAPE_FLAT)
        return;
    put(k, &k->locals, "    %s (*%s)[4] = (%s (*)[4])%s;\n", spelling(a), name, spelling(a),
        a->base);
    const char *index = new_name(k, "k");
    put(k, &k->body, "int %s = (int)(%s);\n", index, subscript(k));
    const char *where = text(k, "%s[%s >> 2][%s & 3]", name, index, index);
    put(k, &k->body, "%s;\n", update(k, a, where));
}

static void by_macro(kernel *k) {
    const array *a = any_reduction(k);
    if (a->shape != SHAPE_FLAT || *a->operation != '+')
        return;
    const char *index = subscript(k);
    put(k, &k->body, "PUT(%s, %s, %s);\n", a->base, index, contribution(k, a));
}

static void narrow_subscript(kernel *k) {
    static const char *const types[] = {"unsigned char", "unsigned short", "long long"};
    const char *name = new_name(k, "k");
    const char *e = subscript(k);
    put(k, &k->body, "%s %s = (%s)(%s);\n", types[below(k, 3)], name, types[0], e);
    add_name(&k->scope.subscripts, name);
}

/* own[i] is stored and read again in the same iteration, as a subscript. */
static void forwarded(kernel *k) {
    const char *name = new_name(k, "own");
    const char *i = k->scope.positions.name[0];
    put(k, &k->globals, "static int %s[%d];\n", name, k->size);
    put(k, &k->body, "%s[%s] = (int)(%s);\n", name, i, subscript(k));
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", name, name, name);
    add_name(&k->scope.subscripts, text(k, "%s[%s]", name, i));
}

static void counted(kernel *k) {
    const char *name = new_name(k, "count");
    put(k, &k->locals, "    unsigned char %s = 250;\n", name);
    if (chance(k, 50))
        put(k, &k->body, "if (%s)\n", condition(k));
    put(k, &k->body, "%s += %s;\n", name, integer(k, 1));
    put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, name);
}

void wide_statement(kernel *k) {
    static void (*const kinds[])(kernel * k) = {
        call_with_index, from_the_end, rows_of_four, by_macro, narrow_subscript, forwarded, counted,
    };
    kinds[below(k, LENGTH(kinds))](k);
}

/* ---- mostly refused -------------------------------------------------------------------------- */

static void moved_pointer(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = declare_pointer(k, a, text(k, "%s + 9", a->base));
    put(k, &k->locals, "    %s -= %d;\n    %s++;\n", name, below(k, 9), name);
    const array b = called(a, name);
    put_update(k, &b, subscript(k));
}

/* Two members of a struct point to one array: the loop updates through one of them, and updates or
 * reads through the other. */
static void members(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "both");
    if (a->shape != SHAPE_FLAT)
        return;
    put(k, &k->locals, "    struct {\n        %s *one, *two;\n    } %s = {%s, %s + %d};\n",
        spelling(a), name, a->base, a->base, below(k, 7));
    const array one = called(a, text(k, "%s.one", name));
    const array two = called(a, text(k, "%s.two", name));
    put_update(k, &one, subscript(k));
    if (chance(k, 50))
        put_update(k, &two, subscript(k));
    else if (a->type != E_COMPLEX)
        put(k, &k->body, "%s[%s] = (double)%s[%s];\n", k->out.base, k->scope.positions.name[0],
            two.base, subscript(k));
}

static void pointer_to_pointer(kernel *k) {
    const array *a = any_reduction(k);
    const char *at = new_name(k, "at");
    if (a->shape != SHAPE_FLAT)
        return;
    const char *name = declare_pointer(k, a, a->base);
    put(k, &k->locals, "    %s **%s = &%s;\n", spelling(a), at, name);
    if (chance(k, 40))
        put(k, &k->body, "*%s = %s + (%s & 1);\n", at, a->base, integer(k, 0));
    const array b = called(a, chance(k, 50) ? text(k, "(*%s)", at) : name);
    put_update(k, &b, subscript(k));
}

static void chosen_base(kernel *k) {
    const array *a = any_reduction(k);
    if (a->shape != SHAPE_FLAT)
        return;
    const char *when = condition(k);
    const array b = called(a, text(k, "(%s ? %s : %s + 1)", when, a->base, a->base));
    put_update(k, &b, subscript(k));
}

static void walking_pointer(kernel *k) {
    const char *name = new_name(k, "p");
    const char *value_name = new_name(k, "d");
    if (k->scope.in_loop || k->scope.depth)
        return;
    put(k, &k->locals, "    const double *%s = %s;\n", name, k->other.base);
    put(k, &k->body, "double %s = damp(*%s);\n%s++;\n", value_name, name, name);
    add_name(&k->scope.values, value_name);
}

static void jumped_over(kernel *k) {
    const char *label = new_name(k, "next");
    put(k, &k->body, "if (%s)\ngoto %s;\n", condition(k), label);
    const array *a = any_reduction(k);
    put_update(k, a, subscript(k));
    put(k, &k->body, "%s:;\n", label);
}

static void neighbours_stored(kernel *k) {
    const char *i = k->scope.positions.name[0];
    const char *first = value(k, 1);
    put(k, &k->body, "%s[%s] = %s;\n%s[%s + %d] = %s;\n", k->out.base, i, first, k->out.base, i,
        1 + below(k, 3), value(k, 1));
}

static void scattered_store(kernel *k) {
    const char *index = subscript(k);
    put(k, &k->body, "%s[%s] = %s;\n", k->out.base, index, value(k, 1));
}

/* One text that denotes two variables. */
static void shadowed(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "k");
    put(k, &k->body, "int %s = (int)(%s);\n{\n", name, subscript(k));
    put(k, &k->body, "const int before = %s;\nint %s = before ^ 1;\n", name, name);
    put_update(k, a, name);
    put(k, &k->body, "}\n");
    put_update(k, a, name);
}

void wide_bait(kernel *k) {
    static void (*const kinds[])(kernel * k) = {
        moved_pointer, members,           pointer_to_pointer, chosen_base, walking_pointer,
        jumped_over,   neighbours_stored, scattered_store,    shadowed,    nearly_stored_again,
    };
    kinds[below(k, LENGTH(kinds))](k);
}
