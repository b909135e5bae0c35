/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Statements from the second series of attacks: counters set inside their loops, comparisons stored
 * in integers of every type, scalars in write-protected memory with updates under a condition that
 * never holds, and functions of another file. Only in programs with seed % 3 == 1. */
#include "fuzz/kernel.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

/* Returns a condition on the iteration's value, or one that is the same in all iterations. */
static const char *condition_on(kernel *k, const char *name) {
    static const char *const forms[] = {"%1$s < 0.25", "%1$s > 0.5", "%1$s < 0.5 && %1$s > -0.5",
                                        "!(%1$s < 0.125)", "%1$s < -0.25 || %1$s > 0.75"};
    if (chance(k, 10))
        return "n > 100";
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    return text(k, forms[below(k, LENGTH(forms))], name);
#pragma GCC diagnostic pop
}

/* Returns a change of the counter or of the bound. */
static const char *jump(kernel *k, const char *counter, const char *bound, const char *when) {
    switch (below(k, 9)) {
    case 0:
    case 1:
        return text(k, "if (%s)\n%s = %d;\n", when, counter, 6 + below(k, 4));
    case 2:
        return text(k, "if (%s)\n%s += %d;\n", when, counter, 1 + below(k, 3));
    case 3:
        return text(k, "if (%s) {\n%s++;\n}\n", when, counter);
    case 4:
        return text(k, "if (%s)\n%s = 1;\n", when, bound);
    case 5:
        return text(k, "%s += (%s) ? 2 : 0;\n", counter, when);
    case 6:
        return text(k, "(void)((%s) && (%s = 9));\n", when, counter);
    case 7:
        return text(k, "if (n > 50) {\nif (%s)\n%s += 1;\n}\n", when, counter);
    default:
        return text(k, "if (%s)\nfor (%s = 5; %s < 8; %s++)\n%s;\n", when, counter, counter,
                    counter, "(void)0");
    }
}

/* A loop that some iterations leave earlier than others. */
static void counter_set_inside(kernel *k) {
    const char *r = new_name(k, "r"), *c = new_name(k, "c"), *end = new_name(k, "e");
    const bool is_outside = chance(k, 30);
    const char *first = value(k, 1);
    put(k, &k->body, "double %s = %s;\n", r, first);
    put(k, &k->body, "int %s = %d;\n", end, 3 + below(k, 5));
    if (is_outside)
        declare_outside(k, "int", c, "0");
    const char *when = condition_on(k, r);
    const char *step = text(k, "%s = %s * 0.5 + %s;\n", r, r, value(k, 0));
    const char *set = jump(k, c, end, when);
    if (chance(k, 80))
        put(k, &k->body, "for (%s%s = 0; %s < %s; %s++) {\n%s%s}\n", is_outside ? "" : "int ", c, c,
            end, c, step, set);
    else
        put(k, &k->body, "%s%s = 0;\nwhile (%s < %s) {\n%s%s%s++;\n}\n", is_outside ? "" : "int ",
            c, c, end, step, set, c);
    if (chance(k, 40))
        put(k, &k->body, "if (%s)\n%s = 0.25 - %s;\n", condition_on(k, r), r, r);
    put(k, &k->body, "(void)%s;\n", end);
    add_name(&k->scope.values, r);
}

