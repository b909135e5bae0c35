/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Statements that resemble those of accepted loops and mostly prevent the transformation. */
#include <string.h>

#include "fuzz/kernel.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

static const char *spelling(const array *a) {
    return elements[a->type].spelling;
}

static bool is_integer(const array *a) {
    return !elements[a->type].is_floating;
}

/* Declares a variable with the value of an expression of the array's type. */
static void take(kernel *k, const array *a, const char *e) {
    if (is_integer(a)) {
        const char *name = new_name(k, "k");
        put(k, &k->body, "int %s = (int)(%s) & %d;\n", name, e, k->elements - 1);
        add_name(&k->scope.subscripts, name);
    } else {
        const char *name = new_name(k, "d");
        put(k, &k->body, "double %s = damp((double)%s);\n", name, e);
        add_name(&k->scope.values, name);
    }
}

/* ---- the arrays read or stored --------------------------------------------------------------- */

static void read_array(kernel *k) {
    const array *a = any_reduction(k);
    const char *index = chance(k, 50) ? position(k) : subscript(k);
    take(k, a, place(k, a, index));
}

static void read_through_pointer(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "p");
    if (a->shape != SHAPE_FLAT)
        return;
    put(k, &k->locals, "    %s *const %s = &%s[%d];\n", spelling(a), name, a->base, below(k, 9));
    take(k, a, text(k, "%s[%s]", name, position(k)));
}

static void read_by_callee(kernel *k) {
    const array *a = any_reduction(k);
    const char *function = new_name(k, "function");
    const char *first = place(k, a, "0");
    const char *member = "";
    const char *type = spelling(a);
    if (a->shape == SHAPE_RECORDS) { /* the next member has another type */
        member = first[strlen(first) - 1] == 'x' ? ".x" : ".y";
        first = text(k, "%s[0]", a->base);
        type = a->record;
    }
    put(k, &k->globals, "static %s %s(const %s *p, int k) {\n    return p[k]%s;\n}\n", spelling(a),
        function, type, member);
    take(k, a, text(k, "%s(&%s, (int)(%s))", function, first, subscript(k)));
}

static void read_bytes(kernel *k) {
    array *a = any_reduction(k);
    const char *name = new_name(k, "bytes");
    put(k, &k->locals, "    unsigned char *%s = (unsigned char *)%s;\n", name, a->base);
    const char *at = subscript(k);
    if (chance(k, 50)) {
        a->is_no_integer = true;
        put(k, &k->body, "%s[(%s) * sizeof *%s] ^= 1;\n", name, at, a->base);
        return;
    }
    const char *value_name = new_name(k, "k");
    put(k, &k->body, "int %s = %s[%s] & %d;\n", value_name, name, at, k->elements - 1);
    add_name(&k->scope.subscripts, value_name);
}

static void store_plainly(kernel *k) {
    const array *a = any_reduction(k);
    const char *index = chance(k, 50) ? position(k) : subscript(k);
    const char *where = place(k, a, index);
    put(k, &k->body, "%s = %s;\n", where, contribution(k, a));
}

static void other_operator(kernel *k) {
    array *a = any_reduction(k);
    const char *where = place(k, a, subscript(k));
    if (is_integer(a)) {
        static const char *const operations[] = {"|=", "&=", "^=", "-=", "/=", "%="};
        put(k, &k->body, "%s %s %d;\n", where, operations[below(k, 6)], 1 + below(k, 30));
    } else { /* after enough halvings its sums are rounded */
        a->is_no_integer = true;
        put(k, &k->body, below(k, 2) ? "%s *= 0.5;\n" : "%s /= 2;\n", where);
    }
}

static void reversed(kernel *k) {
    const array *a = any_reduction(k);
    const char *where = place(k, a, subscript(k));
    put(k, &k->body, "%s = %s - %s;\n", where, contribution(k, a), where);
}

static void use_update(kernel *k) {
    const array *a = any_reduction(k);
    const char *where = place(k, a, subscript(k));
    if (a->type == E_COMPLEX)
        return;
    if (is_integer(a) && chance(k, 50))
        put(k, &k->body, "%s[%s++ & %d] = 0.5;\n", k->out.base, where, k->elements - 1);
    else
        take(k, a, text(k, below(k, 2) ? "%s--" : "++%s", where));
}

