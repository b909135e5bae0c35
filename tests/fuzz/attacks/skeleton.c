/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The loop around the features, the function that calls the kernel, and functions that all features
 * use. */
#include "fuzz/attacks/attack.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- text ------------------------------------------------------------------------------------ */

static const char *with_suffix(attack *a, const char *from) {
    buffer b = {0};
    for (; *from; from++)
        if (*from == '$')
            buffer_format(&b, "_%llu_%d", (unsigned long long)a->seed, a->features);
        else
            buffer_byte(&b, *from);
    const char *result = arena_copy(a->memory, b.data ? b.data : "", b.length);
    buffer_free(&b);
    return result;
}

static const char *format_text(attack *a, const char *format, va_list arguments) {
    char line[4000];
    vsnprintf(line, sizeof line, format, arguments);
    return with_suffix(a, line);
}

const char *text(attack *a, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const char *result = format_text(a, format, arguments);
    va_end(arguments);
    return result;
}

void put(attack *a, part where, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    buffer_text(&a->parts[where], format_text(a, format, arguments));
    va_end(arguments);
}

bool chance(attack *a, int percent) {
    return random_chance(&a->random, percent);
}

int below(attack *a, int n) {
    return random_below(&a->random, n);
}

const char *one_of(attack *a, int count, const char *const *choices) {
    return choices[below(a, count)];
}

void note(attack *a, const char *kind) {
    buffer_format(&a->kinds, " %s", kind);
}

void may_change(attack *a, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const char *statement = format_text(a, format, arguments);
    va_end(arguments);
    if (a->changes.count < (int)(sizeof a->changes.statement / sizeof *a->changes.statement))
        a->changes.statement[a->changes.count++] = statement;
}

void put_table(attack *a, const char *name, int below_what, int first) {
    put(a, PART_GLOBALS, "static int %s$[%d];\n", name, a->trips + SPARE);
    put(a, PART_SETUP, "attack_fill_ints(%s$, %d, %d);\n", name, a->trips + SPARE, below_what);
    const int place = first + a->trips / 2 + below(a, (a->trips + 1) / 2);
    may_change(a, "%s$[%d] = (%s$[%d] + 1 + attack_below(%d)) %% %d;", name, place, name, place,
               below_what - 1, below_what);
    may_change(a, "%s$[%d] = attack_below(%d);", name, first + a->trips - 1 - below(a, 3),
               below_what);
}

/* ---- the kernel's data ----------------------------------------------------------------------- */

typedef struct world {
    int pool;        /* number of elements of the memory that contains x and h */
    int x, h;        /* positions of x and h in the pool */
    int step;        /* the counter's step */
    bool is_sized;   /* the second call has other positions */
    const char *own; /* the subscript if no feature gives one */
} world;

static const char *const floating_types[] = {"double", "double", "float"};
static const char *const integer_types[] = {"unsigned long", "short", "unsigned long",
                                            "unsigned",      "int",   "unsigned char"};
static const char *const counter_types[] = {"int",      "int",      "int",  "unsigned", "unsigned",
                                            "unsigned", "unsigned", "long", "size_t"};

/* Returns a distance at which an extent that is slightly or very wrong would miss the overlap. */
static int distance(attack *a) {
    switch (below(a, 6)) {
    case 0:
    case 1:
        return 0;
    case 2:
        return below(a, 8);
    case 3:
        return a->trips - a->elements > 0 ? below(a, a->trips - a->elements + 1) : 0;
    case 4:
        return below(a, a->trips);
    default:
        return -below(a, a->elements);
    }
}

static void choose_places(attack *a, world *w) {
    const int d = distance(a);
    w->x = a->elements + 8 + (chance(a, 30) ? below(a, a->trips) : 0);
    w->h = w->x + d;
}

static void choose_world(attack *a, world *w) {
    static const int sizes[] = {16, 40, 120, 300};
    a->is_floating = chance(a, 80);
    a->element = a->is_floating ? one_of(a, 3, floating_types) : one_of(a, 6, integer_types);
    a->counter_type = chance(a, 3) ? "unsigned short" : one_of(a, 9, counter_types);
    a->trips = chance(a, 10) ? 40 + below(a, 40) : 150 + below(a, 700);
    a->elements = chance(a, 50) ? a->trips - 9 - below(a, 20) : sizes[below(a, 4)];
    if (a->elements > a->trips)
        a->elements = a->trips;
    a->limit = 2 * a->trips;
    choose_places(a, w);
    w->pool = 4 * a->trips + a->elements + 320;
    w->step = chance(a, 93) ? 1 : 1 + below(a, 3);
    w->is_sized = chance(a, 15);
}

