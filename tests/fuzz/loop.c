/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The loop around the statements, and the program around the loop. */
#include "fuzz/kernel.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

/* ---- text ------------------------------------------------------------------------------------ */

static char *formatted(arena *memory, const char *format, va_list values) {
    va_list again;
    va_copy(again, values);
    const int length = vsnprintf(NULL, 0, format, values);
    char *result = arena_allocate(memory, (size_t)length + 1);
    vsnprintf(result, (size_t)length + 1, format, again);
    va_end(again);
    return result;
}

const char *text(kernel *k, const char *format, ...) {
    va_list values;
    va_start(values, format);
    const char *result = formatted(k->memory, format, values);
    va_end(values);
    return result;
}

void put(kernel *k, buffer *b, const char *format, ...) {
    va_list values;
    va_start(values, format);
    buffer_text(b, formatted(k->memory, format, values));
    va_end(values);
}

const char *new_name(kernel *k, const char *stem) {
    return strlen(stem) == 1 ? text(k, "%s%d", stem, k->names++)
                             : text(k, "%s_%llu_%d", stem, (unsigned long long)k->seed, k->names++);
}

bool chance(kernel *k, int percent) {
    return random_chance(&k->random, percent);
}

int below(kernel *k, int n) {
    return random_below(&k->random, n);
}

void add_name(names *list, const char *name) {
    if (list->count < MOST_NAMES)
        list->name[list->count++] = name;
}

const char *any_name(kernel *k, const names *list) {
    return list->name[below(k, list->count)];
}

size_t begin_statement(kernel *k) {
    return k->body.length;
}

void end_statement(kernel *k, size_t begin) {
    const int number = k->statements++;
    if (!k->without || number >= k->without_count || !k->without[number])
        return;
    k->body.length = begin;
    k->body.data[begin] = 0;
}

/* ---- the loop -------------------------------------------------------------------------------- */

typedef struct header {
    const char *type;   /* type of the counter */
    const char *format; /* %1$s: the counter; %2$s: the counter, with its type where it is declared;
                           %3$s: the bound */
    bool is_plain;
    int most_trips;   /* maximum trip count, or 0 without a limit */
    bool is_declared; /* the counter is declared only in the header */
} header;

/* The last ones run downwards, step by more than one, or wrap around if misread. */
static const header headers[] = {
    {"int", "for (%2$s = 0; %1$s < %3$s; %1$s++) ", true, 0, false},
    {"int", "for (%2$s = 0; %1$s < %3$s; %1$s++) ", true, 0, false},
    {"int", "for (%2$s = 0; %1$s < %3$s; ++%1$s) ", true, 0, false},
    {"long", "for (%2$s = 0; %1$s < %3$s; %1$s++) ", true, 0, false},
    {"size_t", "for (%2$s = 0; %1$s < (size_t)%3$s; %1$s++) ", true, 0, false},
    {"unsigned", "for (%2$s = 0; %1$s < (unsigned)%3$s; %1$s++) ", true, 0, false},
    {"int", "for (%2$s = 0; %1$s <= %3$s - 1; %1$s++) ", true, 0, false},
    {"int", "for (%2$s = 0; %1$s != %3$s; %1$s++) ", false, 0, false},
    {"int", "for (%2$s = %3$s - 1; %1$s >= 0; %1$s--) ", false, 0, false},
    {"long", "for (%2$s = %3$s; %1$s > 0; --%1$s) ", false, 0, false},
    {"int", "for (%2$s = 1; %1$s < %3$s; %1$s += 2) ", true, 0, false},
    {"int", "for (%2$s = 2; %1$s < %3$s; %1$s += 3) ", true, 0, false},
    {"int", "for (%2$s = 5; %3$s > %1$s; %1$s = %1$s + 1) ", true, 0, false},
    {"unsigned", "for (%2$s = (unsigned)%3$s; %1$s-- > 0;) ", false, 0, false},
    {"unsigned char", "for (%2$s = 0; %1$s < %3$s; %1$s++) ", true, 255, false},
    {"short", "for (%2$s = 0; %1$s < %3$s; %1$s++) ", true, 0, false},
    {"unsigned short", "for (%2$s = 250; %1$s != (unsigned short)(%3$s + 250); %1$s++) ", false, 0,
     false},
    {"unsigned char", "for (%2$s = 250; %1$s != (unsigned char)%3$s; %1$s++) ", false, 249, false},
};

