/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The memory of a program: its arrays, how the kernel accesses them, and their values. */
#include "fuzz/kernel.h"

#include <string.h>

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

enum { ARRAYS = REDUCTIONS + SUBSCRIPTS + 6 };

static array *array_of(kernel *k, int i) {
    array *const others[] = {&k->value, &k->other, &k->flag, &k->chain, &k->first, &k->far};
    if (i < REDUCTIONS)
        return &k->reduction[i];
    i -= REDUCTIONS;
    return i < SUBSCRIPTS ? &k->subscript[i] : others[i - SUBSCRIPTS];
}

/* ---- types and places ------------------------------------------------------------------------ */

static storage any_storage(kernel *k) {
    static const storage own[] = {STORAGE_LOCAL, STORAGE_STATIC_LOCAL, STORAGE_VARIABLE_LENGTH};
    if (k->is_wide && k->size <= 2048 && chance(k, 15))
        return own[below(k, LENGTH(own))];
    static const storage choices[] = {STORAGE_PARAMETER, STORAGE_PARAMETER,     STORAGE_PARAMETER,
                                      STORAGE_GLOBAL,    STORAGE_GLOBAL,        STORAGE_GLOBAL,
                                      STORAGE_RESTRICT,  STORAGE_CONTEXT,       STORAGE_VALUE,
                                      STORAGE_POINTER,   STORAGE_GLOBAL_POINTER};
    return choices[below(k, LENGTH(choices))];
}

static void name_array(kernel *k, array *a, const char *name) {
    const unsigned long long seed = (unsigned long long)k->seed;
    a->storage = any_storage(k);
    if (a->storage >= STORAGE_LOCAL && a->type == E_COMPLEX)
        a->storage = STORAGE_PARAMETER; /* clang 19 may crash on z[k]++ of such arrays */
    a->is_member = k->is_wide && chance(k, 25);
    a->object = a->given =
        a->is_member ? text(k, "all_%llu.%s", seed, name) : text(k, "%s_%llu", name, seed);
    a->record = text(k, "struct record_%s_%llu", name, seed);
    switch (a->storage) {
    case STORAGE_GLOBAL:
        a->base = a->object;
        break;
    case STORAGE_LOCAL:
        a->base = k->has_drains ? text(k, "record_%s.own", name) : text(k, "%s", name);
        break;
    case STORAGE_GLOBAL_POINTER:
        a->base = text(k, "%s_at_%llu", name, seed);
        break;
    case STORAGE_CONTEXT:
        a->base = text(k, "c->%s", name);
        break;
    case STORAGE_VALUE:
        a->base = text(k, "v.%s", name);
        break;
    default:
        a->base = text(k, "%s", name);
        break;
    }
}

static void make_reduction(kernel *k, array *a, const char *name) {
    static const element types[] = {E_DOUBLE,      E_DOUBLE,   E_DOUBLE,   E_DOUBLE, E_FLOAT,
                                    E_LONG_DOUBLE, E_INT,      E_INT,      E_INT,    E_INT,
                                    E_INT,         E_UNSIGNED, E_UNSIGNED, E_LONG,   E_ULLONG,
                                    E_SHORT,       E_USHORT,   E_SCHAR,    E_UCHAR,  E_COMPLEX};
    static const char *const integer_operations[] = {"+", "+", "+", "+", "+", "+", "+", "+", "+",
                                                     "+", "+", "+", "&", "|", "^", "<", ">"};
    a->type = types[below(k, LENGTH(types))];
    a->shape = below(k, 10) < 6 ? SHAPE_FLAT : below(k, 2) ? SHAPE_ROWS : SHAPE_RECORDS;
    if (k->has_parts && a->shape == SHAPE_FLAT && chance(k, 70))
        a->shape = SHAPE_ROWS;
    a->operation = "+";
    if (!elements[a->type].is_floating)
        a->operation = integer_operations[below(k, LENGTH(integer_operations))];
    else if (a->type != E_COMPLEX && chance(k, 18))
        a->operation = chance(k, 60) ? "*" : chance(k, 50) ? "<" : ">";
    if (!elements[a->type].is_signed && chance(k, 10))
        a->operation = "*";
    name_array(k, a, name);
}