/* ---- the loop -------------------------------------------------------------------------------- */

static const char *as_subscript(attack *a, const operand *o) {
    if (o->is_subscript)
        return o->text;
    return text(a, "(int)((unsigned)(%s) %% %du)", o->text, (unsigned)a->elements);
}

static const char *as_condition(attack *a, const operand *o) {
    if (!o->is_integer)
        return text(a, "(%s) > 0.125", o->text);
    return text(a, below(a, 2) ? "((%s) & 1) == 0" : "(%s) %% 3 != 1", o->text);
}

static const char *as_value(attack *a, const operand *o) {
    if (a->is_floating)
        return text(a, o->is_integer ? "0.0625 * (double)((%s) & 255)" : "0.375 * (%s)", o->text);
    return text(a, o->is_integer ? "(%s) & 15" : "(int)attack_damp(%s) & 15", o->text);
}

static void put_header(attack *a, const world *w) {
    static const char *const forms[] = {
        "for (%s t = 0; t < n; t%s)",
        "for (%s t = 0; n > t; t%s)",
        "for (%s t = 0; t <= n - 1; t%s)",
    };
    const char *step = w->step == 1 ? "++" : text(a, " += %d", w->step);
    buffer_format(&a->parts[PART_BEFORE], "%s {\n",
                  text(a, forms[chance(a, 96) ? 0 : 1 + below(a, 2)], a->counter_type, step));
}

static void put_update(attack *a, const char *subscript, const char *value) {
    static const char *const floating[] = {"h[%s] += %s;\n", "h[%s] += %s;\n", "h[%s] -= %s;\n",
                                           "h[%s] = %s;\n"};
    static const char *const integer[] = {"h[%s] += %s;\n", "h[%s] += %s;\n", "h[%s] ^= %s;\n",
                                          "h[%s] = (%s) & 255;\n"};
    buffer_format(&a->parts[PART_BODY],
                  a->is_floating ? floating[below(a, 4)] : integer[below(a, 4)], subscript, value);
}

static operand make_feature(attack *a) {
    static feature *const features[] = {
        wrapped_extents,      wrapped_extents, hidden_names,        shadowed_in_body,
        addresses_as_values,  block_restrict,  changed_types,       names_like_builtins,
        values_of_the_thread, searches,        floating_subscripts, odd_text,
        beside_scalars,       made_valid,      behind_the_loop,     slices};
    /* Features that were added later are the first feature of the seeds with these remainders.
     * They draw no random number, so that all other seeds yield the same programs as before. */
    static feature *const later[16] = {
        [3] = counters_set_inside, [7] = masks, [10] = held, [13] = mapped};
    feature *chosen = a->features == 0 ? later[a->seed % 16] : NULL;
    if (!chosen)
        chosen = features[below(a, (int)(sizeof features / sizeof *features))];
    operand o = chosen(a);
    a->features++;
    return o;
}

typedef struct marks {
    size_t length[PART_COUNT];
    int changes;
    size_t kinds;
} marks;

static marks begin_statement(const attack *a) {
    marks m = {.changes = a->changes.count, .kinds = a->kinds.length};
    for (int i = 0; i < PART_COUNT; i++)
        m.length[i] = a->parts[i].length;
    return m;
}

static void cut(buffer *b, size_t length) {
    b->length = length;
    if (b->data)
        b->data[length] = 0;
}

/** Numbers the text appended since, and removes it if it is to be left out. */
static bool end_statement(attack *a, const marks *m) {
    const bool is_left_out = a->without && a->without[a->statements];
    a->statements++;
    if (!is_left_out)
        return true;
    for (int i = 0; i < PART_COUNT; i++)
        cut(&a->parts[i], m->length[i]);
    a->changes.count = m->changes;
    cut(&a->kinds, m->kinds);
    return false;
}

/* Appends one update, whose subscript, value and condition are a feature's or plain. */
static void put_feature(attack *a, const world *w) {
    const marks m = begin_statement(a);
    const operand o = make_feature(a);
    const int role = below(a, 10);
    const char *plain = a->is_floating ? "w[t]" : text(a, "%d", 1 + below(a, 9));
    const char *subscript = w->own, *value = plain, *condition = NULL;
    if (!o.text) { /* the feature has its own updates */
        end_statement(a, &m);
        return;
    }
    if (o.is_subscript ? role < 6 : o.is_integer && role < 3)
        subscript = as_subscript(a, &o);
    else if (role < 8)
        value = as_value(a, &o);
    else
        condition = as_condition(a, &o);
    if (o.guard)
        condition = condition ? text(a, "(%s) && %s", o.guard, condition) : o.guard;
    if (condition)
        buffer_format(&a->parts[PART_BODY], "if (%s)\n", condition);
    put_update(a, subscript, value);
    end_statement(a, &m);
}

