/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/context.h"

#include <ctype.h>
#include <string.h>

#include "emit/base/names.h"
#include "emit/body/own.h"
#include "emit/body/scalars.h"
#include "emit/body/series.h"
#include "emit/body/tile_rows.h"
#include "emit/text/origin.h"
#include "plan/lookup.h"

/* ---- the user's variables -------------------------------------------------------------------- */

const char *pointer_name(loop_text *loop, const ir_variable *variable) {
    return arena_format(loop->arena, "redcc__at_%s", variable->name);
}

static bool is_pointed(const loop_text *loop, const ir_variable *variable) {
    return loop->outline.by_address[variable->id] != NULL;
}

const char *passed_argument(loop_text *loop, const ir_variable *variable) {
    return is_pointed(loop, variable) ? pointer_name(loop, variable)
                                      : origin_variable(loop->arena, variable);
}

static const char *member_name(loop_text *loop, const ir_variable *variable) {
    return is_pointed(loop, variable) ? pointer_name(loop, variable) : variable->name;
}

static const char *pointer_declaration(loop_text *loop, const ir_variable *variable) {
    return declaration_text(loop, variable->type,
                            arena_format(loop->arena, "(*%s)", pointer_name(loop, variable)));
}

const char *passed_declaration(loop_text *loop, const ir_variable *variable) {
    if (is_pointed(loop, variable))
        return pointer_declaration(loop, variable);
    const char *name = origin_declarator(loop->arena, variable);
    if (variable->type->kind == IR_ARRAY)
        return declaration_text(loop, variable->type->target,
                                arena_format(loop->arena, "*%s", name));
    return declaration_text(loop, variable->type, name);
}

/** The declaration of the context's member for the variable. The caller assigns to that member. */
static const char *member_declaration(loop_text *loop, const ir_variable *variable) {
    if (is_pointed(loop, variable))
        return pointer_declaration(loop, variable);
    if (variable->type->kind == IR_ARRAY)
        return declaration_text(loop, variable->type->target,
                                arena_format(loop->arena, "*%s", variable->name));
    return assignable_declaration_text(loop, variable->type, variable->name);
}

/* ---- other values -------------------------------------------------------------------------- */

/** Does the name occur in the text, and is it not followed by further characters of a name? */
static bool holds_name(const char *text, const char *name) {
    const size_t length = strlen(name);
    for (const char *at = text; (at = strstr(at, name)); at += length)
        if (!source_is_name_byte(at[length]))
            return true;
    return false;
}

typedef struct extras {
    loop_text *loop;
    const char *text;
    void (*take)(const extra_value *value, void *context);
    void *context;
} extras;

static void offer(extras *self, extra_value value) {
    if (holds_name(self->text, value.name))
        self->take(&value, self->context);
}

static void offer_to(void *self, extra_value value) {
    offer(self, value);
}

static void offer_stepped(extras *self, unsigned i) {
    arena *a = self->loop->arena;
    const char *const names[] = {arena_format(a, "redcc__from_%u", i),
                                 arena_format(a, "redcc__by_%u", i),
                                 arena_format(a, "redcc__inner_trips_%u", i)};
    static const char *const types[] = {"redcc_word", "redcc_word", "redcc_int"};
    for (unsigned k = 0; k < 3; k++)
        offer(self, (extra_value){names[k], arena_format(a, "const %s %s", types[k], names[k]),
                                  .given = names[k]});
}

/** Calls offer() with the pointer through which a live-out variable's last value is stored. */
static void offer_last(extras *self, unsigned i) {
    loop_text *loop = self->loop;
    const ir_variable *variable = loop->facts->variables.privates[i].variable;
    const char *name = arena_format(loop->arena, "redcc__last_%s", variable->name);
    const char *pointer = arena_format(loop->arena, "(*%s)", name);
    offer(self, (extra_value){name, assignable_declaration_text(loop, variable->type, pointer),
                              .given = arena_format(loop->arena, "&%s", name)});
}

static void offer_noted(extras *self, unsigned i) {
    loop_text *loop = self->loop;
    arena *a = loop->arena;
    const ir_variable *variable = loop->facts->variables.privates[i].variable;
    const char *const names[] = {
        arena_format(a, "redcc__when_%u", i), arena_format(a, "redcc__noted_%u", i),
        arena_format(a, "redcc__latest_%u", i), arena_format(a, "redcc__found_%u", i)};
    for (unsigned k = 0; k < 4; k++) {
        const char *pointer = arena_format(a, "*%s", names[k]);
        const char *declaration = k % 2 == 0
                                      ? arena_format(a, "redcc_int %s", pointer)
                                      : assignable_declaration_text(loop, variable->type, pointer);
        extra_value value = {names[k], declaration, .given = arena_format(a, "&%s", names[k])};
        if (k < 2) {
            value.given = NULL;
            value.made = arena_format(a, "&redcc__of_thread_%s_%u", k == 0 ? "when" : "noted", i);
        }
        offer(self, value);
    }
}

