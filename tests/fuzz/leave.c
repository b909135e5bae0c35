/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Iterations that may leave the loop, and pointers that are valid only under a condition. Only in
 * programs with seed % 6 == 2. */
#include "fuzz/kernel.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

/* Returns a condition that is true in few iterations or in none. */
static const char *rare_condition(kernel *k) {
    const char *p = any_name(k, &k->scope.positions);
    switch (below(k, 9)) {
    case 0:
        return text(k, "%s == %d", p, below(k, k->trips + 2));
    case 1:
        return text(k, "%s[%s] == %d && %s[%s] < 3", k->chain.base, p, below(k, k->elements),
                    k->flag.base, p);
    case 2:
        return text(k, "%s[%s] > %d", k->flag.base, p, 14 + below(k, 3));
    case 3:
        return text(k, "!(%s < 1e30)", value(k, 1));
    case 4:
        return text(k, "%s[%s] == %d", k->far.base, p, below(k, k->elements));
    case 5:
        return k->scope.subscripts.count
                   ? text(k, "%s == %d && %s", any_name(k, &k->scope.subscripts),
                          below(k, k->elements), condition(k))
                   : text(k, "%s[%s] < -100", k->flag.base, p);
    case 6:
        return text(k, "%s[%s] < 0", k->flag.base, p);
    case 7: /* in some programs on data that other iterations update */
        if (chance(k, 30) && k->reduction[0].type != E_COMPLEX)
            return text(k, "%s > 1000", place(k, &k->reduction[0], subscript(k)));
        return text(k, "7 / (%s[%s] + 1 + (%s[%s] < 0)) == 9", k->flag.base, p, k->flag.base, p);
    default:
        return text(k, "%s[%s] == %d", k->flag.base, p, 20 + below(k, 9));
    }
}

/* Appends what is done before the loop is left, and the statement that leaves it. */
static void put_departure(kernel *k) {
    const int ways = k->scope.in_loop ? 2 : 3;
    if (chance(k, 40))
        put(k, &k->body, "fuzz_print(\"leaves\", &(double){%s}, sizeof(double));\n", value(k, 0));
    else if (chance(k, 25)) {
        const array *a = any_reduction(k);
        put(k, &k->body, "%s;\n", update(k, a, place(k, a, subscript(k))));
    } else if (chance(k, 15))
        put(k, &k->body, "live[7] += 1;\n");
    static const char *const departures[] = {"goto done;\n", "return;\n", "break;\n"};
    put(k, &k->body, "%s", departures[below(k, ways)]);
}

/* Begins the `if`. Its condition may call a function, or assign a subscript, which this returns. */
static const char *put_rare_if(kernel *k) {
    const char *condition = rare_condition(k);
    if (chance(k, 25)) {
        const char *function = new_name(k, "function");
        put(k, &k->globals, "static int %s(int i, int all) {\n    return all && i >= 0;\n}\n",
            function);
        condition = text(k, "%s(%s, %s)", function, any_name(k, &k->scope.positions), condition);
    }
    if (chance(k, 60)) {
        put(k, &k->body, "if (%s) {\n", condition);
        return NULL;
    }
    const char *name = new_name(k, "k"), *e = subscript(k);
    put(k, &k->body, "int %s;\n", name);
    put(k, &k->body, "if ((%s = (int)(%s)) %s (%s)) {\n", name, e,
        chance(k, 50) ? "< 0 ||" : "> -1 &&", condition);
    return name;
}

static void leaves(kernel *k) {
    const char *assigned = put_rare_if(k);
    k->scope.depth++;
    put_departure(k);
    k->scope.depth--;
    put(k, &k->body, "}\n");
    if (assigned)
        add_name(&k->scope.subscripts, assigned);
}

/* The loop is left from an inner loop. */
static void leaves_from_inside(kernel *k) {
    const scope outside = k->scope;
    const char *c = new_name(k, "c");
    put(k, &k->body, "for (int %s = 0; %s < %d; %s++) {\n", c, c, 2 + below(k, 3), c);
    k->scope.in_loop = k->scope.can_skip = true;
    add_name(&k->scope.smalls, text(k, "(%s %% 3)", c));
    if (chance(k, 60))
        statement(k);
    leaves(k);
    if (chance(k, 50))
        statement(k);
    put(k, &k->body, "}\n");
    k->scope = outside;
}

/* An assertion that holds, in the loop or in a function, or a function that ends the program and is
 * never called. */
static void demands(kernel *k) {
    static const char *const checks[] = {"ASSERT(i <= %d);", "ASSERT(i <= %d);",
                                         "if (i < 0 || i > %d)\n        fuzz_fail();"};
    const char *function = new_name(k, "function"), *name = new_name(k, "k");
    const char *e = subscript(k);
    const int mask = k->elements - 1;
    switch (below(k, 4)) {
    case 0:
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
        put(k, &k->globals, "static int %s(int i) {\n    %s\n    return i;\n}\n", function,
            text(k, checks[below(k, LENGTH(checks))], mask));
#pragma GCC diagnostic pop
        put(k, &k->body, "int %s = %s((int)(%s));\n", name, function, e);
        break;
    case 1:
        put(k, &k->body, "int %s = (int)(%s);\n%s > %d ? fuzz_fail() : (void)0;\n", name, e, name,
            mask);
        break;
    case 2:
        put(k, &k->body, "int %s = (int)(%s);\nif (%s < 0)\nfuzz_fail();\n", name, e, name);
        break;
    default:
        put(k, &k->body, "int %s = (int)(%s);\nASSERT(%s <= %d);\n", name, e, name, mask);
        break;
    }
    add_name(&k->scope.subscripts, name);
}

