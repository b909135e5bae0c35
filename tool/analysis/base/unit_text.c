/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/unit_text.h"

#include <string.h>

#include "support/vector.h"

struct unit_text {
    arena *memory;
    const ir_unit *unit;
    const char *fenv_access;
    bool has_own_options;
    VECTOR(uint32_t) counters; /* offsets of __COUNTER__ in the file, in ascending order */
    /* The last function that was searched, with the result. Loops are analysed function by
     * function, so one entry is enough. */
    const ir_function *searched;
    const ir_node *obstacle;
    const char *obstacle_name;
    bool is_setjmp;
};

static const char counter_word[] = "__COUNTER__";

static void find_counters(unit_text *text) {
    const source *s = text->unit->source;
    if (!s)
        return;
    const size_t length = sizeof counter_word - 1;
    const char *end = s->text + s->length, *at = s->text;
    while ((size_t)(end - at) >= length && (at = memchr(at, '_', (size_t)(end - at)))) {
        if ((size_t)(end - at) >= length && memcmp(at, counter_word, length) == 0)
            VECTOR_PUSH(text->memory, &text->counters, (uint32_t)(at - s->text));
        at++;
    }
}

static bool has_word(const char *text, const char *const *words, unsigned count) {
    for (unsigned i = 0; i < count; i++)
        if (strstr(text, words[i]))
            return true;
    return false;
}

static bool find_own_options(const ir_unit *unit) {
    static const char *const pragmas[] = {"optimize",      "target",      "clang fp",
                                          "float_control", "FP_CONTRACT", "attribute"};
    if (unit->text.names_optimize || unit->text.pragma_macros)
        return true;
    for (unsigned i = 0; i < unit->text.header_pragma_count; i++)
        if (has_word(unit->text.header_pragmas[i], pragmas, 6))
            return true;
    for (unsigned i = 0; i < unit->directive_count; i++) {
        const ir_directive *d = &unit->directives[i];
        if (d->kind == IR_DIRECTIVE_PRAGMA && d->text && has_word(d->text, pragmas, 6))
            return true;
    }
    return false;
}

static const char *find_fenv_access(const ir_unit *unit) {
    if (unit->text.may_make_fenv_access)
        return "FENV_ACCESS";
    const unsigned count = unit->directive_count + unit->text.header_pragma_count;
    for (unsigned i = 0; i < count; i++) {
        const char *words = i < unit->directive_count
                                ? unit->directives[i].text
                                : unit->text.header_pragmas[i - unit->directive_count];
        if (words && strstr(words, "FENV_ACCESS") && strstr(words, "ON"))
            return words;
    }
    return NULL;
}

unit_text *unit_text_new(arena *a, const ir_unit *unit) {
    unit_text *text = ARENA_NEW(a, unit_text);
    text->memory = a;
    text->unit = unit;
    text->fenv_access = find_fenv_access(unit);
    text->has_own_options = find_own_options(unit);
    find_counters(text);
    return text;
}

bool unit_text_has_own_options(const unit_text *text) {
    return text->has_own_options;
}

const char *unit_text_fenv_access(const unit_text *text) {
    return text->fenv_access;
}

bool unit_text_has_counter(const unit_text *text, ir_range range) {
    for (unsigned i = 0; i < text->counters.count; i++) {
        const uint32_t at = text->counters.items[i];
        if (at >= range.begin && at + sizeof counter_word - 1 <= range.end)
            return true;
    }
    return false;
}

static bool find_obstacle(ir_node *node, void *context) {
    unit_text *text = context;
    if (text->obstacle)
        return false;
    const ir_variable *variable = node->variable;
    if ((node->kind == IR_VARIABLE || node->kind == IR_DECLARATOR) && variable && variable->name &&
        !variable->is_unnamed && strncmp(variable->name, "redcc__", 7) == 0) {
        text->obstacle = node;
        text->obstacle_name = variable->name;
        text->is_setjmp = false;
    } else if (node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION) {
        const char *name = node->children[0]->function->name;
        if (strstr(name, "setjmp")) {
            text->obstacle = node;
            text->obstacle_name = name;
            text->is_setjmp = true;
        }
    }
    return true;
}

const ir_node *unit_text_obstacle(unit_text *text, const ir_function *function, const char **name,
                                  bool *is_setjmp) {
    if (text->searched != function) {
        text->searched = function;
        text->obstacle = NULL;
        ir_walk(function->body, find_obstacle, text);
    }
    *name = text->obstacle_name;
    *is_setjmp = text->is_setjmp;
    return text->obstacle;
}