static void make_subscript(kernel *k, array *a, const char *name, shape of) {
    static const element types[] = {E_INT,      E_INT,  E_INT,   E_INT,   E_INT,   E_INT,
                                    E_UNSIGNED, E_LONG, E_SHORT, E_UCHAR, E_ULLONG};
    a->type = types[below(k, LENGTH(types))];
    a->shape = of;
    name_array(k, a, name);
}

static void make_input(kernel *k, array *a, const char *name, element type) {
    a->type = type;
    a->shape = SHAPE_FLAT;
    name_array(k, a, name);
}

static bool is_pointed_to(const array *a) {
    return a->storage == STORAGE_PARAMETER || a->storage == STORAGE_CONTEXT ||
           a->storage == STORAGE_VALUE || a->storage == STORAGE_GLOBAL_POINTER;
}

/* An array accessed through a pointer may be, or overlap with, another array of the same type. */
static void let_overlap(kernel *k) {
    for (int i = 0; i < ARRAYS + k->is_wide; i++) {
        array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        const array *b = array_of(k, below(k, ARRAYS));
        const bool is_pointer = is_pointed_to(a) && b->storage != STORAGE_RESTRICT;
        /* arrays of bounds, and of values out of range, must keep their initial values */
        const bool is_kept =
            a == &k->chain || a == &k->first || a == &k->far || b == &k->first || b == &k->far;
        if (!is_pointer || is_kept || a == b || a->type != b->type || a->shape != b->shape ||
            a->shape == SHAPE_RECORDS)
            continue;
        a->given = chance(k, 50) ? b->object : text(k, "%s + %d", b->object, below(k, 40));
    }
}

void make_world(kernel *k) {
    k->elements = chance(k, 70) ? 256 : 64;
    k->trips = chance(k, 12) ? 4096 + below(k, 900) : 1 + below(k, 400);
    k->size = k->trips > 400 ? 16384 : 2048;
    if (chance(k, 3))
        k->trips = below(k, 2);
    make_reduction(k, &k->reduction[0], "h");
    make_reduction(k, &k->reduction[1], "g");
    make_subscript(k, &k->subscript[0], "s", SHAPE_FLAT);
    make_subscript(k, &k->subscript[1], "e", chance(k, 60) ? SHAPE_ROWS : SHAPE_FLAT);
    make_input(k, &k->value, "w", chance(k, 70) ? E_DOUBLE : E_FLOAT);
    make_input(k, &k->other, "x", E_DOUBLE);
    make_input(k, &k->flag, "z", E_INT);
    make_input(k, &k->chain, "next", E_INT);
    make_input(k, &k->first, "first", E_INT);
    make_input(k, &k->far, "far", E_INT);
    make_input(k, &k->out, "out", E_DOUBLE);
    if (k->is_masked)
        let_overlap(k);
}

/* ---- declarations ---------------------------------------------------------------------------- */

/* Returns the declaration of `name` as a pointer to the array's elements, rows or records. */
static const char *pointer_to(kernel *k, const array *a, const char *name) {
    const char *type = a->shape == SHAPE_RECORDS ? a->record : elements[a->type].spelling;
    const char *constant = a->operation || a == &k->out || k->is_masked ? "" : "const ";
    return a->shape == SHAPE_ROWS ? text(k, "%s%s (*%s)[3]", constant, type, name)
                                  : text(k, "%s%s *%s", constant, type, name);
}

static const char *type_of(const array *a) {
    return a->shape == SHAPE_RECORDS ? a->record : elements[a->type].spelling;
}

/* Declares an array that is copied from the object when the kernel begins, and back when it
 * ends. */
