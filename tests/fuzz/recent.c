/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Counters that stop at a limit, own elements that are read, stored and read again, functions that
 * clamp a table's subscript, pairs of records, loops with OpenMP directives, and similar
 * statements. Only in programs with seed % 10 equal to 2, 5, 6 or 9. */
#include "fuzz/kernel.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

static void print_after(kernel *k, const char *name) {
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", name, name, name);
}

/* Appends if (e < 20) e++ with one limit; similar statements have several limits, or may pass the
 * limit. */
static void stopping_counter(kernel *k) {
    static const char *const types[] = {
        "unsigned char", "signed char", "unsigned short", "short",
        "int",           "unsigned",    "long",           "unsigned long long"};
    static const char *const tests[] = {"%1$s < %2$s", "%2$s > %1$s", "%1$s != %2$s",
                                        "%1$s <= %2$s"};
    static const char *const steps[] = {"%1$s++", "++%1$s", "%1$s += 1", "%1$s = %1$s + 1"};
    const char *name = new_name(k, "stops");
    const bool has_name = chance(k, 50);
    const char *where = subscript(k), *at = has_name ? new_name(k, "at") : where;
    put(k, &k->globals, "static %s %s[%d];\n", types[below(k, LENGTH(types))], name, k->elements);
    if (has_name)
        put(k, &k->body, "const int %s = (int)(%s);\n", at, where);
    const char *e = text(k, "%s[%s]", name, at);
    const int limit = 1 + below(k, chance(k, 50) ? 4 : 100);
    const char *stop =
        chance(k, 15) ? text(k, "(%d + (%s & 1))", limit, integer(k, 0)) : text(k, "%d", limit);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    const char *test = text(k, tests[below(k, chance(k, 30) ? LENGTH(tests) : 2)], e, stop);
    const char *step =
        chance(k, 10) ? text(k, "%s += 2", e) : text(k, steps[below(k, LENGTH(steps))], e);
#pragma GCC diagnostic pop
    put(k, &k->body, chance(k, 50) ? "if (%s)\n%s;\n" : "if (%s) {\n%s;\n}\n", test, step);
    if (chance(k, 10)) /* another limit, or an update without a limit */
        put(k, &k->body, "if (%s < %d)\n%s%s;\n", e, limit + 1, e, chance(k, 50) ? "++" : "--");
    print_after(k, name);
}

/* p[t].x is read, stored and read again. */
static void own_element(kernel *k) {
    const char *p = new_name(k, "own"), *x = new_name(k, "x");
    const char *t = k->scope.positions.name[0];
    const bool is_other = chance(k, 12);
    put(k, &k->globals, "static struct {\n    double x, v;\n    int cell, last;\n} %s[%d];\n", p,
        k->size);
    put(k, &k->locals, "    fuzz_fill(&%s[0].v, %d, sizeof %s[0], FUZZ_DOUBLE, 1);\n", p, k->size,
        p);
    if (chance(k, 50))
        put(k, &k->body, "%s[%s].v = damp(%s[%s].v - %s);\n", p, t, p, t, value(k, 0));
    if (chance(k, 20))
        put(k, &k->body, "if (%s)\n", condition(k));
    put(k, &k->body, "%s[%s].x = damp(%s[%s%s].x + %s[%s].v);\n", p, t, p, t,
        is_other ? " + 1" : "", p, t);
    if (chance(k, 60))
        put(k, &k->body, "%s[%s].cell = (int)(%s[%s].x * 7.0) & %d;\n", p, t, p, t,
            k->elements - 1);
    else
        put(k, &k->body, "%s[%s].last = %s[%s].cell;\n%s[%s].cell = %s;\n", p, t, p, t, p, t,
            subscript(k));
    put(k, &k->body, "const double %s = %s[%s].x;\n(void)%s;\n", x, p, t, x);
    add_name(&k->scope.values, x);
    add_name(&k->scope.subscripts, text(k, "%s[%s].cell", p, t));
    print_after(k, p);
}

/* A function that clamps the subscript to the table, or nearly does. */
static void table_between_bounds(kernel *k) {
    static const char *const below_forms[] = {"    if (i < 0)\n        i = 0;\n",
                                              "    i = i < 0 ? 0 : i;\n",
                                              "    if (x < 0.0)\n        return t[0];\n"};
    static const char *const above_forms[] = {"    if (i > n - 2)\n        i = n - 2;\n",
                                              "    i = i < n - 2 ? i : n - 2;\n",
                                              "    if (i >= n - 1)\n        return t[n - 1];\n"};
    const char *function = new_name(k, "look"), *table = new_name(k, "table");
    const char *x = new_name(k, "x");
    const int length = 8 + below(k, 60);
    put(k, &k->globals, "static double %s[%d];\n", table, length);
    put(k, &k->globals, "static double %s(const double *t, int n, double x) {\n", function);
    put(k, &k->globals, "    int i = (int)(x * %d.0);\n", 1 + below(k, 9));
    const char *under = below_forms[below(k, 3)], *over = above_forms[below(k, 3)];
    const bool is_turned = chance(k, 50);
    put(k, &k->globals, "%s%s", is_turned ? over : under, is_turned ? under : over);
    put(k, &k->globals,
        chance(k, 50) ? "    return t[i] + (double)(x > 0.5) * t[i + 1];\n}\n"
                      : "    return t[i + 1] - t[i];\n}\n");
    put(k, &k->locals, "    fuzz_fill(%s, %d, sizeof %s[0], FUZZ_DOUBLE, 1);\n", table, length,
        table);
    put(k, &k->body, "const double %s = %s(%s, %d, damp(%s));\n(void)%s;\n", x, function, table,
        length, value(k, 0), x);
    add_name(&k->scope.values, x);
    if (chance(k, 10))
        put(k, &k->body, "%s[%s & 7] = %s;\n", table, integer(k, 0), value(k, 0));
}

