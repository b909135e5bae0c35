/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reads of `x`, which may overlap with `h`, at subscripts that are not affine in all iterations:
 * differences and products that wrap around where the program does not read, narrow types, and
 * conditions on the first and last iterations. */
#include "fuzz/attacks/attack.h"

typedef struct place {
    const char *index;
    const char *guard; /* NULL if the index is always in 0 ... limit - 1 */
} place;

/* t - c or c - t, in the counter's type or another one, where c is a constant or a parameter. */
static place difference(attack *a) {
    static const char *const types[] = {"unsigned", "int", "size_t", "long"};
    const int c = 1 + below(a, chance(a, 50) ? 3 : a->trips - 2);
    const char *by = text(a, "%d", c);
    if (chance(a, 40)) {
        put(a, PART_PARAMETERS, ", %s u$", one_of(a, 4, types));
        put(a, PART_ARGUMENTS, ", %d", c);
        by = "u$";
    }
    const char *by_text = text(a, "%s", by);
    if (chance(a, 25))
        return (place){text(a, "%s - t", by_text), text(a, "t <= %d", c)};
    if (chance(a, 25))
        return (place){text(a, "(%s)t - %s", one_of(a, 4, types), by_text), text(a, "t >= %d", c)};
    if (chance(a, 25))
        return (place){text(a, "t * 2 - %s", by_text), text(a, "t >= %d", (c + 1) / 2)};
    return (place){text(a, "t - %s", by_text),
                   c == 1 && chance(a, 60) ? "t > 0" : text(a, "t >= %d", c)};
}

/* A 32-bit product that wraps around. The element is only read where the product is less than the
 * limit. */
static place wrapping_product(attack *a) {
    static const char *const factors[] = {"0x80000001u", "0xc0000001u", "0x40000002u",
                                          "0xffffffffu", "0x10001u",    "3u",
                                          "0x20000001u", "0x90000000u"};
    const char *index =
        text(a, "(unsigned)t * %s + %du", one_of(a, 8, factors), below(a, a->trips));
    return (place){index, text(a, "%s < %du", index, (unsigned)a->limit)};
}

/* A signed product that would overflow in some iterations. It is computed only where it does not,
 * and where the element is below the limit. A step is about 300 elements, and an int holds at least
 * five steps. */
static place overflowing_product(attack *a) {
    const int stride = 300000000 + below(a, 90000000);
    const int first = chance(a, 50) ? 0 : below(a, a->trips - 2);
    const long long inside = (((long long)a->limit << 20) - 1) / stride + 1;
    const int steps = inside < 4 ? (int)inside : 4;
    const char *index = text(a, "((int)t - %d) * %d / %d", first, stride, 1 << 20);
    return (place){index, text(a, "t >= %d && t < %d", first, first + steps)};
}

/* The memory is large enough for the few products that are computed. */
static place large_stride(attack *a) {
    const int first = below(a, 3) ? 0 : below(a, a->trips - 3);
    const int most = a->limit / 3;
    const char *index = text(a, "((int)t - %d) * %d", first, most);
    return (place){index, text(a, "t >= %d && t < %d", first, first + 3)};
}

static place narrow_variable(attack *a) {
    const int c = below(a, 300);
    switch (below(a, 4)) {
    case 0:
        put(a, PART_BODY, "unsigned char j$ = (unsigned char)(t + %d);\n", c);
        return (place){text(a, "j$"), NULL};
    case 1:
        put(a, PART_BODY, "signed char j$ = (signed char)(t - %d);\n", c);
        return (place){text(a, "j$"), text(a, "j$ >= 0")};
    case 2:
        put(a, PART_BODY, "unsigned short j$ = (unsigned short)(t * %d - %d);\n", 1 + below(a, 90),
            c);
        return (place){text(a, "j$"), text(a, "j$ < %d", a->limit)};
    default:
        return (place){text(a, "(unsigned char)(t * %d + %d)", 1 + below(a, 3), c), NULL};
    }
}

