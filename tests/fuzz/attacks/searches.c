/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Look-up functions that search a table, with narrow cursors, converted start values and other
 * steps. If the range compared between calls were not the range read, a change of the table would
 * go unnoticed. */
#include "fuzz/attacks/attack.h"

typedef struct search {
    const char *cursor; /* type of the cursor */
    const char *table;  /* type of the table */
    int first;          /* first subscript, after conversion */
    const char *start;  /* the expression of the first subscript */
} search;

static const char *const cursors[] = {"unsigned char",  "unsigned char", "signed char",
                                      "unsigned short", "int",           "unsigned",
                                      "long",           "size_t"};

static void choose_start(attack *a, search *s) {
    const int which = below(a, 8);
    s->cursor = cursors[which];
    s->table = chance(a, 70) ? "int" : "short";
    s->first = chance(a, 50) ? 0 : below(a, 100);
    const int around = which < 2    ? 256
                       : which == 3 ? 65536
                                    : 0; /* conversion to the type subtracts it */
    const char *first = text(a, chance(a, 50) ? "%d" : "from + %d", s->first + around);
    static const char *const narrower[] = {"(unsigned char)(%s + 512)", "(signed char)(%s + 256)",
                                           "(int)(%s + 0.5)", "(short)(%s + 65536)"};
    s->start = chance(a, 25) ? text(a, narrower[below(a, 4)], first) : first;
}

static void put_search(attack *a, const search *s) {
    static const char *const loops[] = {
        "%s i = %s;\nwhile (a[i] <= key)\ni++;\nreturn i;\n",
        "%s i = %s;\nwhile (a[i] <= key)\n++i;\nreturn i;\n",
        "%s i = %s;\nfor (; a[i] <= key; i++)\n;\nreturn i;\n",
        "%s i = %s;\nfor (; !(a[i] > key);)\ni++;\nreturn i;\n",
        "%s i;\nfor (i = %s; a[i] <= key; i++)\n;\nreturn (int)i;\n",
        "%s i = %s;\nwhile (!(a[i] > key))\ni += 1;\nreturn i;\n",
        "%s i = %s;\ndo {\nif (a[i] > key)\nbreak;\ni++;\n} while (1);\nreturn (int)i;\n",
    };
    static const char *const results[] = {"int", "unsigned char", "long", "short"};
    put(a, PART_GLOBALS, "static %s find$(const %s *a, int key, int from) {\n%s}\n",
        results[chance(a, 60) ? 0 : below(a, 4)], s->table,
        text(a, loops[below(a, chance(a, 80) ? 4 : 7)], s->cursor, s->start));
}

/* The table ascends to a sentinel that a narrow cursor finds before it wraps around. */
static operand rising(attack *a) {
    search s;
    note(a, "search/rising");
    choose_start(a, &s);
    put_search(a, &s);
    const int length = 120, steps = 1 + below(a, 3);
    put(a, PART_GLOBALS, "static %s rows$[256];\n", s.table);
    put(a, PART_SETUP,
        "for (int i = 0; i < 256; i++)\nrows$[i] = (%s)(i < %d ? i / %d * 3 : 30000);\n", s.table,
        length, steps);
    /* If all searches look for distant values, all earlier elements are read, too. A change there
     * may end a search. */
    const int most = length * 3 / steps, lowest = chance(a, 50) ? most * 2 / 3 : 0;
    for (int i = 0; i < 6; i++) {
        const int place =
            s.first + below(a, lowest ? 1 + (length - s.first) / 2 : length - s.first);
        if (lowest)
            may_change(a, "rows$[%d] = 30000;", place);
        else
            may_change(a, "rows$[%d] = (%s)(rows$[%d] + 3);", place, s.table, place);
    }
    return (operand){text(a, "find$(in$, k[t] %% %d + %d, k[t] & %d)", most - lowest, lowest,
                          chance(a, 40) ? 7 : 0),
                     true, a->elements > 130, NULL};
}

/* The cursor passes the end of its type and continues at 0. */
static operand wrapping(attack *a) {
    note(a, "search/wrapping");
    const int first = 200 + below(a, 50);
    put(a, PART_GLOBALS,
        "static int rows$[256];\nstatic int find$(const int *a, int key) {\nunsigned char i = %d;\n"
        "while (a[i] != key)\ni++;\nreturn i;\n}\n",
        first);
    /* Few values are searched for, all of which are found after the wrap. */
    const int values = chance(a, 50) ? 256 : 1 + below(a, 30);
    put(a, PART_SETUP, "for (int i = 0; i < 256; i++)\nrows$[i] = (i + %d) %% 256;\n",
        values < 256 ? 106 : below(a, 256));
    for (int i = 0; i < 6; i++) {
        const int p = below(a, 256), q = below(a, 200);
        if (values < 256)
            may_change(a, "rows$[%d] = %d;",
                       below(a, 2) ? below(a, 120) : first + below(a, 255 - first),
                       below(a, values));
        else
            may_change(a, "{ int v = rows$[%d]; rows$[%d] = rows$[%d]; rows$[%d] = v; }", p, p, q,
                       q);
    }
    return (operand){text(a, "find$(in$, k[t] %% %d)", values), true, a->elements > 256, NULL};
}

/* Each call reads one element, which its arguments do not show. */
static operand indirect(attack *a) {
    note(a, "search/indirect");
    const int shift = 1 + below(a, SPARE - 1);
    put_table(a, "first", a->trips, 0);
    put_table(a, "second", a->elements, shift);
    static const char *const forms[] = {
        "static int look$(const int *p, const int *q, int t) {\nreturn q[p[t] + %d];\n}\n",
        "static int look$(const int *p, const int *q, int t) {\nq += %d;\nreturn q[p[t]];\n}\n",
        "static int look$(const int *p, const int *q, int t) {\nconst int *r = p + t;\n"
        "return *(q + *r + %d);\n}\n",
        "static int look$(const int *p, const int *q, int t) {\nint s = 0;\n"
        "for (int i = 0; i < 2; i++)\ns = q[p[t + i] + %d];\nreturn s;\n}\n",
    };
    put(a, PART_GLOBALS, "%s", text(a, forms[below(a, 4)], shift));
    return (operand){text(a, "look$(first$, second$, (int)t)"), true, true, NULL};
}

operand searches(attack *a) {
    /* through a pointer, since the runtime keeps no plan for a named array */
    const bool by_pointer = chance(a, 85);
    const int which = below(a, 6);
    operand o = which == 0 ? indirect(a) : which < 3 ? wrapping(a) : rising(a);
    if (which > 0) {
        if (by_pointer)
            put(a, PART_PARAMETERS, ", const __typeof__(rows$[0]) *in$");
        if (by_pointer)
            put(a, PART_ARGUMENTS, ", rows$");
        if (!by_pointer)
            put(a, PART_GLOBALS, "#define in$ rows$\n");
    }
    if (chance(a, 70)) {
        put(a, PART_BODY, "const int f$ = %s;\n", o.text);
        o.text = text(a, "f$");
    }
    if (!o.is_subscript) {
        o.text = text(a, "(int)((unsigned)%s %% %du)", o.text, (unsigned)a->elements);
        o.is_subscript = true;
    }
    return o;
}