static void offer_operands(extras *self, unsigned i) {
    arena *a = self->loop->arena;
    for (unsigned k = 0; k < 2; k++) {
        const char *type = kept_operand_type(self->loop, i, k == 1);
        if (!type)
            continue;
        const char *name = kept_operand_name(self->loop, i, k == 1);
        offer(self,
              (extra_value){name, arena_format(a, "%s *const %s", type, name),
                            .made = arena_format(a, "(%s *)redcc__attempt->operands[%u]", type,
                                                 kept_operand_number(self->loop, i, k == 1))});
    }
}

static void offer_own(extras *self, unsigned i) {
    arena *a = self->loop->arena;
    const char *name = kept_own_name(self->loop, i), *type = kept_own_type(self->loop, i);
    offer(self, (extra_value){name, arena_format(a, "%s *const %s", type, name),
                              .made = arena_format(a, "(%s *)redcc__attempt->operands[%u]", type,
                                                   kept_own_number(self->loop, i))});
}

void for_each_extra(loop_text *loop, const char *text,
                    void (*take)(const extra_value *value, void *context), void *context) {
    extras self = {loop, text, take, context};
    offer(&self, (extra_value){"redcc__k", "const redcc_int redcc__k", NULL, NULL});
    offer(&self, (extra_value){"redcc__trip", "const redcc_int redcc__trip", NULL, NULL});
    offer(&self, (extra_value){"redcc__stride", "const redcc_int redcc__stride",
                               .given = "redcc__stride"});
    offer(&self, (extra_value){"redcc__lock", "int *redcc__lock", .given = "&redcc__lock"});
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        const private_variable *item = &loop->facts->variables.privates[i];
        if (item->is_stepped)
            offer_stepped(&self, i);
        if (item->is_live_after)
            offer_last(&self, i);
        if (item->is_conditional_live_out)
            offer_noted(&self, i);
    }
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        offer_operands(&self, i);
    for (unsigned i = 0; i < loop->facts->variables.own_count; i++)
        offer_own(&self, i);
    if (has_series(loop->facts))
        for_each_series_value(loop, offer_to, &self);
    if (has_tile_rows(loop))
        offer(&self, tile_rows_value(loop));
}

/* ---- the struct ---------------------------------------------------------------------------- */

typedef struct listing {
    loop_text *loop;
    writer *out;
} listing;

/** The declaration without `const`: the caller assigns to members of the context. */
static const char *not_const(const char *declaration) {
    static const char word[] = "const ";
    return strncmp(declaration, word, sizeof word - 1) == 0 ? declaration + sizeof word - 1
                                                            : declaration;
}

static void declare_extra(const extra_value *value, void *context) {
    const listing *to = context;
    if (value->given)
        writer_line(to->out, "%s;", not_const(value->declaration));
}

static void fill_extra(const extra_value *value, void *context) {
    const listing *to = context;
    if (value->given)
        writer_line(to->out, "redcc__context.%s = %s;", value->name, value->given);
}

static void take_extra(const extra_value *value, void *context) {
    const listing *to = context;
    if (value->given)
        writer_line(to->out, "%s = redcc__context->%s;", value->declaration, value->name);
    else if (value->made)
        writer_line(to->out, "%s = %s;", value->declaration, value->made);
}

void write_context(loop_text *loop, writer *out) {
    listing to = {loop, out};
    writer_line(out, "struct %s {", outlined_name(loop, "context"));
    out->depth++;
    writer_line(out, "REDCC_PROGRESSIONS_OF(%u);", loop->plan->source_count);
    for (unsigned i = 0; i < loop->unit->variable_count; i++)
        if (loop->outline.is_passed[i])
            writer_line(out, "%s;", member_declaration(loop, loop->unit->variables[i]));
    for_each_extra(loop, loop->outline.text, declare_extra, &to);
    out->depth--;
    writer_line(out, "};");
}

void fill_context(loop_text *loop, writer *out) {
    listing to = {loop, out};
    for (unsigned i = 0; i < loop->unit->variable_count; i++)
        if (loop->outline.is_passed[i])
            writer_line(out, "redcc__context.%s = %s%s;",
                        member_name(loop, loop->unit->variables[i]),
                        is_pointed(loop, loop->unit->variables[i]) ? "&" : "",
                        origin_variable(loop->arena, loop->unit->variables[i]));
    for_each_extra(loop, loop->outline.text, fill_extra, &to);
}

void take_context(loop_text *loop, writer *out) {
    listing to = {loop, out};
    writer_line(out, "REDCC_BEGIN(%s);", outlined_name(loop, "context"));
    for (unsigned i = 0; i < loop->unit->variable_count; i++)
        if (loop->outline.is_passed[i])
            writer_line(out, "%s = redcc__context->%s;",
                        passed_declaration(loop, loop->unit->variables[i]),
                        member_name(loop, loop->unit->variables[i]));
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++)
        if (loop->facts->variables.privates[i].is_conditional_live_out) {
            const ir_type *type = loop->facts->variables.privates[i].variable->type;
            writer_line(out, "redcc_int redcc__of_thread_when_%u = -1;", i);
            writer_line(out, "%s = 0;",
                        assignable_declaration_text(
                            loop, type, arena_format(loop->arena, "redcc__of_thread_noted_%u", i)));
        }
    declare_thread_series(loop, out);
    declare_tile_rows(loop, out);
    for_each_extra(loop, loop->outline.text, take_extra, &to);
}