/* Only in programs with even seeds. */
static const header wide_headers[] = {
    {"int", "for (%2$s = %3$s * 2; %1$s > 0; %1$s -= 2) ", false, 0, false},
    {"long long", "for (%2$s = %3$s; %1$s-- != 0;) ", false, 0, false},
    {"signed char", "for (%2$s = 0; %1$s < %3$s; ++%1$s) ", true, 127, false},
    {"int", "EACH(%2$s, %1$s, %3$s) ", true, 0, false},
    {"int", "for (%2$s = %3$s; --%1$s >= 0;) ", false, 0, false},
    {"long", "for (%2$s = %3$s; %1$s--;) ", false, 0, false},
    {"int", "for (%2$s = -1; ++%1$s < %3$s;) ", false, 0, false},
    {"size_t", "for (%2$s = (size_t)%3$s; %1$s-- != 0;) ", false, 0, false},
    {"int", "for (%2$s = 0, end = %3$s - 1; %1$s <= end; %1$s++) ", false, 0, true},
    {"int", "for (%2$s = %3$s - 1, end = 0; %1$s >= end; %1$s--) ", false, 0, true},
};

/* Only in programs with seed % 17 == 0: the counter plus a constant is compared. */
static const header headers_ahead[] = {
    {"int", "for (%2$s = 0; %1$s + 1 < %3$s; %1$s++) ", false, 0, false},
    {"int", "for (%2$s = 2; %3$s >= %1$s + 3; ++%1$s) ", false, 0, false},
    {"size_t", "for (%2$s = 0; %1$s + 2 < (size_t)%3$s; %1$s++) ", false, 0, false},
    {"unsigned", "for (%2$s = 3; 5 + %1$s < (unsigned)%3$s; %1$s += 1) ", false, 0, false},
    {"long", "for (%2$s = 0; %1$s + 4L <= %3$s; %1$s++) ", false, 0, false},
    {"short", "for (%2$s = 0; %1$s + 1 < %3$s; %1$s++) ", false, 0, false},
};

static const header *any_header(kernel *k) {
    if (k->has_drains && chance(k, 30))
        return &headers_ahead[below(k, LENGTH(headers_ahead))];
    if (k->is_wide && chance(k, 20))
        return &wide_headers[below(k, LENGTH(wide_headers))];
    return &headers[chance(k, 50) ? 0 : below(k, LENGTH(headers))];
}

/* Returns the counter's initialiser, which it needs if statements before the loop may jump past its
 * first value, or if statements are left out. */
static const char *first_value(const kernel *k) {
    return k->without || k->body.length > 0 ? " = 0" : "";
}

static void put_header(kernel *k, const char *counter, buffer *b) {
    const header *h = any_header(k);
    if (h->most_trips && k->trips > h->most_trips)
        h = &headers[0];
    k->has_outer_counter = chance(k, 30) && !h->is_declared;
    k->has_plain_header = h->is_plain;
    k->counter_type = h->type;
    k->may_continue = true;
    if (k->has_outer_counter)
        put(k, &k->locals, "    %s %s%s;\n", h->type, counter, first_value(k));
    const char *declared = k->has_outer_counter ? counter : text(k, "%s %s", h->type, counter);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    put(k, b, h->format, counter, declared, k->trip);
#pragma GCC diagnostic pop
    if (k->has_outer_counter && chance(k, 40))
        put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, counter);
}

/* A loop with two counters. */
static void put_pair(kernel *k, const char *counter, buffer *b) {
    const char *also = new_name(k, "a");
    k->has_plain_header = k->may_continue = k->has_outer_counter = true;
    k->counter_type = "int";
    put(k, &k->locals, "    int %s, %s;\n", counter, also);
    put(k, b, "for (%s = 0, %s = 5; %s < %s; %s++, %s += 2) ", counter, also, counter, k->trip,
        counter, also);
    add_name(&k->scope.positions, counter);
    add_name(&k->scope.positions, also);
}

