/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Inner loops along lists whose end an element tells, in several spellings. Only in programs with
 * seed % 6 == 2. */
#include "fuzz/kernel.h"

enum { ROWS = 8, LONGEST = 6 };

/* The beginning of each loop, up to the first statement that uses the element. Arguments: the
 * pointer, the list's beginning, the element's name. */
typedef struct spelling {
    const char *head, *tail;
    bool may_continue;
} spelling;

static const spelling spellings[] = {
    {"const int *%1$s = %2$s;\nint %3$s;\nwhile ((%3$s = *%1$s++) != -1) {\n", "}\n", true},
    {"const int *%1$s;\nint %3$s;\nfor (%1$s = %2$s; (%3$s = *%1$s++) > -1;) {\n", "}\n", true},
    {"const int *%1$s;\nint %3$s;\nfor (%1$s = %2$s; (%3$s = *%1$s) >= 0; %1$s++) {\n", "}\n",
     true},
    {"int %3$s, %1$s = 0;\nwhile ((%3$s = (%2$s)[%1$s++]) >= 0) {\n", "}\n", true},
    {"int %3$s;\nfor (int %1$s = 0; (%3$s = (%2$s)[%1$s]) != -1; %1$s++) {\n", "}\n", true},
    {"const int *%1$s = %2$s;\nwhile (*%1$s != -1) {\nconst int %3$s = *%1$s;\n", "%1$s++;\n}\n",
     false},
    {"const int *%1$s = %2$s;\nfor (;;) {\nconst int %3$s = *%1$s++;\nif (%3$s < 0)\nbreak;\n",
     "}\n", true},
};

/* A table of lists, each with an end. Sometimes an iteration changes an element of another list. */
static const char *put_lists(kernel *k) {
    const char *lists = new_name(k, "lists");
    put(k, &k->globals, "static int %s[%d];\n", lists, ROWS * LONGEST);
    put(k, &k->locals,
        "    for (int c = 0; c < %d; c++)\n        %s[c] = c %% %d < c / %d %% %d ? c * %d & %d : "
        "-1;\n",
        ROWS * LONGEST, lists, LONGEST, LONGEST, LONGEST, 1 + 2 * below(k, 9), k->elements - 1);
    if (chance(k, 10))
        put(k, &k->body, "%s[((%s) & 7) * %d] = -1;\n", lists, subscript(k), LONGEST);
    return lists;
}

void list_of_row(kernel *k) {
    const scope outside = k->scope;
    const spelling *way = &spellings[below(k, (int)(sizeof spellings / sizeof *spellings))];
    const char *lists = put_lists(k);
    const char *first = text(k, "%s + ((%s) & 7) * %d", lists, subscript(k), LONGEST);
    const char *p = new_name(k, "p"), *e = new_name(k, "e");
    put(k, &k->body, "{\n");
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    put(k, &k->body, way->head, p, first, e);
    k->scope.in_loop = true;
    k->scope.can_skip = way->may_continue;
    add_name(&k->scope.subscripts, e);
    if (way->may_continue && chance(k, 20))
        put(k, &k->body, "if (%s)\ncontinue;\n", condition(k));
    if (chance(k, 20))
        put(k, &k->body, "if (%s == %d)\nbreak;\n", e, below(k, k->elements));
    const array *a = any_reduction(k);
    put(k, &k->body, "%s;\n", update(k, a, place(k, a, e)));
    if (chance(k, 40))
        statement(k);
    put(k, &k->body, way->tail, p, first, e);
#pragma GCC diagnostic pop
    put(k, &k->body, "}\n");
    k->scope = outside;
}
