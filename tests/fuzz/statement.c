/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Statements of the loop's body. */
#include "fuzz/kernel.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

array *any_reduction(kernel *k) {
    return &k->reduction[below(k, 3) == 0];
}

void declare_outside(kernel *k, const char *type, const char *name, const char *initial) {
    put(k, &k->locals, initial ? "    %s %s = %s;\n" : "    %s %s;\n", type, name, initial);
}

/* Returns NULL, for no initialiser, if this statement is executed in each iteration and only later
 * statements use the variable. */
static const char *first_value(kernel *k, bool is_last_wanted) {
    const bool is_certain = k->scope.depth == 0 && !k->scope.in_loop && !is_last_wanted;
    return is_certain && !k->without ? NULL : "0";
}

static void store_after(kernel *k, const char *name) {
    put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, name);
}

/* ---- variables ------------------------------------------------------------------------------- */

static void declare_subscript(kernel *k) {
    static const char *const types[] = {"int",  "int",   "const int", "unsigned",
                                        "long", "short", "size_t"};
    const char *name = new_name(k, "k");
    const char *e = subscript(k);
    put(k, &k->body, "%s %s = %s;\n", types[below(k, LENGTH(types))], name, e);
    if (k->scope.subscripts.count < MOST_NAMES)
        add_name(&k->scope.subscripts, name);
}

static void assign_outer_subscript(kernel *k) {
    const char *name = new_name(k, "k");
    const char *e = subscript(k);
    const bool is_last_wanted = chance(k, 15);
    declare_outside(k, chance(k, 80) ? "int" : "unsigned", name, first_value(k, is_last_wanted));
    put(k, &k->body, "%s = %s;\n", name, e);
    if (is_last_wanted)
        store_after(k, name);
    add_name(&k->scope.subscripts, name);
}

static void declare_value(kernel *k) {
    const char *name = new_name(k, "d");
    const char *e = value(k, 1);
    put(k, &k->body, "%s %s = %s;\n", chance(k, 70) ? "double" : "float", name, e);
    add_name(&k->scope.values, name);
}

static void assign_outer_value(kernel *k) {
    const char *name = new_name(k, "d");
    const char *e = value(k, 1);
    const bool is_last_wanted = chance(k, 15);
    declare_outside(k, "double", name, first_value(k, is_last_wanted));
    put(k, &k->body, "%s = %s;\n", name, e);
    if (is_last_wanted)
        store_after(k, name);
    add_name(&k->scope.values, name);
}

/* Appends a variable of the iteration that is set to a subscript and then changed to another one,
 * in some forms only under a condition. */
static void changed_subscript(kernel *k) {
    const char *name = new_name(k, "k");
    const char *e = subscript(k);
    put(k, &k->body, "int %s = %s;\n", name, e);
    add_name(&k->scope.subscripts, name);
    switch (below(k, 4)) {
    case 0:
        put(k, &k->body, "%s = %s[%s] & %d;\n", name, k->chain.base, name, k->elements - 1);
        break;
    case 1: {
        const char *when = condition(k);
        put(k, &k->body, "if (%s)\n%s = %s;\n", when, name, subscript(k));
        break;
    }
    case 2:
        put(k, &k->body, "%s = (%s + %d) & %d;\n", name, name, 1 + below(k, 9), k->elements - 1);
        break;
    default:
        put(k, &k->body, "if (%s > 1)\n%s--;\n", name, name);
        break;
    }
}

static void private_array(kernel *k) {
    const char *name = new_name(k, "f");
    if (chance(k, 50))
        put(k, &k->body, "double %s[3];\n", name);
    else
        put(k, &k->locals, "    double %s[3]%s;\n", name, k->without ? " = {0}" : "");
    const char *e = value(k, 1);
    if (chance(k, 50)) {
        const char *counter = new_name(k, "c");
        put(k, &k->body, "for (int %s = 0; %s < 3; %s++)\n%s[%s] = %s;\n", counter, counter,
            counter, name, counter, e);
    } else {
        put(k, &k->body, "%s[0] = %s;\n%s[1] = 0.5;\n", name, e, name);
        put(k, &k->body, "%s[2] = %s[0] - %s[1];\n", name, name, name);
    }
    add_name(&k->scope.values, text(k, "%s[%d]", name, below(k, 3)));
}