static void set_memory(kernel *k) {
    const array *a = any_reduction(k);
    const char *index = subscript(k);
    put(k, &k->body, "memset(&%s[%s], 0, sizeof *%s);\n", a->base, index, a->base);
}

static void copy_element(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "copy");
    const char *index = subscript(k);
    if (a->shape != SHAPE_RECORDS)
        return;
    put(k, &k->body, "%s %s = %s[%s];\n", a->record, name, a->base, index);
    take(k, a, text(k, "%s.y", name));
}

static void use_tag(kernel *k) {
    const array *a = any_reduction(k);
    const char *index = subscript(k);
    const char *name = new_name(k, "k");
    if (a->shape != SHAPE_RECORDS)
        return;
    if (chance(k, 25)) {
        put(k, &k->body, "%s[%s].tag = 5;\n", a->base, index);
        return;
    }
    put(k, &k->body, "int %s = %s[%s].tag & %d;\n", name, a->base, index, k->elements - 1);
    add_name(&k->scope.subscripts, name);
}

static void second_base(kernel *k) {
    const array *a = any_reduction(k);
    array b = *a;
    const char *name = new_name(k, "p");
    if (a->shape == SHAPE_ROWS)
        put(k, &k->locals, "    %s (*%s)[3] = %s + %d;\n", spelling(a), name, a->base, below(k, 9));
    else if (a->shape == SHAPE_FLAT)
        put(k, &k->locals, "    %s *%s = %s + %d;\n", spelling(a), name, a->base, below(k, 9));
    else
        return;
    b.base = name;
    put(k, &k->body, "%s;\n", update(k, &b, place(k, &b, subscript(k))));
}

static void flat_rows(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "p");
    if (a->shape != SHAPE_ROWS)
        return;
    put(k, &k->locals, "    %s *%s = (%s *)%s;\n", spelling(a), name, spelling(a), a->base);
    array b = *a;
    b.base = name;
    b.shape = SHAPE_FLAT;
    put(k, &k->body, "%s;\n", update(k, &b, place(k, &b, subscript(k))));
}

static void local_row(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "p");
    put(k, &k->body, "%s *%s = &%s;\n", spelling(a), name, place(k, a, subscript(k)));
    put(k, &k->body, "%s;\n", update(k, a, text(k, "(*%s)", name)));
}

static void swinging_base(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "p");
    if (a->shape != SHAPE_FLAT)
        return;
    put(k, &k->locals, "    %s *%s = %s;\n", spelling(a), name, a->base);
    put(k, &k->body, "if (%s)\n%s = %s == %s ? %s + 1 : %s;\n", condition(k), name, name, a->base,
        a->base, a->base);
    put(k, &k->body, "%s;\n", update(k, a, text(k, "%s[%s]", name, subscript(k))));
}

static void paired_extremum(kernel *k) {
    const array *a = &k->reduction[0];
    const char *where = place(k, a, subscript(k));
    const char *e = contribution(k, a);
    if (a->type == E_COMPLEX)
        return;
    put(k, &k->body, "if (%s < %s) {\n%s = %s;\n%s[%s] = 0.5;\n}\n", where, e, where, e,
        k->out.base, subscript(k));
}

static void in_expression(kernel *k) {
    const array *a = any_reduction(k);
    const char *where = place(k, a, subscript(k));
    const char *when = condition(k);
    switch (below(k, 4)) {
    case 0:
        put(k, &k->body, "if ((%s) && (%s += 1) != 0)\n;\n", when, where);
        break;
    case 1:
        put(k, &k->body, "%s += 1, %s -= 1;\n", where, place(k, a, subscript(k)));
        break;
    case 2:
        put(k, &k->body, "(void)((%s) ? (%s += 1) : 0);\n", when, where);
        break;
    default:
        put(k, &k->body, "%s = %s += 1;\n", place(k, a, subscript(k)), where);
        break;
    }
}