static void put_own_array(kernel *k, const array *a) {
    const char *rows = a->shape == SHAPE_ROWS ? "[3]" : "";
    const char *length = text(k, "%d", k->size);
    if (a->storage == STORAGE_VARIABLE_LENGTH) {
        length = text(k, "%s_length", a->base);
        put(k, &k->pointers, "    const int %s = %d + (n < 0);\n", length, k->size);
    }
    const char *dot = strchr(a->base, '.');
    if (dot)
        put(k, &k->pointers,
            "    struct {\n        char before;\n        %s own[%s]%s;\n    } %.*s;\n", type_of(a),
            length, rows, (int)(dot - a->base), a->base);
    else
        put(k, &k->pointers, "    %s%s %s[%s]%s;\n",
            a->storage == STORAGE_STATIC_LOCAL ? "static " : "", type_of(a), a->base, length, rows);
    put(k, &k->pointers, "    memcpy(%s, %s, sizeof %s);\n", a->base, a->object, a->object);
    put(k, &k->after, "    memcpy(%s, %s, sizeof %s);\n", a->object, a->base, a->object);
}

static void put_object(kernel *k, buffer *b, const array *a) {
    const char *rows = a->shape == SHAPE_ROWS ? "[3]" : "";
    if (!a->is_member)
        put(k, b, "static %s %s[%d]%s;\n", type_of(a), a->object, k->size, rows);
    if (a->storage == STORAGE_LOCAL || a->storage == STORAGE_STATIC_LOCAL ||
        a->storage == STORAGE_VARIABLE_LENGTH)
        put_own_array(k, a);
    if (a->storage == STORAGE_GLOBAL_POINTER)
        put(k, b, "static %s;\n", pointer_to(k, a, a->base));
    if (a->storage == STORAGE_POINTER)
        put(k, &k->pointers, "    %s = %s;\n", pointer_to(k, a, a->base), a->object);
}

static const char *member_name(const array *a) {
    const char *dot = strpbrk(a->base, ".>");
    return dot ? dot + 1 : a->base;
}

static void put_struct(kernel *k, buffer *b, const char *name, storage of) {
    put(k, b, "struct %s_%llu {\n    int n;\n", name, (unsigned long long)k->seed);
    for (int i = 0; i <= ARRAYS; i++) {
        const array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        if (a->storage == of)
            put(k, b, "    %s;\n", pointer_to(k, a, member_name(a)));
    }
    put(k, b, "};\n");
}

/* Declares one object that contains several arrays, one after the other. */
static void put_members_of_all(kernel *k, buffer *b) {
    put(k, b, "static struct {\n    int none;\n");
    for (int i = 0; i <= ARRAYS; i++) {
        const array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        if (a->is_member)
            put(k, b, "    %s %s[%d]%s;\n", type_of(a), strrchr(a->object, '.') + 1, k->size,
                a->shape == SHAPE_ROWS ? "[3]" : "");
    }
    put(k, b, "} all_%llu;\n", (unsigned long long)k->seed);
}

void put_objects(kernel *k, buffer *b) {
    for (int i = 0; i < REDUCTIONS; i++)
        if (k->reduction[i].shape == SHAPE_RECORDS)
            put(k, b, "%s {\n    %s x, y;\n    int tag, other;\n};\n", k->reduction[i].record,
                elements[k->reduction[i].type].spelling);
    if (k->is_wide)
        put_members_of_all(k, b);
    for (int i = 0; i < ARRAYS; i++)
        put_object(k, b, array_of(k, i));
    put_object(k, b, &k->out);
    put(k, b, "struct pair_%llu {\n    int place;\n    double weight;\n};\n",
        (unsigned long long)k->seed);
    put_struct(k, b, "context", STORAGE_CONTEXT);
    put_struct(k, b, "view", STORAGE_VALUE);
    put(k, b, "static double live_%llu[8];\n", (unsigned long long)k->seed);
}

