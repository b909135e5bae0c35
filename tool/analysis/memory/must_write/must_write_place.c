/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/must_write/must_write_run.h"

static const place elsewhere = {PLACE_ELSEWHERE, false, 0, 0, 0, NULL};

/* Is the variable a local integer, _Bool or pointer that changes only by name, so that its value
 * can be tracked? */
static bool is_followed(const run *r, const ir_variable *variable) {
    const ir_type *type = variable->type;
    return (variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER) &&
           variable->function == r->function && !variable->address_taken && !type->is_volatile &&
           !type->is_atomic &&
           (type->kind == IR_INTEGER || type->kind == IR_BOOLEAN || type->kind == IR_POINTER);
}

place run_variable_place(const run *r, const ir_variable *variable) {
    place p = elsewhere;
    if (is_followed(r, variable)) {
        p.kind = PLACE_LOCAL;
        p.variable = variable;
    }
    if (variable == r->object) {
        p.kind = PLACE_OBJECT;
        p.is_exact = true;
        p.end = r->size;
    }
    return p;
}

static place pointed_place(run *r, const ir_node *node, value pointer) {
    place p = {PLACE_OBJECT, pointer.is_exact, pointer.number, 0, r->size, NULL};
    if (pointer.kind != VALUE_POINTER)
        return elsewhere;
    if (!p.is_exact && r->is_open)
        run_give_up(r, node, "its elements are reached by subscripts that are not constant");
    return p;
}

static place locate_index(run *r, state *s, const ir_node *node) {
    const ir_node *array = node->children[0];
    unsequenced u = run_begin_unsequenced(r, s, node, node->children, 2);
    place p;
    if (array->type->kind == IR_ARRAY)
        p = run_locate(r, s, array);
    else
        p = pointed_place(r, node, run_evaluate(r, s, array));
    run_next_unsequenced(&u, s);
    const value subscript = run_evaluate(r, s, node->children[1]);
    run_end_unsequenced(&u, s);
    p.variable = NULL;
    if (p.kind != PLACE_OBJECT)
        return elsewhere;
    const value base = {VALUE_POINTER, p.is_exact, p.offset};
    const value moved = value_move(base, subscript, node->type->size, false);
    p.is_exact = moved.is_exact;
    p.offset = moved.number;
    if (!p.is_exact && r->is_open && p.end == r->size)
        run_give_up(r, node, "its elements are reached by subscripts that are not constant");
    return p;
}

static place locate_member(run *r, state *s, const ir_node *node) {
    const bool is_arrow = (node->flags & IR_ARROW) != 0;
    place p = is_arrow ? pointed_place(r, node, run_evaluate(r, s, node->children[0]))
                       : run_locate(r, s, node->children[0]);
    p.variable = NULL;
    if (p.kind != PLACE_OBJECT)
        return elsewhere;
    if (node->field == NULL || node->field->is_bit_field || node->field->offset < 0) {
        run_give_up(r, node, "it has bit-fields");
        return elsewhere;
    }
    if (p.is_exact) {
        p.offset += node->field->offset;
        p.begin = p.offset;
        p.end = node->type->size >= 0 ? p.offset + node->type->size : r->size;
    }
    return p;
}

place run_locate(run *r, state *s, const ir_node *node) {
    place p = elsewhere;
    if (!run_step(r, node, 1))
        return elsewhere;
    switch (node->kind) {
    case IR_VARIABLE:
        return run_variable_place(r, node->variable);
    case IR_INDEX:
        return locate_index(r, s, node);
    case IR_MEMBER:
        return locate_member(r, s, node);
    case IR_UNARY:
        if (node->op == IR_OP_DEREFERENCE)
            return pointed_place(r, node, run_evaluate(r, s, node->children[0]));
        if (node->op == IR_OP_REAL || node->op == IR_OP_IMAG) {
            p = run_locate(r, s, node->children[0]); /* half of a complex number; which half does
                                                      * not matter here */
            p.variable = NULL;
            if (p.is_exact && node->children[0]->type->size >= 0) {
                p.begin = p.offset;
                p.end = p.offset + node->children[0]->type->size;
            }
            p.is_exact = false;
            return p;
        }
        break;
    default:
        break;
    }
    run_evaluate_closed(r, s, node);
    return elsewhere;
}

static bool check_bounds(run *r, const ir_node *node, const place *p, const ir_type *type) {
    const int64_t begin = p->is_exact ? p->offset : p->begin;
    const int64_t end = p->is_exact ? p->offset + type->size : p->end;
    if (r->unknown != NULL)
        return false;
    if (type->size >= 0 && begin >= 0 && begin <= end && end <= r->size)
        return true;
    run_give_up(r, node,
                r->is_open ? "more than a small object behind the pointer is accessed"
                           : "it is accessed outside its bounds");
    return false;
}

value run_load(run *r, state *s, const ir_node *node, const place *p) {
    const ir_type *type = node->type;
    if (type->kind == IR_ARRAY && p->kind == PLACE_OBJECT) {
        const value decayed = {VALUE_POINTER, p->is_exact, p->is_exact ? p->offset : 0};
        return decayed;
    }
    if (p->kind == PLACE_OBJECT && check_bounds(r, node, p, type)) {
        const int64_t begin = p->is_exact ? p->offset : p->begin;
        const int64_t end = p->is_exact ? p->offset + type->size : p->end;
        if (!byte_set_has(s->written, begin, end) && run_repeats_write(r, node)) {
            run_step(r, node, 64);
        } else if (!p->is_exact || type->kind != IR_RECORD) {
            run_read(r, s, node, begin, end);
        } else if (run_step(r, node, 1 + (unsigned)((r->size + type->size) / 4))) {
            byte_set bytes = byte_set_new(r->prover->scratch, r->size);
            byte_set_add_value(bytes, type, p->offset);
            run_read_set(r, s, node, bytes);
        }
    }
    if (p->variable != NULL)
        return state_get(s, p->variable);
    return value_other;
}

value run_store(run *r, state *s, const ir_node *target, const place *p, value v) {
    const ir_type *type = target->type;
    v = run_convert(r, target, v, type);
    if (v.kind == VALUE_POINTER && p->variable == NULL)
        return run_give_up(r, target, "its address is stored");
    if (p->kind == PLACE_OBJECT && check_bounds(r, target, p, type)) {
        if (p->is_exact)
            run_write(r, s, target, p->offset, p->offset + type->size, true);
        else
            run_write(r, s, target, p->begin, p->end, false);
    }
    if (p->variable != NULL)
        state_set(r->prover->scratch, s, p->variable, v);
    return v;
}
