/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* One name for two things: in a called function and in the loop, or in the loop and around it.
 * Their values differ, so a translation that confuses them reads elsewhere. */
#include "fuzz/attacks/attack.h"

/* What `N$` means: declared at the beginning of the file, within a function, or as a macro. */
typedef struct meaning {
    const char *declaration; /* with one %d for the value */
    const char *use;
    bool is_tag;    /* only another tag can hide it */
    bool is_global; /* declared before the function, not in it */
} meaning;

static const meaning meanings[] = {
    {"enum { N$ = %d };\n", "N$", false, false},
    {"struct N$ { char c[%d]; };\n", "(int)sizeof(struct N$)", true, false},
    {"union N$ { char c[%d]; };\n", "(int)sizeof(union N$)", true, false},
    {"typedef char N$[%d];\n", "(int)sizeof(N$)", false, false},
    {"const int N$ = %d;\n", "N$", false, false},
    {"static const int N$[2] = {%d, 9};\n", "N$[0]", false, false},
    {"enum { N$ = %d };\n", "N$", false, true},
    {"struct N$ { char c[%d]; };\n", "(int)sizeof(struct N$)", true, true},
    {"typedef char N$[%d];\n", "(int)sizeof(N$)", false, true},
    {"typedef char N$[%d];\n", "(int)sizeof(N$) + 0 * (int)sizeof(N$ *)", false, true},
    {"static int N$ = %d;\n", "N$", false, true},
    {"static const int N$[2] = {%d, 9};\n", "N$[0]", false, true},
    {"static struct { int at; } N$ = {%d};\n", "N$.at", false, true},
};

/* Declarations in the kernel that hide it, of value %d or size %d. */
static const char *const hiding_names[] = {
    "enum { N$ = %d };\n",
    "const int N$ = %d;\n",
    "static const int N$[2] = {%d, 1};\n",
    "const int N$[2] = {%d, 1};\n",
    "typedef char N$[%d];\n",
    "static int N$ = %d;\n",
    "struct { int at; } N$ = {%d};\n",
    "int N$ = %d;\n(void)&N$;\n",
};
static const char *const hiding_tags[] = {"struct N$ { char c[%d]; };\n",
                                          "union N$ { char c[%d]; };\n"};

/* Defines int look$(a, t), which returns a[t + there], with elements of the type. */
static void put_look_up(attack *a, const meaning *m, const char *type, int there) {
    const char *declaration = text(a, m->declaration, there);
    if (m->is_global)
        put(a, PART_GLOBALS, "%s", declaration);
    put(a, PART_GLOBALS, "static %s look$(const %s *a, int t) {\n%sreturn a[t + %s];\n}\n", type,
        type, m->is_global ? "" : declaration, m->use);
}

static void put_hiding(attack *a, const meaning *m, int here) {
    const char *declaration = m->is_tag ? one_of(a, 2, hiding_tags) : one_of(a, 8, hiding_names);
    if (m->is_tag && (declaration[0] == 'u') != (m->use[11] == 'u'))
        declaration = m->use[11] == 'u' ? hiding_tags[1] : hiding_tags[0];
    if (!m->is_tag && chance(a, 15)) {
        put(a, PART_PARAMETERS, ", int N$");
        put(a, PART_ARGUMENTS, ", %d", here);
        return;
    }
    /* At the beginning of the file the declaration hides nothing, but has the name of the
     * function's own declaration. */
    const part where = !m->is_global && chance(a, 30) ? PART_GLOBALS
                       : chance(a, 65)                ? PART_BEFORE
                                                      : PART_BODY;
    if (where == PART_GLOBALS)
        declaration = m->is_tag ? declaration : "enum { N$ = %d };\n";
    put(a, where, "%s", text(a, declaration, here));
}

/* A macro that is redefined after the function. */
static void put_macro(attack *a, const char *type, int there, int here) {
    put(a, PART_GLOBALS,
        "#define N$ %d\nstatic %s look$(const %s *a, int t) {\nreturn a[t + N$];\n}\n#undef N$\n"
        "#define N$ %d\n",
        there, type, type, here);
}

