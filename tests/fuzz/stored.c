/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Elements that an iteration stores and reads again; and some that only look so. */
#include "fuzz/kernel.h"

#define LENGTH(stored) (int)(sizeof(stored) / sizeof *(stored))

/* An array of the program's own for stored subscripts, or values, that is compared in the end. */
static const char *new_stored(kernel *k, bool is_value) {
    static const char *const integers[] = {"int", "int", "short", "unsigned char", "long"};
    static const char *const floats[] = {"double", "double", "float"};
    const char *name = new_name(k, "stored");
    const char *type = is_value ? floats[below(k, LENGTH(floats))] : integers[below(k, 5)];
    put(k, &k->globals, "static %s %s[%d];\n", type, name, k->size);
    put(k, &k->after, "    fuzz_print(\"%s\", %s, sizeof %s);\n", name, name, name);
    return name;
}

/* Which element: the iteration's own, or one that others store to as well. */
static const char *element_of(kernel *k, const char *stored) {
    const char *p = k->scope.positions.name[0];
    if (k->scope.subscripts.count && chance(k, 25))
        return text(k, "%s[%s]", stored, any_name(k, &k->scope.subscripts));
    return below(k, 3) ? text(k, "%s[%s]", stored, p)
                       : text(k, "%s[%s + %d]", stored, p, below(k, 9));
}

void stored_again(kernel *k) {
    const bool is_value = chance(k, 50);
    const char *stored = is_value && chance(k, 30) ? k->out.base : new_stored(k, is_value);
    const char *e = element_of(k, stored);
    put(k, &k->body, "%s = %s;\n", e, is_value ? value(k, 1) : subscript(k));
    add_name(is_value ? &k->scope.values : &k->scope.subscripts, e);
}

void nearly_stored_again(kernel *k) {
    const char *stored = new_stored(k, false);
    const char *p = k->scope.positions.name[0];
    const char *e = text(k, "%s[%s]", stored, p), *read = e;
    switch (below(k, 6)) {
    case 0: /* another element */
        put(k, &k->body, "%s = %s;\n", e, subscript(k));
        read = text(k, "%s[%s + 1]", stored, p);
        break;
    case 1: { /* not always */
        const char *when = condition(k);
        put(k, &k->body, "if (%s) {\n%s = %s;\n}\n", when, e, subscript(k));
        break;
    }
    case 2: { /* another element by then */
        const char *at = new_name(k, "k");
        put(k, &k->body, "int %s = %s;\n", at, subscript(k));
        e = read = text(k, "%s[%s]", stored, at);
        put(k, &k->body, "%s = %s;\n%s ^= 1;\n", e, subscript(k), at);
        break;
    }
    case 3: { /* by another name */
        const char *name = new_name(k, "p");
        put(k, &k->body, "__typeof__(&%s[0]) %s = &%s;\n", stored, name, e);
        put(k, &k->body, "%s = %s;\n", e, subscript(k));
        read = text(k, "*%s", name);
        break;
    }
    case 4: /* from what it held */
        put(k, &k->body, "%s = (%s + %s) & %d;\n", e, e, subscript(k), k->elements - 1);
        break;
    default: { /* read first: what the last round has left */
        const char *name = new_name(k, "k");
        put(k, &k->body, "int %s = %s;\n", name, e);
        put(k, &k->body, "%s = %s;\n", e, subscript(k));
        read = name;
        break;
    }
    }
    add_name(&k->scope.subscripts, read);
}