const char *parameters(kernel *k) {
    const unsigned long long seed = (unsigned long long)k->seed;
    const char *list = text(k, "(%s n, struct context_%llu *c, struct view_%llu v, double *live",
                            k->trip_type, seed, seed);
    for (int i = 0; i <= ARRAYS; i++) {
        const array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        const char *name =
            a->storage == STORAGE_RESTRICT ? text(k, "restrict %s", a->base) : a->base;
        if (a->storage == STORAGE_PARAMETER || a->storage == STORAGE_RESTRICT)
            list = text(k, "%s, %s", list, pointer_to(k, a, name));
    }
    return text(k, "%s)", list);
}

const char *arguments(kernel *k) {
    const char *list = text(k, "(%d, &c, v, live_%llu", k->trips, (unsigned long long)k->seed);
    for (int i = 0; i <= ARRAYS; i++) {
        const array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        if (a->storage == STORAGE_PARAMETER || a->storage == STORAGE_RESTRICT)
            list = text(k, "%s, %s", list, a->given);
    }
    return text(k, "%s)", list);
}

/* ---- initial values -------------------------------------------------------------------------- */

static void fill(kernel *k, buffer *b, const array *a, int limit) {
    static const char *const types[ELEMENT_COUNT] = {
        [E_DOUBLE] = "DOUBLE",   [E_FLOAT] = "FLOAT",  [E_LONG_DOUBLE] = "LONG_DOUBLE",
        [E_COMPLEX] = "COMPLEX", [E_INT] = "INT32",    [E_UNSIGNED] = "INT32",
        [E_LONG] = "INT64",      [E_ULLONG] = "INT64", [E_SHORT] = "INT16",
        [E_USHORT] = "INT16",    [E_SCHAR] = "INT8",   [E_UCHAR] = "INT8"};
    const char *type = types[a->type];
    const char *o = a->object;
    if (a->shape != SHAPE_RECORDS) {
        const char *first = a->shape == SHAPE_ROWS ? "[0][0]" : "[0]";
        put(k, b, "    fuzz_fill(%s, %d, sizeof %s%s, FUZZ_%s, %d);\n", o,
            k->size * (a->shape == SHAPE_ROWS ? 3 : 1), o, first, type, limit);
        return;
    }
    put(k, b, "    fuzz_fill(&%s->x, %d, sizeof *%s, FUZZ_%s, %d);\n", o, k->size, o, type, limit);
    put(k, b, "    fuzz_fill(&%s->y, %d, sizeof *%s, FUZZ_%s, %d);\n", o, k->size, o, type, limit);
    put(k, b, "    fuzz_fill(&%s->tag, %d, sizeof *%s, FUZZ_INT32, 64);\n", o, k->size, o);
}

static void put_fills(kernel *k, buffer *b) {
    for (int i = 0; i < REDUCTIONS; i++)
        fill(k, b, &k->reduction[i], 64);
    for (int i = 0; i < SUBSCRIPTS; i++)
        fill(k, b, &k->subscript[i], k->elements);
    fill(k, b, &k->value, 1);
    fill(k, b, &k->other, 1);
    fill(k, b, &k->flag, 16);
    put(k, b, "    fuzz_fill_chain(%s, %d, %d);\n", k->chain.object, k->size, k->elements);
    put(k, b, "    fuzz_fill_first(%s, %d, %d);\n", k->first.object, k->size,
        k->trips < 400 ? 7 : 3);
    put(k, b, "    fuzz_fill_far(%s, %d, %d);\n", k->far.object, k->size, k->elements);
}

static void put_members(kernel *k, buffer *b, const char *variable, storage of) {
    for (int i = 0; i <= ARRAYS; i++) {
        const array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        if (a->storage == of)
            put(k, b, "    %s.%s = %s;\n", variable, member_name(a), a->given);
    }
}

