/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/records.h"

#include <string.h>

#include "analysis/base/loop_text.h"
#include "analysis/memory/exported.h"
#include "ir/ir_digest.h"

/* Does a macro replace a word of the text to be appended? */
static bool has_macro_of_words(const ir_unit *unit) {
    static const char *const words[] = {"static", "const",    "struct", "void",
                                        "char",   "unsigned", "extern", "long"};
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        if (unit->text.macros && map_get(unit->text.macros, words[i], strlen(words[i])))
            return true;
    return false;
}

typedef struct recorder {
    arena *memory;
    const ir_unit *unit;
    const project *around;
} recorder;

typedef struct callees {
    arena *memory;
    bool *is_noted; /* indexed by function */
    const ir_unit *unit;
    VECTOR(const ir_function *) found;
    bool has_directive; /* a static function that the definition calls has an OpenMP directive */
} callees;

static bool note_callee(ir_node *node, void *context) {
    callees *c = context;
    const ir_function *f = node->kind == IR_FUNCTION ? node->function : NULL;
    if (!f || c->is_noted[f->id])
        return true;
    c->is_noted[f->id] = true;
    if (f->linkage.is_static && f->body) {
        c->has_directive |= text_openmp_in(c->memory, c->unit, f) != NULL;
        ir_walk(f->body, note_callee, c);
    } else if (!f->is_from_system && strncmp(f->name, "__builtin_", 10) != 0) {
        VECTOR_PUSH(c->memory, &c->found, f);
    }
    return true;
}

static bool can_be_named(const ir_unit *unit, const ir_function *f) {
    return f->declared && !f->linkage.is_renamed &&
           !map_get(unit->text.macros, f->name, strlen(f->name));
}

/* Is the function without a record? True for an inline definition, and if no known source defines
 * the function. The program may lack such a function, because the compiler may remove all its
 * calls. */
static bool is_unrecorded(const recorder *r, const ir_function *f) {
    return f->body ? !exported_is_plain(r->memory, r->unit, f)
                   : !project_definer(r->around, f->name, NULL);
}

/* Is the function declared inside another function? If so, it cannot be named at the file's end,
 * and its callers get no records. */
static bool declares_in_block(const ir_unit *unit, const ir_function *f) {
    for (unsigned i = 0; !f->declared->file && i < unit->function_count; i++) {
        const ir_function *other = unit->functions[i];
        if (other->is_in_main_file && other->body &&
            f->declared->offset >= other->body->range.begin &&
            f->declared->offset < other->body->range.end)
            return true;
    }
    return false;
}

void record_declare_weak(buffer *out, const char *type, const char *as, const char *function) {
    if (as)
        buffer_format(out, "extern const %s %s __asm__(\"redcc_record_%s\")", type, as, function);
    else
        buffer_format(out, "extern const %s redcc_record_%s", type, function);
    buffer_text(out, " __attribute__((__weak__));\n");
}

void function_declare_weak(buffer *out, const char *as, const char *function) {
    buffer_format(out, "static __typeof__(%s) %s __attribute__((__weakref__(\"%s\")));\n", function,
                  as, function);
}

static void write_callees(const char *name, const callees *c, buffer *out) {
    for (unsigned i = 0; i < c->found.count; i++) {
        const char *callee = c->found.items[i]->name;
        record_declare_weak(out, "struct redcc__record", NULL, callee);
        if (!c->found.items[i]->body)
            function_declare_weak(out, arena_format(c->memory, "redcc__callee%u_%s", i, name),
                                  callee);
    }
    if (c->found.count)
        buffer_format(out, "static const struct redcc__callee redcc__callees_%s[] = {", name);
    for (unsigned i = 0; i < c->found.count; i++) {
        const ir_function *callee = c->found.items[i];
        buffer_format(out, "%s{&redcc_record_%s, (void (*)(void))", i ? ", " : "", callee->name);
        if (callee->body)
            buffer_format(out, "%s}", callee->name);
        else
            buffer_format(out, "redcc__callee%u_%s}", i, name);
    }
    if (c->found.count)
        buffer_text(out, "};\n");
}

static void write_record(const recorder *r, const ir_function *f, buffer *out) {
    const ir_unit *unit = r->unit;
    callees c = {.memory = r->memory,
                 .unit = unit,
                 .is_noted = ARENA_ARRAY(r->memory, bool, unit->function_count + 1)};
    c.is_noted[f->id] = true;
    ir_walk(f->body, note_callee, &c);
    if (c.has_directive)
        return;
    for (unsigned i = 0; i < c.found.count; i++)
        if (!can_be_named(unit, c.found.items[i]) || declares_in_block(unit, c.found.items[i]) ||
            is_unrecorded(r, c.found.items[i]))
            return;
    const uint64_t of = ir_digest(unit, f);
    const char *name = f->name;
    buffer_format(out, "static __typeof__(%s) redcc__own_%s __attribute__((__alias__(\"%s\")));\n",
                  name, name, name);
    write_callees(name, &c, out);
    buffer_format(out,
                  "extern const struct redcc__record redcc_record_%s;\n"
                  "const struct redcc__record redcc_record_%s __attribute__((__weak__, "
                  "__section__(\".data.rel.ro.redcc.%s\"))) = {\"%s\", {0x%xu, 0x%xu}, "
                  "(void (*)(void))redcc__own_%s, %u, %s%s};\n",
                  name, name, name, name, (unsigned)(of >> 32), (unsigned)of, name, c.found.count,
                  c.found.count ? "redcc__callees_" : "0", c.found.count ? name : "");
}

const char *records_write(arena *a, const ir_unit *unit, const project *around) {
    const recorder r = {a, unit, around};
    buffer out = {0};
    if (has_macro_of_words(unit) || strstr(unit->source->text, "redcc__"))
        return NULL;
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *f = unit->functions[i];
        if (exported_is_plain(a, unit, f) && can_be_named(unit, f) &&
            project_calls_in_loop(around, f->name))
            write_record(&r, f, &out);
    }
    const char *text =
        out.length == 0
            ? NULL
            : arena_format(a,
                           "\n/* redcc: functions that loops of other files may call */\n"
                           "struct redcc__callee;\n"
                           "struct redcc__record { const char *name; unsigned digest[2]; "
                           "void (*own)(void); __SIZE_TYPE__ callee_count; "
                           "const struct redcc__callee *callees; };\n"
                           "struct redcc__callee { const struct redcc__record *record; "
                           "void (*called)(void); };\n%s",
                           out.data);
    buffer_free(&out);
    return text;
}
