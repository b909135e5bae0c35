/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Prints types for the text form. */
#include <string.h>

#include "ir/ir_printer.h"
#include "ir/ir_words.h"

/* ---- types --------------------------------------------------------------------------------- */

static void print_structure(const ir_printer *p, const ir_type *type) {
    switch (type->kind) {
    case IR_POINTER:
        buffer_text(p->out, "ptr(");
        ir_print_type(p, type->target);
        break;
    case IR_ARRAY:
        if (type->count < 0)
            buffer_text(p->out, "array(?,");
        else
            buffer_format(p->out, "array(%lld,", (long long)type->count);
        ir_print_type(p, type->target);
        break;
    case IR_FUNCTION_TYPE:
        buffer_text(p->out, "function(");
        ir_print_type(p, type->target);
        break;
    case IR_RECORD:
        buffer_text(p->out, type->record->is_union ? "union(" : "struct(");
        ir_print_record_key(p, type->record);
        break;
    case IR_OTHER_TYPE:
        buffer_text(p->out, "other(");
        break;
    default: {
        const ir_scalar *scalar = ir_scalar_of(type);
        buffer_text(p->out, scalar != NULL ? scalar->word : "other()");
        return;
    }
    }
    buffer_byte(p->out, ')');
}

static unsigned open_wrapper(const ir_printer *p, bool is_needed, const char *word) {
    if (is_needed)
        buffer_format(p->out, "%s(", word);
    return is_needed;
}

static unsigned open_spelling(const ir_printer *p, const ir_type *type) {
    const char *usual = ir_type_default_spelling(p->scratch, type);
    if (type->spelling == usual)
        return 0;
    if (type->spelling == NULL)
        return open_wrapper(p, true, "unnamed");
    if (usual != NULL && strcmp(type->spelling, usual) == 0)
        return 0;
    buffer_text(p->out, "named(");
    ir_print_quoted(p->out, type->spelling, strlen(type->spelling));
    buffer_byte(p->out, ',');
    return 1;
}

void ir_print_type(const ir_printer *p, const ir_type *type) {
    unsigned open = open_spelling(p, type);
    open += open_wrapper(p, type->is_const, "const");
    open += open_wrapper(p, type->is_volatile, "volatile");
    open += open_wrapper(p, type->is_restrict, "restrict");
    open += open_wrapper(p, type->is_atomic, "atomic");
    if (type->size != ir_type_default_size(type)) {
        buffer_format(p->out, "sized(%lld,", (long long)type->size);
        open++;
    }
    print_structure(p, type);
    while (open-- > 0)
        buffer_byte(p->out, ')');
}