/* ---- the caller ------------------------------------------------------------------------------ */

static void put_call(attack *a, buffer *b, const world *w) {
    buffer_format(b, "call((%s)%d, pool_%llu + %d, pool_%llu + %d, table_%llu, weight_%llu%s);\n",
                  a->counter_type, a->trips, (unsigned long long)a->seed, w->x,
                  (unsigned long long)a->seed, w->h, (unsigned long long)a->seed,
                  (unsigned long long)a->seed,
                  a->parts[PART_ARGUMENTS].data ? a->parts[PART_ARGUMENTS].data : "");
}

static void put_calls(attack *a, buffer *b, world *w) {
    const int calls = 2 + below(a, 3);
    for (int i = 0; i < calls; i++) {
        const size_t before = b->length;
        if (i && a->changes.count && chance(a, 80))
            buffer_format(b, "%s\n", a->changes.statement[below(a, a->changes.count)]);
        if (i && w->is_sized)
            choose_places(a, w);
        put_call(a, b, w);
        if (a->without && a->without[a->statements])
            cut(b, before);
        a->statements++;
    }
}

static const char *all_of(const attack *a, part which) {
    return a->parts[which].data ? a->parts[which].data : "";
}

static void put_runner(attack *a, buffer *b, world *w) {
    const unsigned long long s = a->seed;
    /* The call is through a volatile pointer, so no compiler sees the kernel's arguments. */
    buffer_format(b,
                  "static void run_%llu(void) {\n__typeof__(&kernel_%llu) volatile call = "
                  "kernel_%llu;\nattack_seed(%llu);\n",
                  s, s, s, s);
    buffer_format(b, "ATTACK_FILL(pool_%llu, %d);\n", s, w->pool);
    buffer_format(b, "attack_fill_ints(table_%llu, %d, %d);\n", s, a->trips + SPARE, a->elements);
    buffer_format(b, "attack_fill_doubles(weight_%llu, %d);\n", s, a->trips + SPARE);
    buffer_text(b, all_of(a, PART_SETUP));
    put_calls(a, b, w);
    buffer_text(b, all_of(a, PART_FINISH));
    buffer_format(
        b,
        "attack_print(%lluu, pool_%llu, sizeof pool_%llu, ATTACK_IS_FLOATING(pool_%llu[0]));\n}\n",
        s, s, s, s);
}

static void put_kernel(attack *a, buffer *b, const world *w) {
    const unsigned long long s = a->seed;
    buffer_format(b, "/* %llu:%s */\n", s, a->kinds.data ? a->kinds.data : "");
    buffer_text(b, all_of(a, PART_INCLUDES));
    buffer_format(b, "static %s pool_%llu[%d];\n", a->element, s, w->pool);
    buffer_format(b, "static int table_%llu[%d];\nstatic double weight_%llu[%d];\n", s,
                  a->trips + SPARE, s, a->trips + SPARE);
    buffer_text(b, all_of(a, PART_GLOBALS));
    /* redcc puts the code that it generates for a function with attributes in the loop's place, and
     * for other functions in front of the function. */
    buffer_format(b,
                  "%sstatic void kernel_%llu(%s n, const %s *x, %s *h, const int "
                  "*k, const double *w%s) {\n",
                  s % 4 == 3 ? "__attribute__((noipa)) " : "", s, a->counter_type, a->element,
                  a->element, all_of(a, PART_PARAMETERS));
    buffer_format(b, "%s%s}\n%s}\n", all_of(a, PART_BEFORE), all_of(a, PART_BODY),
                  all_of(a, PART_AFTER));
}

int put_attack(buffer *b, uint64_t seed, const bool *without) {
    attack a = {.seed = seed, .random = {seed * 0x2545f4914f6cdd1du + 7}, .memory = arena_new()};
    a.flags = flags_of_block(seed / BLOCK);
    a.without = without;
    world w = {.own = "k[t]"};
    choose_world(&a, &w);
    for (int count = 1 + chance(&a, 40) + chance(&a, 15); count > 0; count--)
        put_feature(&a, &w);
    put_header(&a, &w);
    put_kernel(&a, b, &w);
    put_runner(&a, b, &w);
    for (int i = 0; i < PART_COUNT; i++)
        buffer_free(&a.parts[i]);
    buffer_free(&a.kinds);
    arena_free(a.memory);
    return a.statements;
}
