/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/invariants.h"

#include <assert.h>

#ifdef NDEBUG

void analysis_assert_verdict(const ir_unit *unit, const loop_verdict *verdict) {
    (void)unit;
    (void)verdict;
}

void analysis_assert_result(const ir_unit *unit, const analysis_result *result) {
    (void)unit;
    (void)result;
}

#else

static bool is_in_file(const ir_unit *unit, ir_range range) {
    return range.begin <= range.end && (!unit->source || range.end <= unit->source->length);
}

static bool is_in_loop(const loop_facts *facts, const ir_node *node) {
    return node && ir_contains(facts->loop, node);
}

/* ---- the loop's header ---------------------------------------------------------------------- */

static void assert_counted(const counted_loop *counted) {
    assert(counted->counter && (counted->counter->type->kind == IR_INTEGER ||
                                counted->counter->type->kind == IR_POINTER));
    assert(counted->bound && ir_is_expression(counted->bound));
    assert(counted->body && counted->increment);
    assert(!counted->lower || ir_is_expression(counted->lower));
    assert(counted->step != 0);
    assert(counted->ahead == 0 ||
           (counted->ahead > 0 && counted->step == 1 && !counted->stride &&
            counted->counter->type->kind == IR_INTEGER && !counted->steps_inside));
    assert(!counted->steps_at_start ||
           (!counted->steps_inside && !counted->steps_first && !counted->ends_below &&
            ir_contains(counted->body, counted->increment)));
    assert(!counted->stride || (counted->counter->type->kind == IR_INTEGER &&
                                (counted->step == 1 || counted->step == -1)));
    assert(counted->start_count <= sizeof counted->starts / sizeof *counted->starts);
    switch (counted->comparison) {
    case IR_OP_LESS:
    case IR_OP_LESS_EQUAL:
        assert(counted->step > 0);
        break;
    case IR_OP_GREATER:
    case IR_OP_GREATER_EQUAL:
        assert(counted->step < 0);
        break;
    default:
        assert(counted->comparison == IR_OP_NOT_EQUAL);
        assert(!counted->stride && (counted->counter->type->kind == IR_POINTER ||
                                    counted->step == 1 || counted->step == -1));
    }
}

/* ---- arrays and updates --------------------------------------------------------------------- */

static void assert_array(const reduction_array *array) {
    assert(array->base && ir_is_expression(array->base) && array->name);
    assert(array->element && ir_type_is_scalar(array->element) && array->element->size > 0);
    assert(array->unit >= array->element->size);
    assert(array->op <= REDUCTION_NONE);
    assert(array->op != REDUCTION_NONE || array->order_is_kept);
    assert(!array->is_scattered || array->is_interleaved);
}

static void assert_updates(const loop_facts *facts) {
    assert(facts->update_count > 0);
    for (unsigned i = 0; i < facts->update_count; i++) {
        const reduction_update *update = &facts->updates[i];
        assert(update->array < facts->array_count);
        assert(is_in_loop(facts, update->statement));
        assert(update->statement->kind == IR_EXPRESSION || update->statement->kind == IR_IF ||
               (update->last && update->statement->kind == IR_DECLARATOR));
        assert(update->target && ir_is_expression(update->target));
        assert(update->row && ir_is_expression(update->row));
    }
    for (unsigned k = 0; k < facts->array_count; k++) {
        unsigned updates = 0;
        for (unsigned i = 0; i < facts->update_count; i++)
            updates += facts->updates[i].array == k;
        assert(updates > 0);
    }
}

/* ---- other accesses of the loop ------------------------------------------------------------ */

static void assert_scalar(const loop_facts *facts, const scalar_update *scalar) {
    assert(scalar->target && is_in_loop(facts, scalar->target));
    assert(!scalar->variable || scalar->variable != facts->counted.counter);
    assert(is_in_loop(facts, scalar->statement));
    assert(scalar->statement->kind == IR_EXPRESSION ||
           (scalar->is_extremum && scalar->statement->kind == IR_IF));
    assert(!scalar->is_extremum || (scalar->op >= IR_OP_LESS && scalar->op <= IR_OP_GREATER_EQUAL));
    assert(!scalar->is_extremum || (scalar->value && !scalar->is_repeated));
    assert(!scalar->is_negated || scalar->is_extremum);
    assert(!scalar->place || scalar->is_extremum);
    assert(scalar->operand <= OPERAND_DOUBLE);
    assert(!scalar->is_repeated || scalar->is_series == (scalar->operand != OPERAND_INTEGER));
    assert(!scalar->is_series || !scalar->is_extremum);
    assert(!scalar->value || is_in_loop(facts, scalar->value));
}

static void assert_forward(const loop_facts *facts, const forwarded_store *store) {
    assert(is_in_loop(facts, store->statement) && store->statement->kind == IR_EXPRESSION);
    assert(is_in_loop(facts, store->target) && is_in_loop(facts, store->value));
    bool is_update = false;
    for (unsigned i = 0; i < facts->update_count; i++)
        is_update |= facts->updates[i].statement == store->statement;
    assert(is_update);
}

