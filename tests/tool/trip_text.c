/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Prints a C program that compares the trip counts of generated code with loops that are executed.
 *
 * For each type of counter and bound, each comparison and several steps the program has a function
 * with the generated text and one with the loop itself. Both get values near the limits of their
 * types and around zero. The generated text may decline by a count of 0, for which the sequential
 * loop runs. Otherwise it must give the loop's count and last value. For ordinary values it must
 * not decline.
 */
#include <stdio.h>
#include <string.h>

#include "emit/base/loop.h"
#include "emit/call.h"
#include "emit/text/origin.h"
#include "ir/ir.h"

static const struct type_row {
    const char *spelling;
    bool is_signed;
    int64_t size;
} rows[] = {
    {"signed char", true, 1}, {"unsigned char", false, 1},
    {"short", true, 2},       {"unsigned short", false, 2},
    {"int", true, 4},         {"unsigned int", false, 4},
    {"long", true, 8},        {"unsigned long", false, 8},
};

enum { ROW_COUNT = sizeof rows / sizeof *rows };

static const struct form {
    ir_operator comparison;
    const char *text;
    int step;
} forms[] = {
    {IR_OP_LESS, "<", 1},
    {IR_OP_LESS, "<", 2},
    {IR_OP_LESS, "<", 7},
    {IR_OP_LESS_EQUAL, "<=", 1},
    {IR_OP_LESS_EQUAL, "<=", 3},
    {IR_OP_NOT_EQUAL, "!=", 1},
    {IR_OP_GREATER, ">", -1},
    {IR_OP_GREATER, ">", -2},
    {IR_OP_GREATER, ">", -7},
    {IR_OP_GREATER_EQUAL, ">=", -1},
    {IR_OP_GREATER_EQUAL, ">=", -3},
    {IR_OP_NOT_EQUAL, "!=", -1},
};

enum { FORM_COUNT = sizeof forms / sizeof *forms };

static ir_type *type_of(arena *a, const struct type_row *row) {
    ir_type *type = ARENA_NEW(a, ir_type);
    type->kind = IR_INTEGER;
    type->is_signed = row->is_signed;
    type->size = row->size;
    type->spelling = row->spelling;
    return type;
}

static ir_variable *variable_of(arena *a, const char *name, const ir_type *type) {
    ir_variable *variable = ARENA_NEW(a, ir_variable);
    variable->name = name;
    variable->type = type;
    return variable;
}

static ir_node *node_of(arena *a, ir_variable *variable) {
    ir_node *node = ir_new(a, IR_VARIABLE, variable->type, 0);
    node->variable = variable;
    return node;
}

static ir_node *zero(arena *a, const ir_type *type) {
    ir_node *node = ir_new(a, IR_NUMBER, type, 0);
    node->text = "0";
    node->flags = IR_HAS_VALUE;
    return node;
}

static const char *plain(arena *a, const char *marked) {
    return origin_unmark(a, marked, strlen(marked), false, NULL);
}

static void print_generated(arena *a, unsigned number, const struct type_row *counter,
                            const struct type_row *bound, const struct form *form, bool from_zero) {
    static const struct type_row plain_int = {"int", true, 4};
    ir_variable *t = variable_of(a, "t", type_of(a, counter));
    loop_facts facts = {.loop = ir_new(a, IR_FOR, NULL, 0), .counter_is_live_after = true};
    facts.counted = (counted_loop){
        .counter = t,
        .lower = from_zero ? zero(a, type_of(a, &plain_int))
                           : node_of(a, variable_of(a, "from", type_of(a, counter))),
        .bound = node_of(a, variable_of(a, "to", type_of(a, bound))),
        .comparison = form->comparison,
        .step = form->step,
    };
    const loop_plan plan = {.facts = &facts};
    loop_text loop = {
        .arena = a, .facts = &facts, .plan = &plan, .counter_type = counter->spelling};
    writer out = {.depth = 1};
    const char *entry = plain(a, write_trip_count(&loop, &out, "site"));
    printf("static redcc_int generated_%u(%s from, %s to, redcc_int *last) {\n", number,
           counter->spelling, bound->spelling);
    printf("%s    (void)from;\n    *last = redcc__final;\n    return %s ? redcc__trip : 0;\n}\n",
           plain(a, writer_text(a, &out)), entry);
    if (loop.obstacle)
        printf("#error %s\n", loop.obstacle);
}

static void print_loop(unsigned number, const struct type_row *counter,
                       const struct type_row *bound, const struct form *form) {
    printf("static redcc_int run_%u(%s from, %s to, redcc_int *last) {\n", number,
           counter->spelling, bound->spelling);
    printf("    redcc_int count = 0;\n    %s t;\n", counter->spelling);
    printf("    for (t = from; t %s to; t = (%s)(t + %d))\n        if (++count > LONGEST)\n"
           "            return -1;\n    *last = (redcc_int)t;\n    return count;\n}\n",
           form->text, counter->spelling, form->step);
}