static void private_record(kernel *k) {
    const char *name = new_name(k, "q");
    const char *type = text(k, "struct pair_%llu", (unsigned long long)k->seed);
    const char *e = subscript(k);
    const char *v = value(k, 1);
    if (chance(k, 50)) {
        put(k, &k->body, "%s %s = {%s, %s};\n", type, name, e, v);
    } else {
        put(k, &k->locals, "    %s %s%s;\n", type, name, k->without ? " = {0}" : "");
        put(k, &k->body, "%s.place = %s;\n%s.weight = %s;\n", name, e, name, v);
    }
    add_name(&k->scope.subscripts, text(k, "%s.place", name));
    add_name(&k->scope.values, text(k, "%s.weight", name));
}

/* ---- calls ----------------------------------------------------------------------------------- */

static void call_for_value(kernel *k) {
    const char *function = new_name(k, "function");
    const char *name = new_name(k, "d");
    const char *load = k->is_damped ? "damp(x[k + c])" : "x[k + c]";
    switch (below(k, 3)) {
    case 0:
        put(k, &k->globals, "static double %s(double x, int k) { return 0.5 * x + (k & 3); }\n",
            function);
        put(k, &k->body, "double %s = %s(%s, ", name, function, value(k, 1));
        put(k, &k->body, "(int)(%s));\n", subscript(k));
        break;
    case 1:
        put(k, &k->globals,
            "static double %s(const double *x, int k) {\n    double s = 0;\n"
            "    for (int c = 0; c < 3; c++)\n        s += %s;\n    return s;\n}\n",
            function, load);
        put(k, &k->body, "double %s = %s(%s, (int)(%s));\n", name, function, k->other.base,
            position(k));
        break;
    default:
        put(k, &k->globals,
            "static void %s(const double *x, int k, double *to) {\n    const int c = 1;\n"
            "    to[0] = %s;\n}\n",
            function, load);
        put(k, &k->body, "double %s;\n%s(%s, (int)(%s), &%s);\n", name, function, k->other.base,
            position(k), name);
        break;
    }
    add_name(&k->scope.values, name);
}

static void call_for_subscript(kernel *k) {
    const char *function = new_name(k, "function");
    const char *name = new_name(k, "k");
    const char *at = position(k);
    const char *mask = text(k, "%d", k->elements - 1);
    if (chance(k, 50)) {
        put(k, &k->globals, "static int %s(const int *x, long t) { return x[t] & %s; }\n", function,
            mask);
        put(k, &k->body, "int %s = %s(%s, (long)(%s));\n", name, function, k->flag.base, at);
    } else {
        put(k, &k->globals,
            "static void %s(const int *x, long t, int *k) {\n    *k = x[t] & %s;\n}\n", function,
            mask);
        put(k, &k->body, "int %s;\n%s(%s, (long)(%s), &%s);\n", name, function, k->flag.base, at,
            name);
    }
    add_name(&k->scope.subscripts, name);
}

static void call_that_updates(kernel *k) {
    const array *a = any_reduction(k);
    const char *function = new_name(k, "function");
    const char *type = elements[a->type].spelling;
    const char *index = subscript(k);
    const char *e = contribution(k, a);
    if (*a->operation == '<' || *a->operation == '>')
        return;
    put(k, &k->globals, "static void %s(%s *p, %s v) {\n    *p %s= v;\n}\n", function, type, type,
        a->operation);
    put(k, &k->body, "%s(&%s, %s);\n", function, place(k, a, index), e);
}

/* ---- updates and control --------------------------------------------------------------------- */

