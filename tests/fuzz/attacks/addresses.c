/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Addresses that the program compares. They are those of the kernel's variables, of which each
 * thread may have a copy, of parameters, and of static objects and their parts. Also variables that
 * are accessed through their address. */
#include "fuzz/attacks/attack.h"

typedef struct object {
    const char *declaration;
    part where;
    const char *address;
    const char *use; /* an int expression of the object's value in the loop, or NULL */
} object;

static const object objects[] = {
    {"char mark$ = 1;\n", PART_BEFORE, "&mark$", "mark$"},
    {"int mark$ = 3;\n", PART_BEFORE, "&mark$", "mark$"},
    {"double mark$ = 2;\n", PART_BEFORE, "&mark$", "(int)mark$"},
    {"struct { int a, b; } mark$ = {1, 2};\n", PART_BEFORE, "&mark$", "mark$.b"},
    {"struct { int a, b; } mark$ = {1, 2};\n", PART_BEFORE, "&mark$.b", "mark$.b"},
    {"int mark$[2] = {4, 5};\n", PART_BEFORE, "&mark$[1]", "mark$[1]"},
    {"int mark$[2] = {4, 5};\n", PART_BEFORE, "mark$", NULL},
    {"static char mark$;\n", PART_GLOBALS, "&mark$", "mark$"},
    {"static char mark$;\n", PART_BEFORE, "&mark$", NULL},
    {"static int mark$[3];\n", PART_GLOBALS, "mark$ + 1", NULL},
    {"int mark$;\n", PART_GLOBALS, "&mark$", "mark$"},
    {"int const mark$ = 7;\n", PART_BEFORE, "&mark$", "mark$"},
    {"register int unused$ = 7;\nint mark$ = unused$;\n", PART_BEFORE, "&mark$", NULL},
};

static const char *comparison(attack *a, const char *address) {
    switch (below(a, 6)) {
    case 0:
        put(a, PART_BEFORE, "const void *const seen$ = %s;\n", text(a, address));
        return text(a, "entry$[t] == seen$");
    case 1:
        put(a, PART_BODY, "const void *seen$ = %s;\n", text(a, address));
        return text(a, "entry$[t] != seen$");
    case 2:
        return text(a, "(unsigned long)entry$[t] - (unsigned long)(%s) == 0", text(a, address));
    case 3:
        put(a, PART_GLOBALS,
            "static int is_it$(const void *p, const void *q) {\nreturn p == q;\n}\n");
        return text(a, "is_it$(entry$[t], %s)", text(a, address));
    default:
        return text(a, "entry$[t] == %s%s", chance(a, 50) ? "(const void *)" : "(void *)",
                    text(a, "(%s)", text(a, address)));
    }
}

static operand mark(attack *a) {
    const object *o = &objects[below(a, (int)(sizeof objects / sizeof *objects))];
    note(a, o->where == PART_BEFORE ? "addresses/local" : "addresses/global");
    put(a, PART_GLOBALS, "static const void *entry$[%d];\n", a->trips + SPARE);
    put(a, o->where, "%s", text(a, o->declaration));
    put(a, PART_BEFORE, "attack_mark(entry$, %d, %s);\n", a->trips, text(a, o->address));
    const char *compared = comparison(a, o->address);
    if (o->use && chance(a, 40))
        compared = text(a, "(%s) + (%s & 1)", compared, text(a, o->use));
    if (chance(a, 40)) {
        put(a, PART_BODY, "if ((%s) == 0)\ncontinue;\n", compared);
        return (operand){"(int)t", true, false, NULL};
    }
    return (operand){text(a, "((%s) + 2)", compared), true, false, NULL};
}

/* The address of a parameter. */
static operand parameter(attack *a) {
    note(a, "addresses/parameter");
    put(a, PART_GLOBALS, "static const void *entry$[%d];\n", a->trips + SPARE);
    put(a, PART_PARAMETERS, ", int given$");
    put(a, PART_ARGUMENTS, ", %d", 1 + below(a, 9));
    put(a, PART_BEFORE, "attack_mark(entry$, %d, &given$);\n", a->trips);
    return (operand){text(a, "((entry$[t] == (void *)&given$) + given$)"), true, false, NULL};
}

/* The loop writes a variable that is also read through its address, in the loop or after it. */
static operand by_address(attack *a) {
    note(a, "addresses/alias");
    static const char *const types[] = {"double", "int", "float", "long"};
    const char *type = one_of(a, 4, types);
    put(a, PART_BEFORE, "%s own$ = 1;\n%s *at$ = attack_same(&own$);\n", type, type);
    put(a, PART_AFTER, "attack_note((double)%sat$);\n", "*");
    put(a, PART_BODY, "own$ = (%s)(k[t] & 7);\n", type);
    return (operand){text(a, chance(a, 50) ? "(int)*at$" : "(int)own$"), true, false, NULL};
}

/* The address of a variable of the iteration differs between threads; it equals only itself. */
static operand own_address(attack *a) {
    note(a, "addresses/private");
    put(a, PART_BODY, "int v$ = k[t];\nint *p$ = &v$;\n*p$ ^= %d;\n", 1 + below(a, 7));
    return (operand){text(a, "(v$ + (p$ == &v$))"), true, false, NULL};
}

operand addresses_as_values(attack *a) {
    switch (below(a, 8)) {
    case 0:
        return parameter(a);
    case 1:
        return by_address(a);
    case 2:
        return own_address(a);
    default:
        return mark(a);
    }
}