static void separate_bits(kernel *k) {
    const char *name = new_name(k, "bits");
    put(k, &k->globals, "static struct {\n    unsigned a : 4, b : 12;\n} %s[%d];\n", name, k->size);
    put(k, &k->body, "%s[%s].%c++;\n", name, subscript(k), chance(k, 50) ? 'a' : 'b');
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", name, name, name);
}

static void row_pointers(kernel *k) {
    const char *name = new_name(k, "rows");
    const char *room = new_name(k, "room");
    put(k, &k->globals, "static double %s[%d];\nstatic double *%s[%d];\n", room, k->size, name,
        k->size);
    put(k, &k->locals, "    for (int r = 0; r < %d; r++)\n        %s[r] = %s + (r * 5 & %d);\n",
        k->size, name, room, k->elements - 1);
    put(k, &k->body, "%s[%s][%d] += %s;\n", name, subscript(k), below(k, 3), value(k, 1));
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", name, room, room);
}

/* ---- subscripts changed ---------------------------------------------------------------------- */

static void store_subscript(kernel *k) {
    const array *a = &k->subscript[below(k, SUBSCRIPTS)];
    const char *at = position(k);
    put(k, &k->body, a->shape == SHAPE_ROWS ? "%s[%s][1] = %s;\n" : "%s[%s] = %s;\n", a->base, at,
        subscript(k));
}

static void pointer_to_subscript(kernel *k) {
    const array *a = &k->subscript[0];
    const char *name = new_name(k, "p");
    put(k, &k->locals, "    %s *%s = &%s[%d];\n", spelling(a), name, a->base, below(k, 30));
    const char *where = text(k, chance(k, 50) ? "*%s" : "%s[2]", name);
    put(k, &k->body, "%s = %s;\n", where, subscript(k));
}

static void store_bound_of_rows(kernel *k) {
    put(k, &k->body, "%s[%s] = %s;\n", k->chain.base, subscript(k), subscript(k));
}

static void side_effect_subscript(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "j");
    declare_outside(k, "int", name, "0");
    const char *where = place(k, a, text(k, "%s++ & %d", name, k->elements - 1));
    if (*a->operation == '<' || *a->operation == '>')
        return;
    put(k, &k->body, "%s %s= %s;\n", where, a->operation, contribution(k, a));
}

static void secondary_counter(kernel *k) {
    const char *name = new_name(k, "j");
    declare_outside(k, "int", name, text(k, "%d", below(k, 5)));
    put(k, &k->body, "int %s_at = %s & %d;\n%s += %d;\n", name, name, k->elements - 1, name,
        1 + below(k, 3));
    add_name(&k->scope.subscripts, text(k, "%s_at", name));
}

static void found_subscript(kernel *k) {
    const char *name = new_name(k, "k");
    put(k, &k->body, "int %s;\nfor (%s = 0; %s < 5; %s++)\nif (%s[%s + %s] & 1)\nbreak;\n", name,
        name, name, name, k->flag.base, k->scope.positions.name[0], name);
    add_name(&k->scope.subscripts, name);
}

static void assigned_in_condition(kernel *k) {
    const char *name = new_name(k, "k");
    const char *when = condition(k);
    put(k, &k->body, "int %s = 1;\nif ((%s) && (%s = %s) > 3) {\n", name, when, name, subscript(k));
    add_name(&k->scope.subscripts, name);
    block(k, 1);
    put(k, &k->body, "}\n");
}

static void subscript_through_pointer(kernel *k) {
    const char *name = new_name(k, "k");
    const char *e = subscript(k);
    put(k, &k->body, "int %s = 2;\nint *%s_at = &%s;\nif (%s)\n*%s_at = %s;\n", name, name, name,
        condition(k), name, e);
    add_name(&k->scope.subscripts, name);
}

static void copied_subscripts(kernel *k) {
    const array *a = &k->subscript[0];
    const char *name = new_name(k, "copy");
    put(k, &k->body, "%s %s[2];\nmemcpy(%s, &%s[%s], sizeof %s);\n", spelling(a), name, name,
        a->base, position(k), name);
    add_name(&k->scope.subscripts,
             text(k, "(int)(%s[%d] & %d)", name, below(k, 2), k->elements - 1));
}

