/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Functions that read through their parameters in loops: through tables, in rows whose bounds are
 * read, in searches that may fail, and in ways that cannot be known in advance. Also updates in
 * several statements. Only in programs with seed % 7 == 0, so that other seeds yield the same
 * programs as before. */
#include "fuzz/kernel.h"

#include <string.h>

typedef struct helper {
    const char *type;    /* type of the counter */
    const char *counter; /* name of the counter */
    const char *loop;    /* the loop's header, with a trailing blank */
    const char *element; /* x[...] as one turn reads it */
    const char *before;  /* declarations before the loop */
    const char *setup;   /* statements at the beginning of the body */
    const char *after;   /* statements at the end of the body */
} helper;

static void choose_loop(kernel *k, helper *h) {
    static const char *const types[] = {"int", "long", "size_t", "short", "unsigned char"};
    const bool is_outer = chance(k, 25);
    h->type = types[below(k, 5)];
    h->counter = "c";
    const char *declared = is_outer ? "" : text(k, "%s ", h->type);
    if (is_outer)
        h->before = text(k, "    %s c;\n", h->type);
    switch (below(k, 6)) {
    case 0: /* a row whose bounds are in a table */
        h->type = "int";
        h->before = is_outer ? "    int c;\n" : "";
        h->loop = text(k, "for (%sc = row[at]; c < row[at + 1]; c++) ", is_outer ? "" : "int ");
        return;
    case 1:
        h->type = "long";
        h->before = text(k, "    const int end = at + count;\n%s", is_outer ? "    long c;\n" : "");
        h->loop =
            text(k, "for (%sc = at; c < end; c += %d) ", is_outer ? "" : "long ", 1 + below(k, 3));
        return;
    case 2:
        h->type = "int";
        h->before = is_outer ? "    int c;\n" : "";
        h->loop = text(k, "for (%sc = at + count - 1; c >= at; %s) ", is_outer ? "" : "int ",
                       chance(k, 70) ? "c--" : "c -= 2");
        return;
    default:
        h->loop = text(k, "for (%sc = %d; c %s %d; c%s) ", declared, below(k, 3),
                       chance(k, 30) ? "<=" : "<", 1 + below(k, 7), chance(k, 80) ? "++" : " += 2");
    }
}

static void choose_element(kernel *k, helper *h) {
    const int mask = k->elements - 1;
    const char *from_table = text(k, "list[c] & %d", mask);
    h->setup = h->after = "";
    switch (below(k, 8)) {
    case 0:
        h->element = text(k, "x[c & %d]", mask);
        return;
    case 1:
        h->element = "x[c]";
        return;
    case 2:
        h->setup = text(k, "        const int j = %s;\n", from_table);
        h->element = "x[j]";
        return;
    case 3: /* declared before the loop */
        h->before = text(k, "%s    int j;\n", h->before);
        h->setup = text(k, "        j = %s;\n", from_table);
        h->element = "x[j]";
        return;
    case 4: /* the subscript of the previous turn */
        h->before = text(k, "%s    int j = at & %d;\n", h->before, mask);
        h->after = text(k, "        j = %s;\n", from_table);
        h->element = "x[j]";
        return;
    case 5:
        h->element = text(k, "x[(list[at] + (int)c) & %d]", mask);
        return;
    default:
        h->element = text(k, "x[%s]", from_table);
    }
}

static const char *condition_in(kernel *k) {
    static const char *const conditions[] = {"c != 2", "x[c] > 0", "list[c] > at", "sum < 2",
                                             "list && c > at"};
    return conditions[below(k, 5)];
}

static void put_sum(kernel *k, const char *function, const helper *h) {
    put(k, &k->globals,
        "static double %s(const double *x, const int *list, const int *row, int at, int count) {\n"
        "    double sum = 0;\n%s",
        function, h->before);
    if (chance(k, 15))
        put(k, &k->globals, "    if (count %% 3 == 1)\n        return 0.5;\n");
    if (chance(k, 12))
        put(k, &k->globals, "    if (x[at] > 0)\n    ");
    put(k, &k->globals, "    %s{\n%s", h->loop, h->setup);
    if (chance(k, 25))
        put(k, &k->globals, "        if (%s)\n    ", condition_in(k));
    else if (chance(k, 15))
        put(k, &k->globals, "        if (%s)\n            continue;\n", condition_in(k));
    put(k, &k->globals, "        sum = damp(sum + %s);\n%s", h->element, h->after);
    if (chance(k, 12))
        put(k, &k->globals, "        if (sum > 1)\n            %s;\n",
            chance(k, 50) ? "break" : "return sum");
    put(k, &k->globals,
        "    }\n    (void)list;\n    (void)row;\n    (void)count;\n    return sum;\n}\n");
}

/* Appends a function that returns the position of a key in a row, or -1. */
static void put_search(kernel *k, const char *function) {
    const bool is_row = chance(k, 60);
    put(k, &k->globals,
        "static int %s(const double *x, const int *list, const int *row, int at, int count) {\n"
        "    for (int c = %s; c < %s; c++)\n        if (%s)\n            return %s;\n"
        "    (void)x;\n    (void)row;\n    (void)count;\n    return -1;\n}\n",
        function, is_row ? "row[at]" : "at", is_row ? "row[at + 1]" : "at + count",
        chance(k, 80) ? "list[c] % 5 == count % 5" : "x[c] > 0.5 && list[c] > 0",
        chance(k, 80) ? text(k, "c & %d", k->elements - 1)
                      : text(k, "list[c] & %d", k->elements - 1));
}