/* The header sets the bound. The counter's address may be known outside, but the loop does not use
 * it. */
static void put_bound(kernel *k, const char *counter, buffer *b) {
    const char *end = new_name(k, "a");
    const bool is_known = chance(k, 50);
    // A body that steps upwards would prevent a downward loop from ending.
    k->has_plain_header = chance(k, 50);
    k->may_continue = k->has_outer_counter = true;
    k->counter_type = "int";
    put(k, &k->locals, "    int %s%s, %s;\n", counter, first_value(k), end);
    if (is_known) {
        const char *at = new_name(k, "at");
        put(k, &k->locals, "    int *const %s = &%s;\n", at, counter);
        put(k, &k->after, "    live[%d] = (double)*%s;\n", k->live++ % 8, at);
    }
    if (k->has_plain_header)
        put(k, b, "for (%s = 0, %s = (int)%s; %s < %s; %s++) ", counter, end, k->trip, counter, end,
            counter);
    else
        put(k, b, "for (%s = 0, %s = (int)%s - 1; %s >= %s; %s--) ", end, counter, k->trip, counter,
            end, counter);
}

/* A while loop that steps its counter in the body. Returns the text after the body. */
static const char *put_while(kernel *k, const char *counter, buffer *b) {
    k->has_plain_header = true;
    k->may_continue = false;
    k->has_outer_counter = true;
    k->counter_type = "int";
    put(k, &k->locals, "    int %s = 0;\n", counter);
    put(k, b, "while (%s < %s) ", counter, k->trip);
    return text(k, "%s++;\n}\n", counter);
}

typedef struct do_form {
    const char *type, *first; /* %s is the bound */
    const char *again;        /* %1$s: the counter, %2$s: the bound */
    bool is_plain, may_continue;
} do_form;

static const do_form do_forms[] = {
    {"int", "0", "%1$s++;\n} while (%1$s < %2$s);\n", true, false},
    {"int", "0", "} while (++%1$s < %2$s);\n", true, true},
    {"size_t", "0", "} while (++%1$s != (size_t)%2$s);\n", false, true},
    {"int", "%s - 1", "} while (--%1$s >= 0);\n", false, true},
    {"unsigned", "(unsigned)%s - 1", "} while (%1$s-- > 0);\n", false, true},
    {"long", "%s - 1", "} while (%1$s--);\n", false, true},
    {"int", "%s - 1", "%1$s--;\n} while (%1$s);\n", false, false},
    {"unsigned", "(unsigned)%s", "} while (--%1$s);\n", false, true},
};

/* A do loop, only in programs with seed % 11 == 0. Returns the text after the body. */
static const char *put_do(kernel *k, const char *counter, buffer *b) {
    const do_form *form = &do_forms[below(k, LENGTH(do_forms))];
    k->has_plain_header = form->is_plain;
    k->may_continue = form->may_continue;
    k->has_outer_counter = true;
    k->counter_type = form->type;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    const char *first = text(k, form->first, k->trip);
    const char *again = text(k, form->again, counter, k->trip);
#pragma GCC diagnostic pop
    put(k, &k->locals, "    %s %s = 0;\n", form->type, counter);
    put(k, b, "%s = %s;\nif (%s > 1)\ndo ", counter, first, k->trip);
    if (chance(k, 60))
        put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, counter);
    return again;
}

typedef struct statement_form {
    const char *type, *first;       /* %s is the bound */
    const char *head, *step, *last; /* %1$s: the counter, %2$s: the bound */
    bool is_plain;
} statement_form;