/* ---- values carried from one iteration to the next ------------------------------------------- */

static void carried_value(kernel *k) {
    const char *name = new_name(k, "previous");
    const char *copy = new_name(k, "d");
    declare_outside(k, "double", name, "0.25");
    put(k, &k->body, "double %s = %s;\n", copy, name);
    if (chance(k, 50))
        put(k, &k->body, "if (%s)\n", condition(k));
    put(k, &k->body, "%s = %s;\n", name, value(k, 1));
    add_name(&k->scope.values, copy);
}

static void carried_subscript(kernel *k) {
    const char *name = new_name(k, "k");
    const char *e = subscript(k);
    if (chance(k, 50)) {
        declare_outside(k, "int", name, "1");
        put(k, &k->body, "if (%s)\n%s = %s;\n", condition(k), name, e);
    } else {
        put(k, &k->body, "static int %s;\nint %s_before = %s;\n%s = %s;\n", name, name, name, name,
            e);
        name = text(k, "%s_before", name);
    }
    add_name(&k->scope.subscripts, name);
}

static void partly_written(kernel *k) {
    const char *name = new_name(k, "f");
    put(k, &k->locals, "    double %s[3] = {0.5, 1, 2};\n", name);
    const char *v = value(k, 1);
    switch (below(k, 4)) {
    case 0:
        put(k, &k->body, "%s[0] = %s;\n", name, v);
        break;
    case 1:
        put(k, &k->body, "%s[%s & 1] = %s;\n", name, k->scope.positions.name[0], v);
        break;
    case 2:
        put(k, &k->body, "for (int r = 0; r < (%s & 3); r++)\n%s[r] = %s;\n", integer(k, 0), name,
            v);
        break;
    default:
        put(k, &k->body, "for (int r = 0; r < 3; r++)\nif (%s)\n%s[r] = %s;\n", condition(k), name,
            v);
        break;
    }
    add_name(&k->scope.values, text(k, "%s[%d]", name, below(k, 3)));
}

static void neighbour_store(kernel *k) {
    const char *i = k->scope.positions.name[0];
    put(k, &k->body, "%s[%s] = damp(%s[%s ? %s - 1 : 0]) + %s;\n", k->out.base, i, k->out.base, i,
        i, value(k, 1));
}

static void conditional_last(kernel *k) {
    const char *name = new_name(k, "last");
    declare_outside(k, "int", name, "0");
    put(k, &k->body, "if (%s)\n%s = %s;\n", condition(k), name, subscript(k));
    put(k, &k->after, "    live[%d] = %s;\n", k->live++ % 8, name);
}

static void kept_address(kernel *k) {
    const char *name = new_name(k, "kept");
    const char *own = new_name(k, "d");
    put(k, &k->globals, "static double *%s;\nstatic double read_%s(void) { return *%s; }\n", name,
        name, name);
    declare_outside(k, "double", own, "0");
    put(k, &k->locals, "    %s = &%s;\n", name, own);
    put(k, &k->body, "%s = %s;\n", own, value(k, 1));
    add_name(&k->scope.values, chance(k, 50) ? text(k, "read_%s()", name) : text(k, "(*%s)", name));
}

static void thread_local_value(kernel *k) {
    const char *name = new_name(k, "own");
    put(k, &k->globals, "static _Thread_local double %s = 0.5;\n", name);
    if (chance(k, 50))
        put(k, &k->body, "%s = %s;\n", name, value(k, 1));
    else
        put(k, &k->locals, "    %s = 1.5;\n", name);
    add_name(&k->scope.values, name);
}

/* The value is negated in its representation, so small integers stay exact. */
static void punned_value(kernel *k) {
    const char *name = new_name(k, "u");
    put(k, &k->body,
        "union {\ndouble d;\nunsigned char b[8];\n} %s;\n%s.d = %s;\n%s.b[7] ^= 0x80;\n", name,
        name, value(k, 1), name);
    add_name(&k->scope.values, text(k, "%s.d", name));
}

/* ---- functions with effects ------------------------------------------------------------------ */

