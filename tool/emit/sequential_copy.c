/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/sequential_copy.h"

#include <string.h>

#include "analysis/base/openmp_loop.h"
#include "emit/base/names.h"
#include "emit/crew.h"
#include "emit/text/origin.h"
#include "ir/ir_syntax.h"
#include "plan/sections.h"

static const ir_variable *variable_of(const loop_text *loop, const char *name) {
    return openmp_variable(loop->unit, loop->facts->loop, loop->facts->function, name);
}

const char *clause_expression(const loop_text *loop, const char *whole) {
    buffer out = {0};
    size_t length;
    const char *text = whole;
    for (const char *at = openmp_token(text, &length); length > 0;
         text = at + length, at = openmp_token(text, &length)) {
        const ir_variable *variable = openmp_is_name(whole, at)
                                          ? variable_of(loop, arena_copy(loop->arena, at, length))
                                          : NULL;
        buffer_format(&out, "%.*s", (int)(at - text), text);
        if (variable)
            buffer_text(&out, origin_variable(loop->arena, variable));
        else
            buffer_format(&out, "%.*s", (int)length, at);
    }
    return buffer_take(loop->arena, &out);
}

/* The expression in the clause of this kind, or NULL if there is no such clause. */
static const char *expression_of(const loop_text *loop, openmp_clause_kind kind) {
    const openmp_loop *openmp = loop->facts->variables.openmp;
    for (unsigned i = 0; i < openmp->item_count; i++)
        if (openmp->items[i].kind == kind)
            return clause_expression(loop, openmp->items[i].text);
    return NULL;
}

void declare_replaces(loop_text *loop, writer *out) {
    if (has_crew(loop))
        writer_line(out, "const int redcc__replaces = redcc__crew != 0;");
    else if (loop->facts->variables.openmp)
        writer_line(out, "const int redcc__replaces = REDCC_REPLACES(%s, %d);",
                    outlined_name(loop, "site"), loop->facts->variables.openmp->has_locks);
}

const char *replaced_condition(loop_text *loop) {
    if (!loop->facts->variables.openmp)
        return "";
    const char *condition = is_reordered(loop->plan) ? NULL : expression_of(loop, OPENMP_IF);
    return condition ? arena_format(loop->arena, "redcc__replaces && (%s) && ", condition)
                     : "redcc__replaces && ";
}

void write_team(loop_text *loop, writer *out) {
    const char *threads =
        loop->facts->variables.openmp ? expression_of(loop, OPENMP_NUM_THREADS) : NULL;
    /* The order of the loop's results must not depend on an `if` clause. If the clause's condition
     * is false, one thread executes the loop in the same order. */
    const char *condition = is_reordered(loop->plan) ? expression_of(loop, OPENMP_IF) : NULL;
    if (condition)
        threads = arena_format(loop->arena, "(%s) ? (%s) : 1", condition, threads ? threads : "0");
    if (threads)
        writer_line(out, "redcc__attempt.threads = (int)(%s);", threads);
}

/* Is the clause the first that names the variable, and is the variable not lastprivate? */
static bool is_hidden(const loop_text *loop, unsigned number) {
    const openmp_loop *openmp = loop->facts->variables.openmp;
    const openmp_item *item = &openmp->items[number];
    if (item->kind > OPENMP_FIRSTPRIVATE)
        return false;
    for (unsigned i = 0; i < openmp->item_count; i++)
        if (openmp->items[i].kind <= OPENMP_LASTPRIVATE &&
            strcmp(openmp->items[i].text, item->text) == 0 &&
            (i < number || openmp->items[i].kind == OPENMP_LASTPRIVATE))
            return false;
    return true;
}

static void hide(loop_text *loop, writer *out, const ir_variable *variable, bool has_value) {
    const char *name = origin_variable(loop->arena, variable);
    const char *own = origin_declarator(loop->arena, variable);
    if (has_value)
        writer_line(out, "__typeof__(%s) redcc__first_%s = %s;", name, variable->name, name);
    writer_line(out, "{ __typeof__(%s) %s%s%s;", name, own, has_value ? " = redcc__first_" : "",
                has_value ? variable->name : "");
}

/* Opens blocks whose variables hide the threads' private variables and the counter. The hidden
 * variables then have their old values after the loop. Returns the number of blocks. */
static unsigned hide_privates(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    const openmp_loop *openmp = facts->variables.openmp;
    unsigned blocks = 0;
    bool is_counter_named = facts->counted.counter_is_declared_in_header;
    for (unsigned i = 0; i < openmp->item_count; i++) {
        const openmp_item *item = &openmp->items[i];
        const ir_variable *variable =
            item->kind <= OPENMP_LASTPRIVATE ? variable_of(loop, item->text) : NULL;
        is_counter_named |= variable && variable == facts->counted.counter;
        if (!variable || !is_hidden(loop, i))
            continue;
        hide(loop, out, variable, item->kind == OPENMP_FIRSTPRIVATE);
        blocks++;
    }
    if (is_counter_named)
        return blocks;
    hide(loop, out, facts->counted.counter, false);
    return blocks + 1;
}

void write_sequential_copy(loop_text *loop, writer *out) {
    const ir_node *whole = loop->facts->loop;
    const uint32_t end = syntax_statement_end(loop->unit->source, whole);
    writer_line(out, "if (redcc__replaces) {");
    writer_line(out, "REDCC_QUIET_BEGIN");
    const unsigned blocks = hide_privates(loop, out);
    writer_line(out, "REDCC_QUIET_END");
    buffer_format(&out->out, "%s\n%s", loop_line_directive(loop, whole->range.begin),
                  loop_column_blanks(loop, whole->range.begin));
    origin_copy(&out->out, loop->unit->source->text, whole->range.begin, end);
    buffer_byte(&out->out, '\n');
    for (unsigned i = 0; i < blocks; i++)
        buffer_text(&out->out, "}");
    writer_line(out, "} else");
}
