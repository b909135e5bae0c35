/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Rows behind pointers in memory: updated, read, and some of them moved while the loop runs. Only
 * in programs with seed % 5 == 0, so that other seeds yield the same programs as before. */
#include "fuzz/kernel.h"

/* Declares a table of k->size pointers to rows of at least three elements in `memory`, some of
 * which overlap or are equal. Returns the table's expression in the kernel. */
static const char *declare_table(kernel *k, const char *type, const char *memory) {
    const char *name = new_name(k, "rows");
    const int mask = k->elements - 1;
    const char *const places[] = {text(k, "(r & %d)", mask), text(k, "(r * 5 & %d)", mask),
                                  text(k, "%d - (r & %d)", mask, mask),
                                  text(k, "(r * 3 / 2 & %d)", mask), "(r & 1)"};
    const char *place = places[below(k, 5)];
    const bool is_member = chance(k, 30);
    if (is_member)
        put(k, &k->globals, "static struct {\n    int tag;\n    %s *row;\n} %s[%d];\n", type, name,
            k->size);
    else
        put(k, &k->globals, "static %s *%s[%d];\n", type, name, k->size);
    put(k, &k->locals, "    for (int r = 0; r < %d; r++)\n        %s[r]%s = %s + %s;\n", k->size,
        name, is_member ? ".row" : "", memory, place);
    if (is_member)
        return text(k, "%s[%%s].row", name);
    if (chance(k, 40)) {
        const char *pointer = new_name(k, "p");
        put(k, &k->locals, "    %s **%s = %s;\n", type, pointer, name);
        name = pointer;
    }
    return text(k, "%s[%%s]", name);
}

/* Returns the row of a table at a subscript. */
static const char *row_at(kernel *k, const char *table, const char *index) {
    buffer out = {0};
    for (const char *c = table; *c; c++)
        if (c[0] == '%' && c[1] == 's') {
            buffer_text(&out, index);
            c++;
        } else {
            buffer_byte(&out, *c);
        }
    const char *row = text(k, "%s", out.data);
    buffer_free(&out);
    return row;
}

static const char *column(kernel *k) {
    return k->scope.smalls.count && chance(k, 50) ? any_name(k, &k->scope.smalls)
                                                  : text(k, "%d", below(k, 3));
}

static void put_row_update(kernel *k, const array *a, const char *row) {
    switch (below(k, 4)) {
    case 0: {
        const char *name = new_name(k, "row");
        put(k, &k->body, "%s *%s = %s;\n", elements[a->type].spelling, name, row);
        row = name;
        break;
    }
    case 1:
        put(k, &k->body, "%s;\n", update(k, a, text(k, "(*%s)", row)));
        return;
    default:
        break;
    }
    put(k, &k->body, "%s;\n", update(k, a, text(k, "%s[%s]", row, column(k))));
}

/* The loop reads rows of other doubles, or of an array that it updates. */
static void read_row(kernel *k, const array *a) {
    const bool is_updated = a->type == E_DOUBLE && chance(k, 25);
    const char *table = declare_table(k, "double", is_updated ? a->base : k->other.base);
    const char *index = chance(k, 60) ? position(k) : subscript(k);
    const char *name = new_name(k, "d");
    put(k, &k->body, "double %s = damp(%s[%s]);\n", name, row_at(k, table, index), column(k));
    add_name(&k->scope.values, name);
}

void rows_behind_pointers(kernel *k) {
    const array *a = any_reduction(k);
    if (a->shape != SHAPE_FLAT)
        return;
    if (chance(k, 35)) {
        read_row(k, a);
        return;
    }
    const char *table = declare_table(k, elements[a->type].spelling, a->base);
    const char *row = row_at(k, table, chance(k, 85) ? subscript(k) : position(k));
    put_row_update(k, a, row);
    if (chance(k, 8))
        put(k, &k->body, "%s = %s + %d;\n", row_at(k, table, subscript(k)), a->base, below(k, 9));
}