static void counting_callee(kernel *k) {
    const char *function = new_name(k, "function");
    const char *name = new_name(k, "k");
    if (chance(k, 50))
        put(k, &k->globals,
            "static int %s(void) {\n    static int calls;\n    return calls++ & 31;\n}\n",
            function);
    else
        put(k, &k->globals,
            "static int calls_%s;\nstatic int %s(void) {\n    return calls_%s++ & 31;\n}\n",
            function, function, function);
    put(k, &k->body, "int %s = %s();\n", name, function);
    add_name(&k->scope.subscripts, name);
}

static void storing_callee(kernel *k) {
    const array *a = any_reduction(k);
    const char *function = new_name(k, "function");
    const char *index = subscript(k);
    put(k, &k->globals, "static void %s(%s *p, int k) {\n    p[k] %s 1;\n}\n", function,
        spelling(a), chance(k, 50) ? "=" : "+=");
    put(k, &k->body, "%s(&%s, (int)(%s));\n", function, place(k, a, "0"), index);
}

static void recursive_callee(kernel *k) {
    const char *function = new_name(k, "function");
    const char *name = new_name(k, "k");
    put(k, &k->globals, "static int %s(int k) {\n    return k > 1 ? 1 + %s(k / 2) : 0;\n}\n",
        function, function);
    put(k, &k->body, "int %s = %s((int)(%s));\n", name, function, subscript(k));
    add_name(&k->scope.subscripts, name);
}

static void volatile_value(kernel *k) {
    const char *name = new_name(k, "watched");
    put(k, &k->globals, "static volatile int %s = 3;\n", name);
    put(k, &k->body, "if (%s > 2) {\n", name);
    block(k, 1);
    put(k, &k->body, "}\n");
}

/* ---- control --------------------------------------------------------------------------------- */

static void leave_early(kernel *k) {
    if (k->scope.in_loop || k->scope.depth)
        return;
    const char *p = k->scope.positions.name[0];
    const char *when =
        chance(k, 60) ? text(k, "%s == %d", p, below(k, k->trips + 1)) : condition(k);
    put(k, &k->body, "if (%s)\n%s;\n", when, chance(k, 70) ? "break" : "goto done");
}

static void change_counter(kernel *k) {
    const char *i = k->scope.positions.name[0];
    if (!k->has_plain_header)
        return;
    if (k->has_outer_counter && chance(k, 40)) {
        const char *name = new_name(k, "counter");
        put(k, &k->locals, "    %s *const %s = &%s;\n", k->counter_type, name, i);
        put(k, &k->body, "if (%s)\n++*%s;\n", condition(k), name);
    } else {
        put(k, &k->body, "if (%s)\n%s++;\n", condition(k), i);
    }
}

static void change_bound(kernel *k) {
    if (k->has_plain_header && k->trip_is_variable)
        put(k, &k->body, "if (%s)\n%s -= 1;\n", condition(k), k->trip);
}

void bait(kernel *k) {
    static void (*const kinds[])(kernel * k) = {
        read_array,
        read_through_pointer,
        read_by_callee,
        read_bytes,
        store_plainly,
        other_operator,
        reversed,
        use_update,
        set_memory,
        copy_element,
        use_tag,
        second_base,
        flat_rows,
        local_row,
        swinging_base,
        paired_extremum,
        in_expression,
        separate_bits,
        row_pointers,
        store_subscript,
        pointer_to_subscript,
        store_bound_of_rows,
        side_effect_subscript,
        secondary_counter,
        found_subscript,
        assigned_in_condition,
        subscript_through_pointer,
        copied_subscripts,
        carried_value,
        carried_subscript,
        partly_written,
        neighbour_store,
        conditional_last,
        kept_address,
        thread_local_value,
        punned_value,
        counting_callee,
        storing_callee,
        recursive_callee,
        volatile_value,
        leave_early,
        change_counter,
        change_bound,
    };
    const size_t begin = begin_statement(k);
    if (k->is_wide && chance(k, 35))
        wide_bait(k);
    else
        kinds[below(k, LENGTH(kinds))](k);
    end_statement(k, begin);
}