/* p[i].f += ..., p[j].f -= ..., computed from p[i].x and p[j].x, and the sum of an energy. */
static void pairs(kernel *k) {
    const char *p = new_name(k, "pairs"), *j = new_name(k, "j"), *d = new_name(k, "d");
    const char *t = k->scope.positions.name[0];
    const char *other = chance(k, 50) ? j : text(k, "(%s & %d)", j, k->elements - 1);
    put(k, &k->globals, "static struct {\n    double x, f;\n} %s[%d];\n", p, k->size);
    put(k, &k->locals, "    fuzz_fill(&%s[0].x, %d, sizeof %s[0], FUZZ_DOUBLE, 1);\n", p, k->size,
        p);
    const bool is_below = chance(k, 50);
    if (is_below)
        put(k, &k->body, "for (int %s = 0; %s < (int)(%s) %% 9; %s++) {\n", j, j, t, j);
    else
        put(k, &k->body, "for (int %s = (int)(%s) + 1; %s < (int)(%s) + %d; %s++) {\n", j, t, j, t,
            2 + below(k, 9), j);
    put(k, &k->body, "const double %s = %s[%s].x - %s[%s].x;\n", d, p, t, p, other);
    if (chance(k, 30))
        put(k, &k->body, "if (%s * %s > 0.5)\ncontinue;\n", d, d);
    if (chance(k, 30)) {
        const char *q = new_name(k, "q");
        put(k, &k->body, "__typeof__(&%s[0]) %s = &%s[%s];\n%s->f -= %s;\n", p, q, p, other, q, d);
    } else {
        put(k, &k->body, "%s[%s].f -= %s;\n", p, other, d);
    }
    if (chance(k, 10))
        put(k, &k->body, "%s[%s].x = %s;\n", p, other, d);
    put(k, &k->body, "%s[%s].f += %s;\n}\n", p, t, d);
    print_after(k, p);
}

void recent_shape(kernel *k) {
    static void (*const shapes[])(kernel *) = {stopping_counter, stopping_counter, own_element,
                                               table_between_bounds, pairs};
    shapes[below(k, LENGTH(shapes))](k);
}

/* A parallel loop, or a loop that a region's team shares. Its updates are protected, since OpenMP
 * forbids unprotected ones. */
void loop_with_directives(kernel *k) {
    const char *sums = new_name(k, "sums"), *i = new_name(k, "o"), *v = new_name(k, "v");
    const char *at = new_name(k, "at"), *total = new_name(k, "total");
    const bool is_whole = chance(k, 40);
    const char *type = is_whole ? "int" : chance(k, 70) ? "double" : "float";
    const int way = below(k, 4);
    put(k, &k->globals, "static %s %s[%d];\nstatic int to_%s[%d];\nstatic double by_%s[%d];\n",
        type, sums, k->elements, sums, k->size, sums, k->size);
    put(k, &k->locals,
        "    fuzz_fill(to_%s, %d, sizeof(int), FUZZ_INT32, %d);\n"
        "    fuzz_fill(by_%s, %d, sizeof(double), FUZZ_DOUBLE, 1);\n    double %s = 0;\n",
        sums, k->size, k->elements, sums, k->size, total);
    const bool has_total = chance(k, 40);
    const char *clause = way == 3 ? text(k, " reduction(+ : %s[:%d])", sums, k->elements) : "";
    const bool is_shared = chance(k, 40);
    put(k, &k->body, "%s%s%s%s\n",
        is_shared ? "#pragma omp parallel\n{\n#pragma omp for" : "#pragma omp parallel for", clause,
        has_total ? text(k, " reduction(+ : %s)", total) : "",
        chance(k, 30) ? " schedule(dynamic, 8)" : "");
    put(k, &k->body, "for (int %s = 0; %s < (int)n; %s++) {\n", i, i, i);
    put(k, &k->body, "const int %s = to_%s[%s];\nconst double %s = by_%s[%s]%s;\n", at, sums, i, v,
        sums, i, is_whole ? " * 64.0" : "");
    const char *update = text(k, "%s[%s] += %s%s", sums, at, is_whole ? "(int)" : "", v);
    if (chance(k, 30))
        put(k, &k->body, "if (%s > 0.25) {\n", v);
    else
        put(k, &k->body, "{\n");
    if (way == 0)
        put(k, &k->body, "#pragma omp atomic\n%s;\n", update);
    else if (way == 1)
        put(k, &k->body, "#pragma omp atomic update\n%s;\n#pragma omp atomic\n%s[%d]%s;\n", update,
            sums, below(k, k->elements), is_whole ? "++" : " -= 1");
    else if (way == 2)
        put(k, &k->body, "#pragma omp critical\n{\n%s;\n%s[(%s + 1) & %d] -= 1;\n}\n", update, sums,
            at, k->elements - 1);
    else
        put(k, &k->body, "%s;\n", update);
    put(k, &k->body, "}\n");
    if (has_total)
        put(k, &k->body, "%s += %s;\n", total, v);
    put(k, &k->body, is_shared ? "}\n}\n" : "}\n");
    put(k, &k->after, "    live[%d] = %s;\n", k->live++ % 8, total);
    print_after(k, sums);
}