static const statement_form statement_forms[] = {
    {"int", "%s", "while (%1$s > 0) ", "--%1$s;\n", "}\n", false},
    {"long", "%s", "for (; %1$s >= 1;) ", "%1$s = %1$s - 1;\n", "}\n", false},
    {"int", "-1", "while (%1$s < %2$s - 1) ", "%1$s++;\n", "}\n", true},
    {"size_t", "%s", "while (%1$s > 0) ", "%1$s--;\n", "}\n", false},
    {"unsigned", "%s", "while (%1$s) ", "double early;\n%1$s -= 1;\n(void)early;\n", "}\n", false},
    {"unsigned", "%s", "while (0 != %1$s) ", "--%1$s;\n", "}\n", false},
    {"int", "%s", "if (%1$s > 0)\ndo ", "--%1$s;\n", "} while (%1$s);\n", false},
    {"int", "%s - 1", "if (%1$s > 0)\nwhile (%1$s) ", NULL, "--%1$s;\n}\n", false},
    {"int", "0", "for (; %1$s < %2$s;) ", NULL, "%1$s++;\n}\n", true},
};

/* A loop whose step is the first or last statement of the body, only in programs with
 * seed % 9 == 7. Returns the text after the body; stores that before it in *step. */
static const char *put_step_statement(kernel *k, const char *counter, buffer *b,
                                      const char **step) {
    const statement_form *form = &statement_forms[below(k, LENGTH(statement_forms))];
    k->has_plain_header = form->is_plain;
    k->may_continue = form->step != NULL;
    k->has_outer_counter = true;
    k->counter_type = form->type;
    put(k, &k->locals, "    %s %s = 0;\n", form->type, counter);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    put(k, b, "%s = (%s)(%s);\n", counter, form->type, text(k, form->first, k->trip));
    put(k, b, form->head, counter, k->trip);
    *step = form->step ? text(k, form->step, counter, k->trip) : "";
    const char *last = text(k, form->last, counter, k->trip);
#pragma GCC diagnostic pop
    if (chance(k, 60))
        put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, counter);
    return last;
}

typedef struct stride_form {
    const char *type, *first; /* %1$s: the counter, %2$s: the bound, %3$s: the stride */
    const char *head;
    bool is_plain;
} stride_form;

static const stride_form stride_forms[] = {
    {"int", "0", "for (; %1$s < %2$s; %1$s += %3$s) ", true},
    {"int", "0", "for (%1$s = 2; %1$s <= %2$s - 1; %1$s = %3$s + %1$s) ", true},
    {"long", "%2$s - 1", "for (; %1$s >= 0; %1$s -= %3$s) ", false},
    {"int", "%2$s", "for (; %1$s > 0; %1$s = %1$s - %3$s) ", false},
    {"size_t", "0", "for (; %1$s < (size_t)%2$s; %1$s += %3$s) ", true},
    {"unsigned", "1", "for (; %1$s < (unsigned)%2$s; %1$s += 1 + %3$s) ", true},
    {"long", "0", "while (%1$s < %2$s) ", true},
};

/* A loop with a variable step, only in programs with seed % 13 == 0. Returns the text after the
 * body. */
static const char *put_stride(kernel *k, bool with_bait, const char *counter, buffer *b) {
    static const char *const types[] = {"int", "int", "long", "short", "unsigned char", "size_t"};
    const stride_form *form = &stride_forms[below(k, LENGTH(stride_forms))];
    const bool is_while = strncmp(form->head, "while", 5) == 0;
    const char *by = new_name(k, "by");
    k->has_plain_header = form->is_plain;
    k->may_continue = !is_while;
    k->has_outer_counter = true;
    k->counter_type = form->type;
    put(k, &k->locals, "    %s %s = 0;\n    %s %s = (unsigned char)(1 + n %% %d);\n", form->type,
        counter, types[below(k, LENGTH(types))], by, 1 + below(k, 9));
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    put(k, b, "%s = %s;\n", counter, text(k, form->first, counter, k->trip));
    put(k, b, form->head, counter, k->trip, by);
#pragma GCC diagnostic pop
    if (chance(k, 60))
        put(k, &k->after, "    live[%d] = (double)%s;\n", k->live++ % 8, counter);
    const char *changed = with_bait && chance(k, 20) ? text(k, "%s |= 1;\n", by) : "";
    return is_while ? text(k, "%s%s += %s;\n}\n", changed, counter, by) : text(k, "%s}\n", changed);
}

