/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Functions that update several elements given by their parameters, with early returns, parameters
 * that change, sums by address, results, and functions that they call. Some contain a statement
 * that should prevent the transformation of the loop. Only in programs with seed % 19 == 3. */
#include "fuzz/kernel.h"

typedef struct pair {
    const array *a;
    const char *type; /* of an element */
    const char *function;
    bool by_subscripts;         /* the parameters are p, i, j; otherwise the elements' addresses a,
                                   b */
    const char *first, *second; /* the elements, as the function spells them */
    bool has_sum, has_result;
} pair;

static const char *changed(kernel *k, const pair *p, const char *where, const char *by) {
    const char *op = p->a->operation;
    if (*op == '<' || *op == '>')
        return chance(k, 50) ? text(k, "if (%s %s %s)\n        %s = %s;", by, op, where, where, by)
                             : text(k, "%s = %s %s %s ? %s : %s;", where, by, op, where, by, where);
    if (*op == '+' && chance(k, 40))
        return text(k, "%s -= %s;", where, by);
    return chance(k, 70) ? text(k, "%s %s= %s;", where, op, by)
                         : text(k, "%s = %s %s %s;", where, where, op, by);
}

static const char *condition_in(kernel *k) {
    static const char *const conditions[] = {"u == v && at > 1", "at > 3", "(at & 3) != 1",
                                             "w > 0.5 && at < 40", "!(w < 0.25)"};
    return conditions[below(k, 5)];
}

/* Appends an update of one of the elements, as a statement or as a call of another function. */
static void put_update(kernel *k, const pair *p, const char *where) {
    const char *const by = chance(k, 50) ? "u" : "v";
    if (chance(k, 20)) {
        const char *inner = new_name(k, "inner");
        buffer own = {0};
        put(k, &own, "static void %s(%s *to, %s by) {\n    %s\n}\n", inner, p->type, p->type,
            changed(k, p, "*to", "by"));
        buffer_text(&own, k->globals.data ? k->globals.data : "");
        buffer_free(&k->globals);
        k->globals = own;
        put(k, &k->globals, "    %s(&%s, %s);\n", inner, where, by);
        return;
    }
    put(k, &k->globals, "    %s\n", changed(k, p, where, by));
}

static void put_return(kernel *k, const pair *p) {
    put(k, &k->globals, "return%s;\n", p->has_result ? chance(k, 50) ? " w" : " 0.25" : "");
}

/* Appends a statement that should prevent the transformation of the loop. With most of them the
 * iterations depend on each other, or the function depends on more than its arguments. */
static void put_reason(kernel *k, const pair *p) {
    switch (below(k, 6)) {
    case 0: /* the element that other calls update */
        put(k, &k->globals, "    if (%s == %s)\n        at++;\n", p->first, p->second);
        return;
    case 1:
        put(k, &k->globals, "    static int calls;\n    at = ++calls & %d;\n", k->elements - 1);
        return;
    case 2:
        put(k, &k->globals, "    %s = u;\n", p->second);
        return;
    case 3:
        put(k, &k->globals, "    for (int c = 0; c < at; c++)\n        if (c == 5)\n            ");
        put_return(k, p);
        return;
    case 4:
        if (p->a->type != E_COMPLEX)
            put(k, &k->globals, "    w = damp(w + (double)%s);\n", p->first);
        return;
    default:
        put(k, &k->globals, "    %s *kept = &%s;\n    *kept = *kept;\n", p->type, p->second);
    }
}

static void put_body(kernel *k, const pair *p) {
    const bool is_changed = chance(k, 40), has_reason = chance(k, 20);
    if (is_changed)
        put(k, &k->globals, "    at = (at * 3 + 1) & %d;\n", k->elements - 1);
    if (chance(k, 50)) {
        put(k, &k->globals, "    if (%s)\n        ", condition_in(k));
        put_return(k, p);
    }
    put(k, &k->globals, "    const double d = w * 0.5;\n");
    put_update(k, p, p->first);
    if (has_reason)
        put_reason(k, p);
    if (chance(k, 30)) {
        put(k, &k->globals, "    if (%s) {\n    ", condition_in(k));
        put_update(k, p, p->second);
        put(k, &k->globals, "        ");
        if (chance(k, 50))
            put_return(k, p);
        put(k, &k->globals, "    }\n");
    }
    if (chance(k, 30))
        put(k, &k->globals, "    if (d > 0.25)\n        w = w - d;\n    else\n        w = 0.5;\n");
    put_update(k, p, p->second);
    if (p->has_sum)
        put(k, &k->globals, "    *sum += w;\n");
    put(k, &k->globals, "    (void)d, (void)u, (void)v, (void)at;\n");
    if (p->has_result)
        put(k, &k->globals, "    return w;\n");
}

static void put_function(kernel *k, const pair *p) {
    buffer before = k->globals;
    k->globals = (buffer){0};
    put(k, &k->globals, "static %s%s %s(", chance(k, 20) ? "inline " : "",
        p->has_result ? "double" : "void", p->function);
    if (p->by_subscripts)
        put(k, &k->globals, "%s *p, int i, int j, ", p->type);
    else
        put(k, &k->globals, "%s *a, %s *b, ", p->type, p->type);
    put(k, &k->globals, "%s u, %s v, double w, int at%s) {\n", p->type, p->type,
        p->has_sum ? ", double *sum" : "");
    put_body(k, p);
    put(k, &k->globals, "}\n");
    if (before.data) {
        buffer own = k->globals;
        buffer_text(&before, own.data);
        buffer_free(&own);
        k->globals = before;
    }
}

static const char *summed_outside(kernel *k) {
    const char *name = new_name(k, "sum");
    declare_outside(k, "double", name, "0");
    put(k, &k->after, "    live[%d] = %s;\n", k->live++ % 8, name);
    return name;
}

void call_of_pair(kernel *k) {
    pair p = {.a = any_reduction(k)};
    p.type = elements[p.a->type].spelling;
    p.function = new_name(k, "pair");
    p.by_subscripts = p.a->shape == SHAPE_FLAT && chance(k, 40);
    p.first = p.by_subscripts ? "p[i]" : "*a";
    p.second = p.by_subscripts ? "p[j]" : chance(k, 80) ? "*b" : "b[0]";
    p.has_sum = chance(k, 30);
    p.has_result = chance(k, 30);
    put_function(k, &p);
    const char *first = subscript(k), *second = chance(k, 90) ? subscript(k) : first;
    const char *u = contribution(k, p.a), *v = contribution(k, p.a), *w = value(k, 1);
    const char *sum = p.has_sum ? summed_outside(k) : NULL,
               *results = p.has_result ? summed_outside(k) : NULL;
    const char *elements_of =
        p.by_subscripts ? text(k, "%s, (int)(%s), (int)(%s)", p.a->base, first, second)
                        : text(k, "&%s, &%s", place(k, p.a, first), place(k, p.a, second));
    if (chance(k, 20))
        put(k, &k->body, "if (%s)\n", condition(k));
    put(k, &k->body, "%s%s(%s, %s, %s, damp(%s), (int)(%s) & %d%s);\n",
        results ? text(k, "%s += ", results) : "", p.function, elements_of, u, v, w, subscript(k),
        k->elements - 1, sum ? text(k, ", &%s", sum) : "");
}