operand hidden_names(attack *a) {
    const int many = (int)(sizeof meanings / sizeof *meanings);
    const bool in_x = chance(a, 50);
    const char *type = in_x ? a->element : "int";
    const int there = in_x ? 1 + below(a, a->trips - 1) : 1 + below(a, SPARE - 1);
    const int here = there > 20 || chance(a, 50) ? 1 + below(a, there) : there + 1 + below(a, 900);
    const meaning *m = &meanings[below(a, many)];
    if (!in_x)
        put_table(a, "tab", a->elements, there);
    if (chance(a, 8)) {
        note(a, "names/macro");
        put_macro(a, type, there, here);
    } else {
        note(a, m->is_tag ? "names/tag" : m->is_global ? "names/global" : "names/of-function");
        put_look_up(a, m, type, there);
        put_hiding(a, m, here);
    }
    if (in_x)
        return (operand){text(a, "look$(x, (int)t)"), !a->is_floating, false, NULL};
    return (operand){text(a, "look$(tab$, (int)t)"), true, true, NULL};
}

/* ---- names declared in the loop and around it ------------------------------------------- */

typedef struct pair {
    const char *outer, *inner, *use; /* %d for a value in each */
    bool outer_is_local;             /* may be declared in the kernel as well */
} pair;

static const pair pairs[] = {
    {"enum { C$ = %d };\n", "enum { C$ = %d };\n", "C$", true},
    {"struct C$ { char c[%d]; };\n", "struct C$ { char c[%d]; };\n", "(int)sizeof(struct C$)",
     true},
    {"union C$ { char c[%d]; };\n", "union C$ { char c[%d]; };\n", "(int)sizeof(union C$)", true},
    {"typedef char C$[%d];\n", "typedef char C$[%d];\n", "(int)sizeof(C$)", true},
    {"enum { C$ = %d };\n", "const int C$ = %d;\n", "C$", true},
    {"static const int C$ = %d;\n", "enum { C$ = %d };\n", "C$", true},
    {"static const int C$ = %d;\n", "int C$ = %d;\n", "C$", true},
    {"enum { C$ = %d };\n", "enum tag$ { A$, B$, C$ = %d };\n", "C$", true},
    {"static int C$ = %d;\n", "struct { int C$; } in$ = {%d};\n", "in$.C$", true},
    {"#define C$ %d\n", "enum { D$ = %d };\n", "D$ + 0 * C$", false},
    {"typedef char C$[%d];\n", "char C$[%d];\n", "(int)sizeof C$", true},
    {"enum { C$ = %d };\n", "enum { E$ = C$, C$ = %d };\n", "C$ + 0 * E$", true},
};

static void put_pair(attack *a, const pair *p, int outer, int inner) {
    put(a, p->outer_is_local && chance(a, 50) ? PART_BEFORE : PART_GLOBALS, "%s",
        text(a, p->outer, outer));
    put(a, PART_BODY, "%s", text(a, p->inner, inner));
}

/* `extern int own$[];` in the body hides a parameter. Another function has such a declaration,
 * too. */
static operand extern_in_body(attack *a) {
    note(a, "names/extern");
    const char *object = text(a, "int own$[%d];\n", a->trips + SPARE);
    const bool before = chance(a, 80);
    if (before)
        put(a, PART_GLOBALS, "%s", object);
    put(a, PART_GLOBALS, "int other$(int i) {\nextern int own$[];\nreturn own$[i];\n}\n");
    if (!before)
        put(a, PART_GLOBALS, "%s", object);
    put(a, PART_SETUP, "attack_fill_ints(own$, %d, %d);\n", a->trips + SPARE, a->elements);
    put(a, PART_GLOBALS, "static int second$[%d];\n", a->trips + SPARE);
    put(a, PART_SETUP, "attack_fill_ints(second$, %d, %d);\n", a->trips + SPARE, a->elements);
    put(a, PART_PARAMETERS, ", const int *own$");
    put(a, PART_ARGUMENTS, ", second$");
    put(a, PART_BODY, "extern int own$[];\n");
    may_change(a, "own$[%d] = attack_below(%d);", below(a, a->trips), a->elements);
    return (operand){text(a, "own$[t]"), true, true, NULL};
}

operand shadowed_in_body(attack *a) {
    if (chance(a, 15))
        return extern_in_body(a);
    const pair *p = &pairs[below(a, (int)(sizeof pairs / sizeof *pairs))];
    const int outer = 1 + below(a, SPARE - 2), inner = 1 + below(a, SPARE - 2);
    note(a, "names/in-body");
    put_table(a, "tab", a->elements, inner);
    put_pair(a, p, outer, inner);
    return (operand){text(a, "tab$[t + %s]", p->use), true, true, NULL};
}