/* Adjacent elements: members of a record, of the array's type or of another. */
static void updates_of_a_row(kernel *k, const array *a) {
    const char *index = subscript(k);
    for (int left = 2 + below(k, 3); left > 0; left--)
        if (a->shape == SHAPE_RECORDS && chance(k, 12))
            put(k, &k->body, "%s[%s].other += %s;\n", a->base, index, integer(k, 1));
        else
            put(k, &k->body, "%s;\n",
                update(k, a, place(k, a, chance(k, 12) ? subscript(k) : index)));
}

void plain_update(kernel *k) {
    if (k->has_parts && !k->scope.in_loop && chance(k, 60)) {
        loop_over_parts(k);
        return;
    }
    const array *a = any_reduction(k);
    if (a->shape != SHAPE_FLAT && chance(k, 30)) {
        updates_of_a_row(k, a);
        return;
    }
    const char *where = place(k, a, subscript(k));
    put(k, &k->body, "%s;\n", update(k, a, where));
}

static void branch(kernel *k) {
    const char *when = condition(k);
    put(k, &k->body, "if (%s) {\n", when);
    block(k, 1 + below(k, 2));
    if (chance(k, 30)) {
        put(k, &k->body, "} else {\n");
        block(k, 1);
    }
    put(k, &k->body, "}\n");
}

static void choice(kernel *k) {
    put(k, &k->body, "switch (%s & 3) {\n", integer(k, 0));
    for (int c = 0; c < 2; c++) {
        put(k, &k->body, "case %d: {\n", c);
        block(k, 1);
        put(k, &k->body, "}\n%s", chance(k, 80) ? "break;\n" : "");
    }
    put(k, &k->body, "default:\n;\n}\n");
}

static void skip(kernel *k) {
    if (k->scope.in_loop ? k->scope.can_skip : k->may_continue)
        put(k, &k->body, "if (%s)\ncontinue;\n", condition(k));
}

/* A subscript that may be loaded or computed only under its condition. */
static void protected_subscript(kernel *k) {
    const char *name = new_name(k, "k");
    const char *p = any_name(k, &k->scope.positions);
    put(k, &k->body, "int %s = 0;\n", name);
    if (chance(k, 70)) {
        const char *mask = k->is_masked ? text(k, " & %d", k->elements - 1) : "";
        put(k, &k->body, "if (%s[%s] < %d%s)\n", k->far.base, p, k->size,
            chance(k, 30) ? text(k, " && %s", condition(k)) : "");
        put(k, &k->body, "%s = %s[%s[%s]]%s;\n", name, k->chain.base, k->far.base, p, mask);
    } else {
        put(k, &k->body, "if (%s[%s])\n%s = %d %% %s[%s];\n", k->flag.base, p, name,
            5 + below(k, 20), k->flag.base, p);
        put(k, &k->body, "%s &= %d;\n", name, k->elements - 1);
    }
    add_name(&k->scope.subscripts, name);
}

static void own_store(kernel *k) {
    put(k, &k->body, "%s[%s] = %s;\n", k->out.base, k->scope.positions.name[0], value(k, 1));
}

static void scalar_sum(kernel *k) {
    const char *name = new_name(k, "sum");
    declare_outside(k, "double", name, "0");
    put(k, &k->body, "%s += %s;\n", name, value(k, 1));
    store_after(k, name);
}

/* Appends statements that add 1 to a secondary counter through a copy. Sometimes they add 0 in
 * iterations in which a condition holds. */
