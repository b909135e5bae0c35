/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Expressions of variables in scope: positions, subscripts, values and conditions. Also updates. */
#include "fuzz/kernel.h"

#include <string.h>

const element_traits elements[ELEMENT_COUNT] = {
    [E_DOUBLE] = {"double", true, true},
    [E_FLOAT] = {"float", true, true},
    [E_LONG_DOUBLE] = {"long double", true, true},
    [E_COMPLEX] = {"double _Complex", true, true},
    [E_INT] = {"int", false, true},
    [E_UNSIGNED] = {"unsigned", false, false},
    [E_LONG] = {"long", false, true},
    [E_ULLONG] = {"unsigned long long", false, false},
    [E_SHORT] = {"short", false, true},
    [E_USHORT] = {"unsigned short", false, false},
    [E_SCHAR] = {"signed char", false, true},
    [E_UCHAR] = {"unsigned char", false, false},
};

/* ---- subscripts ------------------------------------------------------------------------------ */

const char *position(kernel *k) {
    const char *p = any_name(k, &k->scope.positions);
    switch (below(k, 8)) {
    case 0:
        return text(k, "%s + %d", p, 1 + below(k, 3));
    case 1:
        return text(k, "%s / 2", p);
    case 2:
        return k->scope.smalls.count ? text(k, "%s + %s", p, any_name(k, &k->scope.smalls)) : p;
    default:
        return p;
    }
}

static const char *masked(kernel *k, const char *expression, bool always) {
    if (!k->is_masked && !always)
        return expression;
    return below(k, 4) ? text(k, "(%s) & %d", expression, k->elements - 1)
                       : text(k, "(unsigned)(%s) %% %du", expression, (unsigned)k->elements);
}

static const char *load_subscript(kernel *k) {
    const array *a = &k->subscript[below(k, SUBSCRIPTS)];
    const char *at = position(k);
    if (a->shape != SHAPE_ROWS)
        return masked(k, text(k, "%s[%s]", a->base, at), false);
    if (k->scope.smalls.count && chance(k, 50))
        return masked(k, text(k, "%s[%s][%s]", a->base, at, any_name(k, &k->scope.smalls)), false);
    return masked(k, text(k, "%s[%s][%d]", a->base, at, below(k, 3)), false);
}

static const char *follow_chain(kernel *k) {
    const char *from =
        k->scope.subscripts.count ? any_name(k, &k->scope.subscripts) : load_subscript(k);
    return masked(k, text(k, "%s[%s]", k->chain.base, from), false);
}

const char *subscript(kernel *k) {
    const int which = below(k, 20);
    if (which < 8 && k->scope.subscripts.count)
        return any_name(k, &k->scope.subscripts);
    const char *loaded = load_subscript(k);
    if (which < 13)
        return loaded;
    if (which < 15)
        return follow_chain(k);
    if (which == 15)
        return masked(k, text(k, "%s + %s", loaded, any_name(k, &k->scope.positions)), true);
    if (which == 16)
        return text(k, "%d - (int)(%s)", k->elements - 1, loaded);
    if (which == 17) {
        const char *when = condition(k);
        return text(k, "(%s ? (int)(%s) : (int)(%s))", when, loaded, load_subscript(k));
    }
    if (which == 18)
        return text(k, "((%s) >> 1)", loaded);
    return text(k, "((int)(%s) ^ 1)", loaded);
}

/* ---- values ---------------------------------------------------------------------------------- */

static const char *load_value(kernel *k) {
    const array *a = chance(k, 65) ? &k->value : &k->other;
    const char *at = chance(k, 75) ? position(k) : subscript(k);
    const char *load = text(k, "%s[%s]", a->base, at);
    return k->is_damped ? text(k, "damp(%s)", load) : load;
}

static const char *leaf_value(kernel *k) {
    static const char *const constants[] = {"0.5", "2.0", "1.5", "-0.25", "3", "0.5f", "1.5f"};
    const int which = below(k, 10);
    if (which < 4 && k->scope.values.count)
        return any_name(k, &k->scope.values);
    if (which < 8)
        return load_value(k);
    if (which == 8)
        return constants[below(k, 7)];
    return text(k, "(%s & 15)", integer(k, 0));
}

/* Returns sums and products of at most three loads, which are exact for small integers. */
const char *value(kernel *k, int depth) {
    static const char *const sums[] = {"+", "-"};
    const char *left = leaf_value(k);
    if (depth == 0)
        return left;
    switch (below(k, 6)) {
    case 0:
    case 1:
        return text(k, "%s %s %s", left, sums[below(k, 2)], value(k, depth - 1));
    case 2:
        return text(k, "(%s) * %s", load_value(k), load_value(k));
    case 3:
        return text(k, "0.5 * (%s)", value(k, depth - 1));
    case 4: {
        const char *when = condition(k);
        return text(k, "(%s ? %s : %s)", when, left, leaf_value(k));
    }
    default:
        return text(k, "-(%s)", left);
    }
}