/* Do updates in another order give the array other bits, even for small integers? */
static bool is_inexact(const array *a) {
    return elements[a->type].is_floating &&
           (a->type == E_FLOAT || *a->operation != '+' || a->is_no_integer);
}

static bool lies_in(const array *a, const char *object) {
    const size_t length = strlen(object);
    const bool is_given = strncmp(a->given, object, length) == 0 &&
                          (a->given[length] == 0 || a->given[length] == ' ');
    return is_given || strcmp(a->object, object) == 0;
}

/* Do the values from which all updates are computed depend on the order of updates? */
static bool shows_order_in_values(const kernel *k) {
    for (int i = 0; i < REDUCTIONS; i++) {
        const array *a = &k->reduction[i];
        if (is_inexact(a) && (lies_in(a, k->value.object) || lies_in(a, k->other.object)))
            return true;
    }
    return false;
}

/* Does the object depend on the order of updates, under whatever name it is updated? */
static bool shows_order(const kernel *k, const char *object) {
    for (int i = 0; i < REDUCTIONS; i++) {
        const array *a = &k->reduction[i];
        /* What is stored in `out` may come from any reduction array. */
        if (is_inexact(a) && (lies_in(a, object) || strcmp(k->out.object, object) == 0))
            return true;
    }
    return shows_order_in_values(k);
}

static void put_hashes(kernel *k, buffer *b) {
    for (int i = 0; i <= ARRAYS; i++) {
        const array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        const bool is_ordered = shows_order(k, a->object);
        put(k, b, "        fuzz_print%s(\"%s\", %s, sizeof %s);\n", is_ordered ? "_ordered" : "",
            a->object, a->object, a->object);
    }
    put(k, b, "        fuzz_print%s(\"live_%llu\", live_%llu, sizeof live_%llu);\n",
        shows_order_in_values(k) ? "_ordered" : "", (unsigned long long)k->seed,
        (unsigned long long)k->seed, (unsigned long long)k->seed);
}

/* Between calls subscripts change in some places, everywhere or not at all, so that plans are
 * reused or made again. */
void put_runner(kernel *k, buffer *b) {
    const unsigned long long seed = (unsigned long long)k->seed;
    put(k, b, "static void run_%llu(void) {\n", seed);
    put(k, b, "    __typeof__(&kernel_%llu) volatile call = kernel_%llu;\n", seed, seed);
    put(k, b, "    struct context_%llu c = {%d};\n    struct view_%llu v = {%d};\n", seed, k->trips,
        seed, k->trips);
    put(k, b, "    fuzz_seed(%llu);\n", seed);
    put_fills(k, b);
    put_members(k, b, "c", STORAGE_CONTEXT);
    put_members(k, b, "v", STORAGE_VALUE);
    for (int i = 0; i <= ARRAYS; i++) {
        const array *a = i < ARRAYS ? array_of(k, i) : &k->out;
        if (a->storage == STORAGE_GLOBAL_POINTER)
            put(k, b, "    %s = %s;\n", a->base, a->given);
    }
    put(k, b, "    for (int round = 0; round < %d; round++) {\n", 2 + below(k, 3));
    put(k, b,
        k->has_held ? "        fuzz_hold(1);\n        call%s;\n        fuzz_hold(0);\n"
                    : "        call%s;\n",
        arguments(k));
    put_hashes(k, b);
    if (chance(k, 60) && k->subscript[0].shape == SHAPE_FLAT)
        put(k, b, "        %s[fuzz_below(%d)] = fuzz_below(%d);\n", k->subscript[0].object,
            k->trips + 1, k->elements);
    if (chance(k, 30))
        put(k, b, "        fuzz_fill(%s, %d, sizeof(int), FUZZ_INT32, 16);\n", k->flag.object,
            k->size);
    if (chance(k, 20))
        put(k, b, "        %s[fuzz_below(%d)] = 0;\n", k->chain.object, k->elements);
    put(k, b, "    }\n}\n\n");
}