/* A pointer to a record of pointers, which is valid only if the condition holds. */
static void valid_under_a_condition(kernel *k) {
    const char *record = new_name(k, "held"), *p = new_name(k, "p"),
               *at = any_name(k, &k->scope.positions);
    const char *never = new_name(k, "never");
    const array *a = any_reduction(k);
    const bool is_reached = chance(k, 60);
    put(k, &k->globals,
        "static struct %s {\n    const int *k;\n    const double *x;\n    struct %s *next;\n} "
        "%s;\n",
        record, record, record);
    put(k, &k->globals, "static int %s[%d];\n", never, k->size);
    put(k, &k->locals, "    %s.k = %s;\n    %s.x = %s;\n    %s.next = %s;\n", record, k->flag.base,
        record, k->other.base, record, is_reached ? text(k, "&%s", record) : "0");
    put(k, &k->locals, "    struct %s *%s = %s;\n", record, p,
        !is_reached && chance(k, 50) ? "0" : text(k, "&%s", record));
    const char *when = is_reached      ? condition(k)
                       : chance(k, 50) ? text(k, "%s[%s]", never, at)
                                       : text(k, "%s && %s->next", p, p);
    put(k, &k->body, "if (%s) {\n", when);
    const char *from = chance(k, 50) ? text(k, "%s->next", p) : p;
    const char *index =
        chance(k, 60) ? text(k, "%s->k[%s] & %d", from, at, k->elements - 1) : subscript(k);
    put(k, &k->body, "const int %s_at = (int)(%s);\nconst double %s_x = damp(%s->x[%s]);\n", p,
        index, p, from, at);
    const scope outside = k->scope;
    k->scope.depth++;
    add_name(&k->scope.values, text(k, "%s_x", p));
    put(k, &k->body, "%s;\n(void)%s_x;\n", update(k, a, place(k, a, text(k, "%s_at", p))), p);
    if (chance(k, 10)) /* the pointer changes for later iterations */
        put(k, &k->body, "%s = %s->next;\n", p, p);
    k->scope = outside;
    put(k, &k->body, "}\n");
}

/* A function that checks its arguments, then updates an element. If a check fails it returns an
 * error, prints, or ends the program, and the loop may test its result. */
static void checked_update(kernel *k) {
    static const char *const failures[] = {"return -1;", "printf(\"%d\\n\", i);\n        return 2;",
                                           "printf(\"%d\\n\", i);\n        return 0;",
                                           "fuzz_fail();"};
    const char *name = new_name(k, "checked"), *function = new_name(k, "function");
    const char *e = new_name(k, "e"), *failure = failures[below(k, LENGTH(failures))];
    const bool is_never = failure == failures[3];
    put(k, &k->globals, "int printf(const char *, ...);\nstatic double %s[%d];\n", name,
        k->elements);
    put(k, &k->globals, "static int %s(double *a, int n, int i, double x, int rare) {\n", function);
    put(k, &k->globals, "    if (!a || i < 0 || i >= n%s) {\n        %s\n    }\n",
        is_never ? "" : " || rare", failure);
    if (chance(k, 25))
        put(k, &k->globals, "    if (x < %d)\n        return 0;\n", -below(k, 3));
    if (chance(k, 10)) /* a check of what is updated */
        put(k, &k->globals, "    if (a[i] > 1000)\n        return 3;\n");
    put(k, &k->globals, "    a[i] %s damp(x);\n    (void)rare;\n    return 0;\n}\n",
        chance(k, 50) ? "+=" : "-=");
    put(k, &k->body, "int %s;\n", e);
    const char *call = text(k, "%s(%s, %d, (int)(%s) & %d, %s, %s)", function, name, k->elements,
                            subscript(k), k->elements - 1, value(k, 0), rare_condition(k));
    switch (below(k, 4)) {
    case 0:
        put(k, &k->body, "%s = 0;\n%s;\n", e, call);
        break;
    case 1:
        put(k, &k->body, "%s = 1;\nif (%s) {\n", e, call);
        break;
    case 2:
        put(k, &k->body, "if ((%s = %s) < 0) {\n", e, call);
        break;
    default:
        put(k, &k->body, "%s = %s;\nif (%s) {\n", e, call, e);
    }
    if (k->body.data[k->body.length - 2] == '{') {
        k->scope.depth++;
        put_departure(k);
        k->scope.depth--;
        put(k, &k->body, "}\n");
    }
    put(k, &k->body, "(void)%s;\n", e);
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", name, name, name);
}

void leave_or_look(kernel *k) {
    static void (*const kinds[])(kernel * k) = {leaves,
                                                checked_update,
                                                checked_update,
                                                leaves,
                                                leaves,
                                                leaves_from_inside,
                                                list_of_row,
                                                list_of_row,
                                                demands,
                                                demands,
                                                valid_under_a_condition,
                                                valid_under_a_condition};
    if (k->scope.in_loop || k->scope.depth > 1)
        demands(k);
    else
        kinds[below(k, LENGTH(kinds))](k);
}