/* Returns an integer expression of at most 127 in magnitude, whatever memory holds. */
const char *integer(kernel *k, int depth) {
    const char *at = position(k);
    switch (below(k, depth ? 8 : 5)) {
    case 0:
    case 1:
        return text(k, "(%s[%s] & 63)", k->flag.base, at);
    case 2:
        return text(k, "%d", 1 + below(k, 9));
    case 3:
        return text(k, "((int)(%s) & 31)", any_name(k, &k->scope.positions));
    case 4:
        return k->scope.subscripts.count
                   ? text(k, "((int)%s & 15)", any_name(k, &k->scope.subscripts))
                   : "7";
    case 5:
        return text(k, "(%s ^ 5)", integer(k, 0));
    case 6:
        return text(k, "(%s - 3)", integer(k, 0));
    default: {
        const char *when = condition(k);
        const char *left = integer(k, 0);
        return text(k, "(%s ? %s : %s)", when, left, integer(k, 0));
    }
    }
}

const char *condition(kernel *k) {
    const char *p = any_name(k, &k->scope.positions);
    switch (below(k, 9)) {
    case 0:
    case 1:
        return text(k, "(%s[%s] & %d)", k->flag.base, p, 1 << below(k, 3));
    case 2:
        return text(k, "%s %% 3 == 0", p);
    case 3:
        return k->scope.subscripts.count
                   ? text(k, "%s < %d", any_name(k, &k->scope.subscripts), k->elements / 2)
                   : text(k, "%s[%s] > 2", k->flag.base, p);
    case 4:
        return text(k, "%s[%s] > 0", k->value.base, p);
    case 5:
        return text(k, "!(%s[%s] & 1)", k->flag.base, p);
    case 6:
        return text(k, "%s > 3 && %s[%s] != 2", p, k->flag.base, p);
    case 7:
        return k->scope.values.count ? text(k, "%s < 0.25", any_name(k, &k->scope.values))
                                     : text(k, "%s[%s] < 0.25", k->other.base, p);
    default:
        return text(k, "(%s[%s] == 1 || %s > 7)", k->flag.base, p, p);
    }
}

/* ---- updates --------------------------------------------------------------------------------- */

const char *place(kernel *k, const array *a, const char *index) {
    if (k->has_helpers && chance(k, 25))
        return place_by_accessor(k, a, index);
    switch (a->shape) {
    case SHAPE_ROWS:
        return k->scope.smalls.count && chance(k, 60)
                   ? text(k, "%s[%s][%s]", a->base, index, any_name(k, &k->scope.smalls))
                   : text(k, "%s[%s][%d]", a->base, index, below(k, 3));
    case SHAPE_RECORDS:
        return chance(k, 15) ? text(k, "(%s + (%s))->x", a->base, index)
                             : text(k, "%s[%s].%c", a->base, index, chance(k, 50) ? 'x' : 'y');
    default:
        return chance(k, 10) ? text(k, "(*(%s + (%s)))", a->base, index)
                             : text(k, "%s[%s]", a->base, index);
    }
}

const char *contribution(kernel *k, const array *a) {
    const element_traits *of = &elements[a->type];
    if (*a->operation == '*') {
        const char *when = condition(k);
        return of->is_floating ? text(k, "(%s ? 0.75 : 1.25)", when)
                               : text(k, "(%s | 1)", integer(k, 1));
    }
    return of->is_floating ? value(k, 2) : integer(k, 1);
}

/* Returns if (h < e) h = e, in one of its spellings. */
static const char *extremum(kernel *k, const char *where, const char *e, const char *op) {
    switch (below(k, 4)) {
    case 0:
        return text(k, "if (%s %s %s) %s = %s", where, op, e, where, e);
    case 1:
        return text(k, "%s = %s %s %s ? %s : %s", where, where, op, e, e, where);
    case 2:
        return text(k, "if (%s %s %s) { %s = %s; }", e, *op == '<' ? ">" : "<", where, where, e);
    default:
        return text(k, "%s = %s %s %s ? %s : %s", where, e, *op == '<' ? ">" : "<", where, e,
                    where);
    }
}

const char *update(kernel *k, const array *a, const char *where) {
    const char *op = a->operation;
    const char *e = contribution(k, a);
    if (*op == '<' || *op == '>')
        return extremum(k, where, text(k, "(%s)(%s)", elements[a->type].spelling, e), op);
    const int which = below(k, 16);
    const bool is_steppable = *op == '+' && a->type != E_COMPLEX; /* clang 19 may crash on z++ */
    if (is_steppable && which == 0)
        return text(k, below(k, 2) ? "%s++" : "++%s", where);
    if (is_steppable && which == 1)
        return text(k, "%s--", where);
    if (*op == '+' && which < 5)
        return text(k, "%s -= %s", where, e);
    if (*op == '+' && which == 5)
        return text(k, "%s = %s - (%s)", where, where, e);
    if (which == 6)
        return text(k, "%s = %s %s (%s)", where, where, op, e);
    if (which == 7)
        return text(k, "%s = (%s) %s %s", where, e, op, where);
    if (*op == '+' && which == 8)
        return text(k, "ADD(%s, %s)", where, e);
    if (which == 9)
        return text(k, "(%s) %s= (%s)", where, op, e);
    return text(k, "%s %s= %s", where, op, e);
}
