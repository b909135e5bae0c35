/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Arrays that may overlap the array that the loop updates. Their values before the loop are invalid
 * subscripts, bounds or divisors, until earlier iterations make them valid. Each call fills the
 * arrays again, and some calls get disjoint arrays. */
#include "fuzz/attacks/attack.h"

enum { SIZE = 1024 /* elements of each array: a power of two above all positions */ };

static const char *const types[] = {"int", "int", "unsigned", "long"};

/* An invalid value is this much less than the valid one. With the large differences it is a
 * subscript outside all memory, with the small ones the subscript of another element. */
static const char *const missing[] = {"1000000000", "1000000000", "300", "7"};

/* Declares the arrays `s`, which is updated, `k`, which may lie in s, and `m` (int); their names
 * end in `$`. Also declares a function that fills them before a call: k[t] = `value`, or `value` -
 * `lacks` if k lies in s and t >= `from`. */
static void put_arrays(attack *a, const char *type, int shift, const char *value, const char *lacks,
                       int from) {
    put(a, PART_GLOBALS,
        "static %s state$[%d], apart$[%d], *pair$[2];\nstatic int m$[%d];\n"
        "static %s **fresh$(int is_one) {\nfor (int t = 0; t < %d; t++)\nstate$[t] = 0;\n",
        type, SIZE, SIZE, SIZE, type, SIZE);
    put(a, PART_GLOBALS,
        "for (int t = 0; t < %d - %d; t++) {\nconst int v = %s;\napart$[t] = v;\nif (is_one)\n"
        "state$[t + %d] = t < %d ? v : v - (%s)%s;\n}\n",
        SIZE, shift, value, shift, from, type, lacks);
    put(a, PART_GLOBALS, "pair$[0] = state$;\npair$[1] = is_one ? state$ + %d : apart$;\n", shift);
    put(a, PART_GLOBALS, "return pair$;\n}\n");
    put(a, PART_PARAMETERS, ", %s *const *pair$, const int *m$", type);
    put(a, PART_ARGUMENTS, ", fresh$(%s), m$", chance(a, 70) ? "1" : "attack_below(2)");
    put(a, PART_BEFORE, "%s *s$ = pair$[0];\nconst %s *k$ = pair$[1];\n", type, type);
    put(a, PART_AFTER, "for (int i$ = 0; i$ < %d; i$++)\nattack_note((double)s$[i$]);\n",
        a->trips / 2);
}

/* Does the feature begin the body? Otherwise an earlier one may leave the iteration before the
 * feature makes anything valid. */
static bool is_first(const attack *a) {
    return a->parts[PART_BODY].length == 0;
}

/* s[m[k[t]]] += ...: iteration t makes k[t + ahead] valid, so no iteration may be skipped. */
static operand chain(attack *a) {
    const char *type = one_of(a, 4, types), *lacks = one_of(a, 4, missing);
    const int ahead = 6 * (1 + below(a, 9)), shift = chance(a, 60) ? 0 : below(a, SPARE);
    const int factor = 2 * below(a, SIZE / 2) + 1, first = below(a, SIZE);
    const bool is_inner = chance(a, 30);
    note(a, is_inner ? "made-valid/bounds" : "made-valid/chain");
    const char *order = is_inner ? "t" : text(a, "(t * %d + %d) & %d", factor, first, SIZE - 1);
    put_arrays(a, type, shift, order, lacks, ahead);
    put(a, PART_SETUP, "for (int t = 0; t < %d; t++)\nm$[%s] = (t + %d) & %d;\n", SIZE, order,
        shift + ahead, SIZE - 1);
    if (is_inner)
        put(a, PART_BODY,
            "for (int j$ = (int)k$[t]; j$ <= (int)k$[t]; j$++)\n"
            "s$[m$[j$]] += %s;\n",
            lacks);
    else if (chance(a, 50))
        put(a, PART_BODY, "s$[m$[k$[t]]] += %s;\n", lacks);
    else
        put(a, PART_BODY, "const int i$ = m$[k$[t]];\ns$[i$] = s$[i$] + %s;\n", lacks);
    return (operand){chance(a, 50) ? NULL : "1", true, false, NULL};
}

/* Values that an iteration makes valid for itself. */
typedef struct own_form {
    const char *kind;
    const char *value; /* the final value of k[t]; NULL for a random subscript */
    const char *lacks;
    const char *added; /* the iteration adds this */
    const char *reads, *guard;
} own_form;

enum { OWN_SUBSCRIPT, OWN_KEY, OWN_COUNT = 4 };

static const own_form own_forms[OWN_COUNT] = {
    [OWN_SUBSCRIPT] = {"made-valid/subscript", NULL, NULL, NULL, "look$[k$[t]]", NULL},
    [OWN_KEY] = {"made-valid/key", NULL, NULL, NULL, "look$[k$[0]]", NULL},
    {"made-valid/divisor", "1 + t % 3", "(1 + t % 3)", "1 + (int)t % 3", "look$[(t + 1) / k$[t]]",
     NULL},
    {"made-valid/condition", "t & 1", "1", "1", "look$[t]", "k$[t] > 0"},
};

/* Each iteration makes valid what it reads: a subscript, a divisor, or a condition. */
static operand own(attack *a) {
    const char *type = one_of(a, 4, types), *lacks = one_of(a, 4, missing);
    const char *to = chance(a, 70) ? "m$[t]" : "(m$[t] + 0)";
    const int factor = 2 * below(a, SIZE / 2) + 1;
    int which = below(a, OWN_COUNT);
    if (which == OWN_KEY && !is_first(a))
        which = OWN_SUBSCRIPT;
    const own_form *form = &own_forms[which];
    note(a, form->kind);
    put_table(a, "look", a->elements, 0);
    if (form->value)
        put_arrays(a, type, 0, form->value, form->lacks, 0);
    else
        put_arrays(a, type, 0, text(a, "(unsigned)t * %du %% %du", factor, a->trips), lacks, 0);
    put(a, PART_SETUP, "for (int t = 0; t < %d; t++)\nm$[t] = t;\n", SIZE);
    put(a, PART_BODY, "s$[%s] += %s;\n", to, form->added ? form->added : lacks);
    return (operand){text(a, "%s", form->reads), true, true,
                     form->guard ? text(a, "%s", form->guard) : NULL};
}

operand made_valid(attack *a) {
    return is_first(a) && chance(a, 60) ? chain(a) : own(a);
}
