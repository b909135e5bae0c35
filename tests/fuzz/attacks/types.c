/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Memory whose type changes while the loop runs, and types that C permits to overlap. */
#include "fuzz/attacks/attack.h"

#include <string.h>

static const char *const conversions[][2] = {
    {"float", "double"},        {"int", "double"},   {"short", "int"},
    {"unsigned char", "short"}, {"double", "float"}, {"long", "int"},
    {"double", "int"},          {"float", "int"},    {"double", "long"},
    {"unsigned", "long"},       {"int", "unsigned"}, {"short", "double"},
    {"long", "long long"},      {"long", "double"},  {"unsigned short", "float"},
};

/* An update by to[place[t]] = from[t], both at one address in allocated memory. Each store
 * overwrites only memory that has been read (C17 6.5p6). */
static operand in_place(attack *a) {
    const char *const *c = conversions[below(a, (int)(sizeof conversions / sizeof *conversions))];
    const int n = a->trips + SPARE;
    note(a, "types/in-place");
    put(a, PART_GLOBALS,
        "static void *block$;\nstatic int place$[%d];\n"
        "static const %s *fresh$(void) {\n%s *p = block$;\nfor (int i = 0; i < %d; i++)\n"
        "p[i] = (%s)(attack_below(200) - 100);\nreturn p;\n}\n",
        n, c[0], c[0], n, c[0]);
    put(a, PART_SETUP,
        "block$ = malloc(%d);\nfor (int i = 0; i < %d; i++) {\n"
        "const int most = (i + 1) * (int)sizeof(%s) / (int)sizeof(%s);\n"
        "place$[i] = most ? most - 1 - attack_below(attack_below(2) ? most : 9 < most ? 9 : most) "
        ": -1;\n}\n",
        n * 16, n, c[0], c[1]);
    put(a, PART_FINISH, "free(block$);\n");
    put(a, PART_PARAMETERS, ", const %s *from$, %s *to$", c[0], c[1]);
    put(a, PART_ARGUMENTS, ", fresh$(), block$");
    put(a, PART_AFTER,
        "for (int i = 0; i < %d; i++)\nif (place$[i] >= 0)\n"
        "attack_note((double)to$[place$[i]]);\n",
        a->trips / 2);
    if (chance(a, 50))
        put(a, PART_BODY, "if (place$[t] >= 0)\nto$[place$[t]] = (%s)from$[t];\n", c[1]);
    else
        put(a, PART_BODY,
            "if (place$[t] < 0)\ncontinue;\nconst %s f$ = from$[t];\n"
            "to$[place$[t]] = (%s)(f$ %s);\n",
            c[0], c[1], chance(a, 50) ? "+ 1" : "");
    return (operand){chance(a, 50) ? NULL : "1", true, false, NULL};
}

/* The bytes of x, which may be bytes of h. */
static operand bytes(attack *a) {
    note(a, "types/bytes");
    static const char *const forms[] = {
        "const unsigned char *b$ = (const void *)x;\n",
        "const char *const b$ = (const char *)x;\n",
        "const signed char *b$;\nb$ = (const void *)x;\n",
    };
    put(a, chance(a, 60) ? PART_BEFORE : PART_BODY, "%s", text(a, forms[below(a, 3)]));
    return (operand){text(a, "b$[t * sizeof *x + %d]", below(a, 2)), true, false, NULL};
}

static operand copied(attack *a) {
    note(a, "types/copied");
    put(a, PART_BODY, "%s v$;\n%s(&v$, x + t, sizeof v$);\n", a->element,
        chance(a, 50) ? "memcpy" : "__builtin_memcpy");
    return (operand){text(a, "v$"), !a->is_floating, false, NULL};
}

static const char *other_sign(const char *type) {
    return strcmp(type, "unsigned") == 0        ? "int"
           : strcmp(type, "unsigned char") == 0 ? "signed char"
           : strcmp(type, "unsigned long") == 0 ? "long"
           : strcmp(type, "short") == 0         ? "unsigned short"
                                                : "unsigned";
}

/* Returns a read of x[t] through another type: an integer of the other sign, a type with may_alias,
 * a record of one member, or an array of one element. */
static operand seen_otherwise(attack *a) {
    note(a, "types/seen-otherwise");
    switch (below(a, 4)) {
    case 0:
        if (a->is_floating)
            return copied(a);
        return (operand){text(a, "((const %s *)x)[t]", other_sign(a->element)), true, false, NULL};
    case 1:
        put(a, PART_GLOBALS, "typedef %s __attribute__((__may_alias__)) other$;\n",
            a->is_floating ? (a->element[0] == 'd' ? "long" : "int") : a->element);
        return (operand){text(a, "(int)(((const other$ *)x)[t] & 255)"), true, false, NULL};
    case 2:
        put(a, PART_GLOBALS, "struct one$ {\n%s value;\n};\n", a->element);
        return (operand){text(a, "((const struct one$ *)x)[t].value"), !a->is_floating, false,
                         NULL};
    default:
        put(a, PART_GLOBALS, "typedef volatile %s kept$;\n", a->element);
        return (operand){text(a, "((const %s (*)[1])x)[t][0]", a->element), !a->is_floating, false,
                         NULL};
    }
}

operand changed_types(attack *a) {
    switch (below(a, 5)) {
    case 0:
        return bytes(a);
    case 1:
        return copied(a);
    case 2:
        return seen_otherwise(a);
    default:
        return in_place(a);
    }
}