void call_of_helper(kernel *k) {
    const array *a = any_reduction(k);
    const bool is_updated =
        a->type == E_DOUBLE && a->shape == SHAPE_FLAT && !a->is_no_integer && chance(k, 15);
    const char *function = new_name(k, "helper");
    const array *lists[] = {&k->chain, &k->flag, &k->far};
    const char *list = lists[below(k, 2)]->base;
    const char *at = chance(k, 60) ? position(k) : subscript(k);
    const char *arguments = text(k, "%s, %s, %s, (int)(%s) & %d, 1 + (int)((%s) & 15)",
                                 is_updated ? a->base : k->other.base, list, k->first.base, at,
                                 k->elements / 2 - 1, subscript(k));
    if (chance(k, 30)) {
        const char *name = new_name(k, "k");
        put_search(k, function);
        put(k, &k->body, "int %s = %s(%s);\n", name, function, arguments);
        put(k, &k->body, "if (%s >= 0)\n%s;\n", name, update(k, a, place(k, a, name)));
        return;
    }
    helper h = {.before = ""};
    choose_loop(k, &h);
    choose_element(k, &h);
    put_sum(k, function, &h);
    const char *name = new_name(k, "d");
    put(k, &k->body, "double %s = damp(%s(%s));\n", name, function, arguments);
    add_name(&k->scope.values, name);
}

/* ---- elements by the address that a function returns ----------------------------------------- */

const char *place_by_accessor(kernel *k, const array *a, const char *index) {
    static const char *const types[] = {"int", "long", "size_t", "short", "unsigned char"};
    static const char *const forms[] = {"&%s[at]", "%s + at", "at + %s", "&(*(%s + at))"};
    /* Some expressions that begin with the kernel's names denote no object of the file. */
    const bool is_of_file =
        (a->storage == STORAGE_GLOBAL || a->storage == STORAGE_GLOBAL_POINTER) &&
        strstr(a->base, text(k, "_%llu", (unsigned long long)k->seed)) &&
        !strpbrk(a->base, "(?[") && !strstr(a->base, "both_") && chance(k, 50);
    const char *function = new_name(k, "slot");
    const char *type = a->shape == SHAPE_RECORDS ? a->record : elements[a->type].spelling;
    const bool is_row = a->shape == SHAPE_ROWS;
    const char *base = is_of_file ? a->base : "from";
    put(k, &k->globals, "static %s%s *%s(%s%s at) {\n", chance(k, 30) ? "inline " : "", type,
        function, is_of_file ? "" : text(k, is_row ? "%s (*from)[3], " : "%s *from, ", type),
        types[below(k, 5)]);
    if (chance(k, 10))
        put(k, &k->globals, "    if (at > %d)\n        return %s%s;\n", k->elements,
            is_row ? "*" : "", base);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    put(k, &k->globals, "    return %s;\n}\n",
        is_row ? text(k, chance(k, 50) ? "%s[at]" : "&%s[at][0]", base)
               : text(k, forms[below(k, 4)], base));
#pragma GCC diagnostic pop
    const char *call = is_of_file ? text(k, "%s(%s)", function, index)
                                  : text(k, "%s(%s, %s)", function, a->base, index);
    if (is_row)
        return text(k, "%s[%d]", call, below(k, 3));
    if (a->shape == SHAPE_RECORDS)
        return text(k, "%s->%c", call, chance(k, 50) ? 'x' : 'y');
    return text(k, "(*%s)", call);
}

/* ---- an update in several statements --------------------------------------------------------- */

void in_pieces(kernel *k) {
    const array *a = any_reduction(k);
    const char *name = new_name(k, "v");
    const char *where = place(k, a, chance(k, 85) ? subscript(k) : position(k));
    const char *type = elements[a->type].spelling;
    const char *first = contribution(k, a);
    const bool is_outer = chance(k, 25);
    if (is_outer)
        declare_outside(k, type, name, "0");
    put(k, &k->body, "%s%s%s = %s;\n", is_outer ? "" : type, is_outer ? "" : " ", name, where);
    if (chance(k, 10))
        put(k, &k->body, "%s[%s] = 0.25;\n", k->out.base, position(k));
    if (chance(k, 60))
        put(k, &k->body, "if (%s)\n", condition(k));
    switch (a->operation[0]) {
    case '<':
    case '>':
        put(k, &k->body, "%s = %s %s %s ? %s : %s;\n", name, name, a->operation, first, name,
            first);
        break;
    default:
        put(k, &k->body, "%s %s= %s;\n", name, a->operation, first);
    }
    if (chance(k, 8)) /* stored to another element */
        where = place(k, a, subscript(k));
    put(k, &k->body, "%s = %s;\n", where, name);
    if (chance(k, 10))
        put(k, &k->body, "%s;\n", update(k, a, where));
}