static void choose_bound(kernel *k) {
    static const char *const types[] = {"int", "int", "int", "long", "short"};
    k->trip_type = types[below(k, LENGTH(types))];
    const int which = below(k, 10);
    k->trip_is_variable = which < 7;
    if (which < 7)
        k->trip = "n";
    else if (which == 7)
        k->trip = "c->n";
    else if (which == 8)
        k->trip = "v.n";
    else
        k->trip = text(k, "%d", k->trips);
}

static void put_statements(kernel *k, bool with_bait) {
    const int count = 1 + below(k, 7);
    const int bait_at = with_bait ? below(k, count) : -1;
    const bool drains = k->has_drains && chance(k, 70);
    const char *store = drains ? read_then_stored(k) : "";
    const int store_at = drains ? below(k, count + 2) : -1;
    if (k->has_drains && chance(k, 40))
        filling_operand(k);
    if (k->has_drains && chance(k, 40))
        sum_in_memory(k);
    for (int i = 0; i < count; i++) {
        if (i == bait_at)
            bait(k);
        if (i == store_at)
            buffer_text(&k->body, store);
        statement(k);
    }
    const size_t begin = begin_statement(k);
    const array *a = any_reduction(k);
    const char *where = place(k, a, subscript(k));
    put(k, &k->body, "%s;\n", update(k, a, where));
    end_statement(k, begin);
    if (store_at >= count)
        buffer_text(&k->body, store);
}

/* Appends mostly loops over the parts of rows: such a body usually has a form for binning. */
static void put_parts(kernel *k) {
    for (int left = 1 + below(k, 3); left > 0; left--) {
        const size_t begin = begin_statement(k);
        if (chance(k, 80))
            loop_over_parts(k);
        else
            plain_update(k);
        end_statement(k, begin);
    }
}

static void put_alike(kernel *k, void (*put_one)(kernel *)) {
    for (int left = 1 + below(k, 2); left > 0; left--) {
        const size_t begin = begin_statement(k);
        put_one(k);
        end_statement(k, begin);
    }
}

static void put_loop(kernel *k, bool with_bait, const char *counter) {
    const bool is_while = chance(k, 6);
    const char *step = "", *end = "}\n";
    buffer head = {0};
    choose_bound(k);
    if (k->has_idioms && chance(k, 25))
        end = put_do(k, counter, &head);
    else if (k->has_strides && chance(k, 40))
        end = put_stride(k, with_bait, counter, &head);
    else if (k->has_steps && chance(k, 40))
        end = put_step_statement(k, counter, &head, &step);
    else if (is_while)
        end = put_while(k, counter, &head);
    else if (k->is_wide && chance(k, 6))
        put_pair(k, counter, &head);
    else if (k->is_wide && chance(k, 10))
        put_bound(k, counter, &head);
    else
        put_header(k, counter, &head);
    put(k, &k->body, "%s{\n%s", head.data, step);
    buffer_free(&head);
    add_name(&k->scope.positions, counter);
    if (k->has_lookups && chance(k, 60))
        look_up_by_changed(k);
    if (k->has_parts && chance(k, 60))
        put_parts(k);
    else if (k->has_turns && chance(k, 80))
        put_alike(k, loop_along_a_list);
    else if (k->has_pairs && chance(k, 90))
        put_alike(k, call_of_pair);
    else if (k->has_walks && chance(k, 80))
        put_alike(k, walk_along_elements);
    else if (k->has_tables && chance(k, 80))
        put_alike(k, tables_by_pointers);
    else
        put_statements(k, with_bait);
    buffer_text(&k->body, end);
}

/* ---- the program ----------------------------------------------------------------------------- */