static void assert_source(const loop_facts *facts, const loop_source *item) {
    assert(item->name && item->row && ir_is_expression(item->row));
    assert(item->is_subscript || item->needs_guard);
    assert(item->extent <= EXTENT_BOUNDED);
    assert((item->extent == EXTENT_BOUNDED) == (item->bounds != NULL) &&
           !(item->bounds && item->is_subscript && !item->bounds->is_certain));
    assert(item->extent != EXTENT_TOUCHED || is_in_loop(facts, item->place));
    assert(item->extent == EXTENT_TOUCHED || item->base);
    assert(item->extent == EXTENT_TOUCHED || !item->is_ahead);
    assert(item->extent == EXTENT_AFFINE || (!item->limit_count && !item->is_checked));
    for (unsigned i = 0; i < item->limit_count; i++) {
        const counter_limit *limit = &item->limits[i];
        assert(limit->bound && limit->bound->type->kind == IR_INTEGER);
        assert(limit->comparison >= IR_OP_LESS && limit->comparison <= IR_OP_NOT_EQUAL);
    }
}

static void assert_private(const loop_facts *facts, const private_variable *item) {
    assert(item->variable && item->variable != facts->counted.counter);
    assert(item->variable->function == facts->function);
    assert(!item->is_declared_inside || (!item->is_live_after && !item->is_conditional_live_out));
    assert(!item->is_live_after || !item->is_conditional_live_out);
    assert(item->is_stepped || (!item->is_step_wanted && !item->is_in_slice && !item->entry));
    assert(!item->is_stepped || item->variable->type->kind == IR_INTEGER ||
           item->variable->type->kind == IR_POINTER);
    assert(item->is_stepped || !(item->stride_count || item->inner.loop));
    assert(!item->stride_count || !item->inner.loop);
}

static void assert_span(const loop_facts *facts, const loop_span *span) {
    assert(is_in_loop(facts, span->loop) && span->loop != facts->loop);
    assert(span->loop->kind == IR_FOR && facts->slice.holds[span->loop->id]);
    assert(span->counted.step >= 1 && !span->counted.stride);
    assert_counted(&span->counted);
}

static void assert_slice(const loop_facts *facts) {
    assert(facts->slice.holds && facts->inspector.exists == facts->slice.has_rows);
    assert(facts->inspector.exists || (!facts->slice.is_verifiable && !facts->slice.exits));
    assert(!facts->slice.is_verifiable || !facts->slice.unkept.name);
    for (unsigned i = 0; i < facts->inspector.key_count; i++)
        assert(facts->inspector.key[i] && ir_is_expression(facts->inspector.key[i]));
    for (unsigned i = 0; i < facts->inspector.span_count; i++)
        assert_span(facts, &facts->inspector.spans[i]);
    for (unsigned i = 0; i < facts->inspector.hull_count; i++)
        assert(is_in_loop(facts, facts->inspector.hulls[i]) &&
               facts->slice.holds[facts->inspector.hulls[i]->id]);
}

/* ---- verdicts ------------------------------------------------------------------------------- */

static void assert_facts(const loop_facts *facts) {
    assert(facts->array_count > 0);
    assert_counted(&facts->counted);
    for (unsigned i = 0; i < facts->array_count; i++)
        assert_array(&facts->arrays[i]);
    assert_updates(facts);
    for (unsigned i = 0; i < facts->scalar_count; i++)
        assert_scalar(facts, &facts->scalars[i]);
    for (unsigned i = 0; i < facts->forward_count; i++)
        assert_forward(facts, &facts->forwards[i]);
    for (unsigned i = 0; i < facts->source_count; i++)
        assert_source(facts, &facts->sources[i]);
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        assert_private(facts, &facts->variables.privates[i]);
    for (unsigned i = 0; i < facts->variables.captured_count; i++)
        assert(facts->variables.captured[i] &&
               facts->variables.captured[i] != facts->counted.counter);
    assert_slice(facts);
}

static void assert_reason(const ir_unit *unit, const reason *why) {
    assert(why->id > REASON_NONE && why->id < REASON_COUNT);
    assert(why->message && why->message[0]);
    assert(is_in_file(unit, why->range));
}

void analysis_assert_verdict(const ir_unit *unit, const loop_verdict *verdict) {
    assert(verdict->loop && ir_is_loop(verdict->loop));
    assert(verdict->function && verdict->function->body);
    assert(ir_contains(verdict->function->body, verdict->loop));
    for (unsigned i = 0; i < verdict->pragma_count; i++)
        assert(verdict->pragmas[i].text);
    if (verdict->kind == VERDICT_NOT_A_REDUCTION)
        return;
    assert(verdict->facts && verdict->facts->loop == verdict->loop);
    assert(verdict->facts->function == verdict->function);
    if (verdict->kind == VERDICT_REFUSE) {
        assert_reason(unit, &verdict->why);
        return;
    }
    assert(verdict->why.id == REASON_NONE);
    if (verdict->kind == VERDICT_BLOCKS) {
        assert(verdict->facts->variables.blocks);
        assert_counted(&verdict->facts->counted);
        return;
    }
    assert(verdict->kind == VERDICT_TRANSFORM);
    assert(!verdict->function->has_errors && !unit->dialect.refusing_option);
    assert_facts(verdict->facts);
}

void analysis_assert_result(const ir_unit *unit, const analysis_result *result) {
    assert(result->verdict_count == 0 || result->verdicts);
    for (unsigned i = 0; i < result->verdict_count; i++)
        analysis_assert_verdict(unit, &result->verdicts[i]);
    for (unsigned i = 1; i < result->verdict_count; i++) { /* verdicts are in source order, outer
                                                            * loops before inner ones */
        const loop_verdict *before = &result->verdicts[i - 1], *here = &result->verdicts[i];
        assert(before->function != here->function || before->loop->id < here->loop->id);
    }
}

#endif