static void copied_step(kernel *k, const char *type, const char *name) {
    const char *next = new_name(k, "copy"), *by = text(k, "%d", 1 + below(k, 3));
    if (chance(k, 60)) {
        const char *number = by;
        by = new_name(k, "by");
        declare_outside(k, "int", by, number);
    }
    const bool is_outside = chance(k, 50);
    if (is_outside)
        declare_outside(k, type, next, "0");
    else
        put(k, &k->body, "%s ", type);
    put(k, &k->body,
        is_outside && chance(k, 30) ? "%1$s = %2$s, %1$s += %3$s;\n" : "%1$s = %2$s + %3$s;\n",
        next, name, by);
    if (chance(k, 40))
        plain_update(k);
    if (chance(k, 10))
        put(k, &k->body, "if (%s)\n%s--;\n", condition(k), next);
    put(k, &k->body,
        chance(k, 50) ? "%1$s = %2$s - %3$s + 1;\n" : "%1$s = 1 + %2$s, %1$s -= %3$s;\n", name,
        next, by);
}

/* A secondary counter, used before and after its step. */
static void counter_beside(kernel *k) {
    static const char *const types[] = {"int", "int", "long", "unsigned"};
    if (k->scope.in_loop || (k->scope.depth && chance(k, 80)))
        return;
    const char *name = new_name(k, "a");
    const char *place = chance(k, 50) ? name : text(k, "(%s + 1)", name);
    const char *type = types[below(k, LENGTH(types))];
    declare_outside(k, type, name, text(k, "%d", below(k, 5)));
    add_name(&k->scope.positions, place);
    if (chance(k, 50))
        plain_update(k);
    if ((k->has_strides || k->has_idioms) && chance(k, 70))
        copied_step(k, type, name);
    else
        put(k, &k->body, chance(k, 50) ? "%s++;\n" : "%s += 1;\n", name);
    if (chance(k, 40))
        store_after(k, name);
}

void statement(kernel *k) {
    static const struct {
        void (*make)(kernel *k);
        int weight;
    } kinds[] = {
        {plain_update, 36},
        {declare_subscript, 12},
        {assign_outer_subscript, 6},
        {declare_value, 8},
        {assign_outer_value, 5},
        {changed_subscript, 4},
        {private_array, 3},
        {private_record, 3},
        {call_for_value, 4},
        {call_for_subscript, 3},
        {call_that_updates, 1},
        {branch, 6},
        {choice, 1},
        {inner_loop, 8},
        {skip, 1},
        {protected_subscript, 2},
        {own_store, 1},
        {scalar_sum, 1},
        {counter_beside, 3},
    };
    const size_t begin = begin_statement(k);
    if (k->is_wide && chance(k, 15)) {
        wide_statement(k);
        end_statement(k, begin);
        return;
    }
    if ((k->has_strides || k->has_idioms) && !k->scope.depth && chance(k, 20)) {
        counter_beside(k);
        end_statement(k, begin);
        return;
    }
    if (k->has_rows && chance(k, 25)) {
        rows_behind_pointers(k);
        end_statement(k, begin);
        return;
    }
    if (k->has_spans && !k->scope.in_loop && chance(k, 25)) {
        loop_along_a_row(k);
        end_statement(k, begin);
        return;
    }
    if (k->has_helpers && chance(k, 40)) {
        if (chance(k, 70))
            call_of_helper(k);
        else
            in_pieces(k);
        end_statement(k, begin);
        return;
    }
    if (k->has_idioms && chance(k, 30)) {
        idiom(k);
        end_statement(k, begin);
        return;
    }
    if (k->has_leaving && chance(k, 25)) {
        leave_or_look(k);
        end_statement(k, begin);
        return;
    }
    if (k->has_shapes && k->scope.depth < 2 && chance(k, 30)) {
        shape_of_an_attack(k);
        end_statement(k, begin);
        return;
    }
    if (k->has_recent && k->scope.depth < 2 && !k->scope.in_loop && chance(k, 35)) {
        recent_shape(k);
        end_statement(k, begin);
        return;
    }
    int which = below(k, 108), i = 0;
    while (which >= kinds[i].weight)
        which -= kinds[i++].weight;
    kinds[i].make(k);
    end_statement(k, begin);
}

void block(kernel *k, int count) {
    const scope outside = k->scope;
    k->scope.depth++;
    for (int i = 0; i < count; i++)
        statement(k);
    k->scope = outside;
}