/* A comparison stored in an integer of some type, and arithmetic in which these types differ. */
static void mask(kernel *k) {
    static const char *const types[] = {
        "int",   "unsigned",    "unsigned",       "long",      "unsigned long", "unsigned char",
        "short", "signed char", "unsigned short", "long long", "size_t"};
    static const char *const uses[] = {"(%s - 2) / 3",  "-%s >> 1",   "~%s",     "(%s - 2) %% 5",
                                       "(%s << 7) - 3", "%s ? 5 : 2", "-%s / 2", "(%s - 1) >> 3"};
    const array *a = any_reduction(k);
    const char *r = new_name(k, "r"), *near = new_name(k, "m"), *use = new_name(k, "u");
    const char *v = value(k, 1), *at = place(k, a, subscript(k));
    put(k, &k->body, "const double %s = %s;\n", r, v);
    put(k, &k->body, "const %s %s = %s;\n", types[below(k, LENGTH(types))], near,
        condition_on(k, r));
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    const char *text_of_use = text(k, uses[below(k, LENGTH(uses))], near);
#pragma GCC diagnostic pop
    const bool is_plain = elements[a->type].is_floating || *a->operation == '+';
    if (is_plain && *a->operation == '+' && chance(k, 60)) {
        put(k, &k->body, "%s += (int)((%s) & 127);\n", at, text_of_use);
        return;
    }
    put(k, &k->body, "const int %s = (int)((%s) & 3);\n", use, text_of_use);
    put(k, &k->body, "(void)%s;\n", use);
    add_name(&k->scope.smalls, text(k, "(%s %% 3)", use));
}

/* Appends an update of a write-protected object, under a condition that never holds. So the program
 * does not write the object while the loop runs. */
static void held_scalar(kernel *k) {
    static const struct {
        const char *type, *initial, *update; /* %1$s: the object, %2$s: a value, %3$s: an integer */
    } kinds[] = {
        {"int", "3", "%1$s++;\n"},
        {"long", "-1", "%1$s -= %3$s;\n"},
        {"unsigned char", "250", "%1$s += %3$s;\n"},
        {"unsigned", "7", "%1$s ^= (unsigned)%3$s;\n"},
        {"unsigned long", "~0ul", "%1$s &= (unsigned long)%3$s;\n"},
        {"short", "1", "%1$s |= 4;\n"},
        {"double", "-0.0", "%1$s += %2$s;\n"},
        {"double", "0.0", "%1$s -= %2$s;\n"},
        {"double", "1.5", "%1$s *= %2$s;\n"},
        {"float", "0.0f", "%1$s += (float)(%2$s);\n"},
        {"double", "9.0", "%1$s = %2$s < %1$s ? %2$s : %1$s;\n"},
        {"double", "-9.0", "if (%2$s >= %1$s)\n%1$s = %2$s;\n"},
        {"int", "5", "for (int zz = 0; zz < 3; zz++)\n%1$s += zz + %3$s;\n"},
    };
    const char *held = new_name(k, "held"), *never = new_name(k, "never");
    const char *x = new_name(k, "x"), *name = held;
    const int which = below(k, LENGTH(kinds));
    const char *v = value(k, 1), *i = integer(k, 0);
    put(k, &k->globals, "static int %s[%d];\nFUZZ_HELD %s %s = %s;\n", never, k->size,
        kinds[which].type, held, kinds[which].initial);
    if (chance(k, 25) && which != 10 && which != 11) {
        name = new_name(k, "at");
        put(k, &k->locals, "    %s *const %s = &%s;\n", kinds[which].type, name, held);
        name = text(k, "(*%s)", name);
    }
    put(k, &k->body, "const double %s = %s;\n(void)%s;\n", x, v, x);
    const char *when = text(k, "%s[%s]", never, any_name(k, &k->scope.positions));
    if (chance(k, 30))
        when = text(k, "%s && (%s)", when, condition_on(k, x));
    put(k, &k->body, "if (%s) {\n", when);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    put(k, &k->body, kinds[which].update, name, x, i);
#pragma GCC diagnostic pop
    put(k, &k->body, "}\n");
    put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, held);
    k->has_held = true;
}

/* A function of another file, which reads values of the calling thread. */
static void elsewhere(kernel *k) {
    const char *name = new_name(k, "d");
    const char *e = integer(k, 0);
    put(k, &k->body, "const double %s = fuzz_%s(%s);\n", name, chance(k, 50) ? "level" : "scaled",
        e);
    add_name(&k->scope.values, name);
}

void shape_of_an_attack(kernel *k) {
    if (chance(k, 3))
        elsewhere(k);
    else if (chance(k, 35))
        counter_set_inside(k);
    else if (chance(k, 50))
        mask(k);
    else if (!k->scope.in_loop)
        held_scalar(k);
}