/* Appends successive loops over the same arrays; a jump may lead to the first one again. */
static void put_loops(kernel *k, bool with_bait) {
    static const char *const counters[] = {"i", "t", "u"};
    const scope outside = k->scope;
    const char *first = chance(k, 80) ? "i" : "t";
    const bool is_repeated = k->is_wide && chance(k, 10);
    if (is_repeated) {
        put(k, &k->locals, "    int rounds = 0;\n");
        put(k, &k->body, "again:\n");
    }
    put_loop(k, with_bait, first);
    if (is_repeated)
        put(k, &k->body, "if (++rounds < 2)\ngoto again;\n");
    for (int i = 0; k->is_wide && i < 3 && chance(k, 30); i++)
        if (strcmp(counters[i], first) != 0) {
            k->scope = outside;
            put_loop(k, with_bait && chance(k, 50), counters[i]);
        }
    if (k->has_recent && chance(k, 25)) {
        const size_t begin = begin_statement(k);
        k->scope = outside;
        loop_with_directives(k);
        end_statement(k, begin);
    }
}

static void put_all(kernel *k, buffer *b) {
    const unsigned long long seed = (unsigned long long)k->seed;
    buffer objects = {0};
    put_objects(k, &objects);
    put(k, b, "/* program %llu */\n%s%s", seed, objects.data,
        k->globals.length ? k->globals.data : "");
    if (chance(k, 5))
        put(k, b, "#line %d \"made_%llu.y\"\n", 10 + below(k, 500), seed);
    /* redcc puts the code that it generates for a function with attributes in the loop's place, and
     * for other functions in front of the function. */
    put(k, b, "static %svoid kernel_%llu%s {\n",
        seed % 4 == 3 ? "__attribute__((aligned(32))) " : "", seed, parameters(k));
    put(k, b, "    (void)n, (void)c, (void)v, (void)live;\n%s%s",
        k->pointers.length ? k->pointers.data : "", k->locals.length ? k->locals.data : "");
    random_source branches = {k->seed * 0x9e3779b97f4a7c15u + 5}; /* the rest stays the same */
    if (chance(k, 15) && !strstr(k->body.data, "#pragma")) /* noise would break a directive */
        put_with_noise(b, &k->random, k->body.data);
    else if (random_chance(&branches, 30))
        put_with_branches(b, &branches, k->body.data);
    else
        put(k, b, "%s", k->body.data);
    put(k, b, strstr(k->body.data, "goto done") ? "done:;\n%s}\n" : "%s}\n",
        k->after.length ? k->after.data : "");
    put_runner(k, b);
    buffer_free(&objects);
}

int put_kernel(buffer *b, uint64_t seed, const bool *without, int without_count) {
    kernel k = {.seed = seed,
                .random = {seed * 0x2545f4914f6cdd1du + 1},
                .memory = arena_new(),
                .without = without,
                .without_count = without_count};
    const bool with_bait = chance(&k, 50);
    k.is_wide = seed % 2 == 0;
    k.has_rows = seed % 5 == 0;
    k.has_spans = seed % 3 == 0;
    k.sets_in_headers = seed % 7 == 2;
    k.has_helpers = seed % 7 == 0;
    k.has_idioms = seed % 11 == 0;
    k.has_strides = seed % 13 == 0;
    k.has_steps = seed % 9 == 7;
    k.has_drains = seed % 17 == 0;
    k.has_parts = seed % 6 == 1;
    k.has_turns = seed % 7 == 6;
    k.has_walks = seed % 9 == 4;
    k.has_pairs = seed % 19 == 3;
    k.has_tables = seed % 8 == 3;
    k.has_lookups = seed % 6 == 4;
    k.has_shapes = seed % 3 == 1;
    k.has_leaving = seed % 6 == 2;
    k.has_recent = strchr("2569", '0' + (int)(seed % 10)) != NULL;
    k.is_masked = k.is_damped = with_bait || chance(&k, 30);
    make_world(&k);
    put_loops(&k, with_bait);
    put_all(&k, b);
    buffer_free(&k.globals);
    buffer_free(&k.pointers);
    buffer_free(&k.locals);
    buffer_free(&k.body);
    buffer_free(&k.after);
    arena_free(k.memory);
    return k.statements;
}