static place no_line(attack *a) {
    const int m = 2 + below(a, a->trips - 2);
    static const char *const forms[] = {"t / 2", "t >> 1", "t ^ 1", "t | 1", "n - 1 - t"};
    switch (below(a, 7)) {
    case 0:
        return (place){text(a, "t %% %d", m), NULL};
    case 1:
        return (place){text(a, "t & %d", m), NULL};
    case 2:
        return (place){text(a, "(t + %d) %% n", m), NULL};
    case 3:
        return (place){text(a, "t == 0 ? n - 1 : t - 1"), NULL};
    case 4:
        return (place){text(a, "t < %d ? t + n - %d : t - %d", m, m, m), NULL};
    case 5:
        put(a, PART_BODY, "int j$ = (int)t;\nif (w[t] > 0.25)\nj$ = (int)t / 2;\n");
        return (place){text(a, "j$"), NULL};
    default:
        return (place){one_of(a, 5, forms), NULL};
    }
}

static place any_place(attack *a) {
    switch (below(a, 12)) {
    case 0:
    case 1:
    case 2:
    case 3:
        return difference(a);
    case 4:
    case 5:
        return wrapping_product(a);
    case 6:
        return overflowing_product(a);
    case 7:
        return large_stride(a);
    case 8:
    case 9:
        return narrow_variable(a);
    default:
        return no_line(a);
    }
}

/* The element at the index: directly, through a pointer, by a function, or in a loop. */
static const char *element_at(attack *a, const char *index) {
    switch (below(a, 8)) {
    case 0:
        return text(a, "*(x + (%s))", index);
    case 1:
        put(a, PART_GLOBALS, "static %s get$(const %s *a, long i) {\nreturn a[i];\n}\n", a->element,
            a->element);
        return text(a, "get$(x, (long)(%s))", index);
    case 2:
        put(a, PART_GLOBALS,
            "static %s get$(const %s *a, int i) {\nconst %s *p = a + i;\nreturn *p;\n}\n",
            a->element, a->element, a->element);
        return text(a, "get$(x, (int)(%s))", index);
    default:
        return text(a, "x[%s]", index);
    }
}

/* The difference is computed in the reading function, so its wrap is not visible in the loop. */
static operand read_by_function(attack *a) {
    const int c = 1 + below(a, 40);
    note(a, "extents/function");
    put(a, PART_GLOBALS,
        "static %s before$(const %s *a, unsigned t) {\nif (t < %du)\nreturn 0;\nreturn a[t - "
        "%du];\n}\n",
        a->element, a->element, (unsigned)c, (unsigned)c);
    return (operand){text(a, "before$(x, (unsigned)t)"), !a->is_floating, false, NULL};
}

static operand neighbours(attack *a) {
    note(a, "extents/inner-loop");
    put(a, PART_BODY, "%s v$ = 0;\nfor (%s j$ = t; j$ + %d > t && j$ < n; j$--)\nv$ %s x[j$];\n",
        a->element, a->counter_type, 1 + below(a, 3), a->is_floating ? "+= 0.25 *" : "^=");
    return (operand){text(a, "v$"), !a->is_floating, false, NULL};
}

operand wrapped_extents(attack *a) {
    if (chance(a, 8))
        return read_by_function(a);
    if (chance(a, 5))
        return neighbours(a);
    const place p = any_place(a);
    const char *element = element_at(a, p.index);
    note(a, p.guard ? "extents/guarded" : "extents/plain");
    if (!p.guard)
        return (operand){element, !a->is_floating, false, NULL};
    switch (below(a, 5)) {
    case 0:
        put(a, PART_BODY, "%s v$ = 1;\nif (%s)\nv$ = %s;\n", a->element, p.guard, element);
        return (operand){text(a, "v$"), !a->is_floating, false, NULL};
    case 1:
        return (operand){text(a, "((%s) ? %s : 1)", p.guard, element), !a->is_floating, false,
                         NULL};
    case 2:
        put(a, PART_BODY, "if (!(%s))\ncontinue;\n", p.guard);
        return (operand){element, !a->is_floating, false, NULL};
    case 3:
        put(a, PART_BODY, "%s v$;\nif (%s) {\nv$ = %s;\n} else {\nv$ = 2;\n}\n", a->element,
            p.guard, element);
        return (operand){text(a, "v$"), !a->is_floating, false, NULL};
    default:
        return (operand){element, !a->is_floating, false, text(a, "(%s)", p.guard)};
    }
}