static void print_check(unsigned number, const struct type_row *counter,
                        const struct type_row *bound, const struct form *form, bool from_zero) {
    printf("static void check_%u(void) {\n"
           "    unsigned i, k;\n"
           "    for (i = 0; i < VALUES; i++)\n"
           "        for (k = 0; k < VALUES; k++) {\n"
           "            redcc_int last = 0, loop_last = 0, count, loop_count;\n"
           "            const %s from = %s;\n"
           "            const %s to = (%s)value(k, %d, sizeof(%s));\n",
           number, counter->spelling, from_zero ? "0" : "0", bound->spelling, bound->spelling,
           bound->is_signed, bound->spelling);
    if (!from_zero)
        printf("            const %s start = (%s)value(i, %d, sizeof(%s));\n", counter->spelling,
               counter->spelling, counter->is_signed, counter->spelling);
    const char *start = from_zero ? "from" : "start";
    printf(
        "            (void)from;\n"
        "            count = generated_%u(%s, to, &last);\n"
        "            loop_count = run_%u(%s, to, &loop_last);\n"
        "            compare(\"%s t %s %s, step %d%s\", %d, (redcc_int)%s, (redcc_int)to, count, "
        "last, loop_count, loop_last);\n"
        "        }\n}\n",
        number, start, number, start, counter->spelling, form->text, bound->spelling, form->step,
        from_zero ? " from 0" : "", form->step < 0 ? -form->step : form->step, start);
}

static const char head[] =
    "#include <stdio.h>\n"
    "#include <redcc/runtime.h>\n"
    "#undef REDCC_IS_WORTH\n"
    "#define REDCC_IS_WORTH(redcc_site, redcc_trip) ((redcc_trip) > 0)\n"
    "enum { LONGEST = 300 };\n"
    "static unsigned long compared, declined, wrong;\n"
    "/* around zero and around both ends of a type */\n"
    "static redcc_word value(unsigned number, int is_signed, unsigned long size) {\n"
    "    const redcc_word bits = 8 * size, one = 1;\n"
    "    const redcc_word top = is_signed ? (one << (bits - 1)) - 1 : (one << (bits - 1)) * 2 - "
    "1;\n"
    "    static const int small[] = {0, 1, 2, 3, 5, 20, 100, -1, -2, -7, -100};\n"
    "    if (number < 11) return (redcc_word)small[number];\n"
    "    if (number < 14) return top - (number - 11);\n"
    "    if (number < 17) return top + 1 + (number - 14);\n"
    "    return (one << (bits - 1)) - 2 + (number - 17);\n"
    "}\n"
    "enum { VALUES = 21 };\n"
    "static int is_plain(redcc_int v) { return v >= 0 && v <= 100; }\n"
    "static void compare(const char *what, redcc_int stride, redcc_int from, redcc_int to, "
    "redcc_int count,\n"
    "                    redcc_int last, redcc_int loop_count, redcc_int loop_last) {\n"
    "    int bad = 0;\n"
    "    compared++;\n"
    "    if (count > 0 && loop_count >= 0) bad = count != loop_count || last != loop_last;\n"
    "    else if (count > 0) bad = count <= LONGEST;\n"
    "    else if (loop_count > 0) {\n"
    "        declined++;\n"
    "        bad = is_plain(from) && is_plain(to) && is_plain(loop_last) && "
    "loop_count * stride <= 100 + stride; /* it did not wrap */\n"
    "    }\n"
    "    if (bad && wrong++ < 20)\n"
    "        printf(\"%s from %lld to %lld: generated %lld, last %lld; loop %lld, last %lld\\n\", "
    "what,\n"
    "               from, to, count, last, loop_count, loop_last);\n"
    "}\n";

int main(void) {
    arena *a = arena_new();
    unsigned number = 0;
    fputs(head, stdout);
    for (int c = 0; c < ROW_COUNT; c++)
        for (int b = 0; b < ROW_COUNT; b++)
            for (int f = 0; f < FORM_COUNT; f++)
                for (int from_zero = 0; from_zero < 2; from_zero++, number++) {
                    print_generated(a, number, &rows[c], &rows[b], &forms[f], from_zero);
                    print_loop(number, &rows[c], &rows[b], &forms[f]);
                    print_check(number, &rows[c], &rows[b], &forms[f], from_zero);
                }
    printf("int main(void) {\n");
    for (unsigned i = 0; i < number; i++)
        printf("    check_%u();\n", i);
    printf(
        "    printf(\"%%lu compared, %%lu left to the sequential loop, %%lu wrong\\n\", compared, "
        "declined, wrong);\n    return wrong != 0 || compared == 0;\n}\n");
    arena_free(a);
    return 0;
}
