/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/imports.h"

#include <string.h>

#include "analysis/memory/exported.h"
#include "ir/ir_adopt.h"
#include "redcc/records.h"
#include "redcc/translate_file.h"

enum { MOST_FILES = 12 };

/* ---- which functions ------------------------------------------------------------------------- */

typedef struct wanted {
    arena *memory;
    bool *is_visited; /* indexed by function */
    string_list names;
    string_list
        headers;    /* for each name, the header that declares it; NULL: the file itself does */
    unsigned loops; /* number of loops around the current node */
} wanted;

static void find_wanted(wanted *w, ir_node *node);

/* Follows the calls of a function that is called in a loop. */
static void follow(wanted *w, const ir_function *function) {
    if (w->is_visited[function->id])
        return;
    w->is_visited[function->id] = true;
    if (function->body) {
        w->loops++;
        find_wanted(w, function->body);
        w->loops--;
    } else if (!function->linkage.is_static && !function->is_from_system &&
               strncmp(function->name, "__builtin_", 10) != 0) {
        VECTOR_PUSH(w->memory, &w->names, function->name);
        VECTOR_PUSH(w->memory, &w->headers, function->declared ? function->declared->file : NULL);
    }
}

static void find_wanted(wanted *w, ir_node *node) {
    const bool is_loop = ir_is_loop(node);
    w->loops += is_loop;
    if (node->kind == IR_FUNCTION && w->loops)
        follow(w, node->function);
    for (unsigned i = 0; i < node->child_count; i++)
        find_wanted(w, node->children[i]);
    w->loops -= is_loop;
}

/* May the loop be refused for a reason that depends on the bodies of the functions it calls? Not if
 * its own text cannot be rewritten, or its own header has no countable iterations, or a function
 * whose body is known is recursive. To parse other files would then take time for nothing. */
static bool may_depend_on_callees(const loop_verdict *verdict) {
    switch (verdict->why.id) {
    case REASON_IN_MACRO:
    case REASON_DIRECTIVE_IN_RANGE:
    case REASON_NO_RANGE:
    case REASON_ERRORS:
    case REASON_OPTION:
    case REASON_SELF_INCLUDED:
    case REASON_IGNORED:
    case REASON_RECURSION:
    case REASON_IN_HEADER: /* all else permits the loop; with the header in place, callees are
                            * asked for again */
        return false;
    case REASON_TRIP_COUNT:
    case REASON_COUNTER_MODIFIED:
    case REASON_BOUND_VARIES:
    case REASON_STEP:
    case REASON_COUNTER_TYPE:
    case REASON_COUNTER_WRAPS:
        return verdict->facts->counted.counter != NULL;
    default:
        return true;
    }
}

/* The outermost loop around this loop. Calls of loops beside it say nothing about the loop. */
static ir_node *outermost_loop(const ir_node *loop) {
    const ir_node *found = loop;
    for (const ir_node *above = loop->parent; above; above = above->parent)
        if (ir_is_loop(above))
            found = above;
    return (ir_node *)found;
}

static wanted wanted_functions(arena *a, const ir_unit *unit, const analysis_result *before) {
    wanted w = {.memory = a, .is_visited = ARENA_ARRAY(a, bool, unit->function_count + 1)};
    for (unsigned i = 0; i < before->verdict_count; i++)
        if (before->verdicts[i].kind == VERDICT_REFUSE &&
            may_depend_on_callees(&before->verdicts[i]))
            find_wanted(&w, outermost_loop(before->verdicts[i].loop));
    return w;
}

/* ---- finding definitions --------------------------------------------------------------------- */

static bool is_plain(const ir_unit *from, const ir_function *function, void *context) {
    return exported_is_plain(context, from, function);
}

static bool same_dialect(const ir_unit *unit, const ir_unit *other) {
    return unit->dialect.strict_aliasing == other->dialect.strict_aliasing &&
           unit->dialect.math_errno == other->dialect.math_errno &&
           unit->dialect.is_sanitized == other->dialect.is_sanitized &&
           unit->dialect.wraps == other->dialect.wraps;
}

static bool adopt_from(arena *a, ir_unit *unit, const char *path, const string_list *flags,
                       const string_list *names) {
    const char *wrong = NULL;
    const source *file = source_read(a, path, &wrong);
    if (!file || memchr(file->text, 0, file->length))
        return false;
    const frontend_result parsed = translate_file_parse(a, file, flags);
    return parsed.unit && parsed.unit->error_count == 0 && same_dialect(unit, parsed.unit) &&
           ir_adopt(unit, parsed.unit, names->count, names->items, is_plain, a) > 0;
}

bool imports_add(arena *a, ir_unit *unit, const project *around, const string_list *flags,
                 const analysis_result *before) {
    map *is_asked = map_new(a), *is_read = map_new(a);
    unsigned files = 0;
    bool is_any = false;
    for (bool is_new = true; is_new && files < MOST_FILES;) {
        const wanted w = wanted_functions(a, unit, before);
        is_new = false;
        for (unsigned i = 0; i < w.names.count && files < MOST_FILES; i++) {
            const char *name = w.names.items[i];
            void **asked = map_at(is_asked, name, strlen(name));
            const char *path = *asked ? NULL : project_definer(around, name, w.headers.items[i]);
            *asked = a;
            void **read = path ? map_at(is_read, path, strlen(path)) : NULL;
            if (!path || *read)
                continue;
            *read = a;
            files++;
            is_new |= adopt_from(a, unit, path, flags, &w.names);
        }
        is_any |= is_new;
    }
    return is_any;
}

/* ---- the comparison -------------------------------------------------------------------------- */

typedef struct calls {
    arena *memory;
    bool *is_noted; /* indexed by function */
    VECTOR(const ir_function *) direct;
} calls;

static bool note_call(ir_node *node, void *context) {
    calls *c = context;
    const ir_function *function = node->function; /* also of a block that replaces a call */
    if (!function || c->is_noted[function->id])
        return true;
    c->is_noted[function->id] = true;
    if (function->linkage.import)
        VECTOR_PUSH(c->memory, &c->direct, function);
    else if (function->body)
        ir_walk(function->body, note_call, c);
    return true;
}

/* Notes the calls of the functions that contain translated loops. Facts about a loop's variables
 * come only from the function around the loop and from that function's callees. */
static void note_calls_of_loops(calls *c, const analysis_result *analysed) {
    for (unsigned i = 0; i < analysed->verdict_count; i++)
        if (analysed->verdicts[i].kind == VERDICT_TRANSFORM)
            ir_walk(analysed->verdicts[i].function->body, note_call, c);
}

/* Is the function declared outside of all functions? */
static bool is_at_file_scope(const ir_unit *unit, const ir_function *function) {
    const ir_declared *declared = function->declared;
    if (!declared || declared->file)
        return declared != NULL;
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *other = unit->functions[i];
        if (other->is_in_main_file && other->body && declared->offset >= other->range.begin &&
            declared->offset < other->body->range.end)
            return false;
    }
    return true;
}

static void write_expectation(const ir_function *function, unsigned *count, buffer *out) {
    const ir_import *import = function->linkage.import;
    const char *slash = strrchr(import->file, '/');
    buffer_format(out, "%s{\"%s\", {0x%xu, 0x%xu}, \"", (*count)++ ? ", " : "", function->name,
                  (unsigned)(import->digest >> 32), (unsigned)import->digest);
    for (const char *letter = slash ? slash + 1 : import->file; *letter; letter++)
        buffer_byte(out, (unsigned char)*letter < ' ' || strchr("\"\\?", *letter) ? '_' : *letter);
    buffer_text(out, "\"}");
}

const char *imports_check(arena *a, const ir_unit *unit, const analysis_result *analysed,
                          const char **obstacle) {
    calls c = {.memory = a, .is_noted = ARENA_ARRAY(a, bool, unit->function_count + 1)};
    buffer records = {0}, called = {0}, expected = {0};
    bool *is_direct = ARENA_ARRAY(a, bool, unit->function_count + 1);
    unsigned count = 0;
    note_calls_of_loops(&c, analysed);
    for (unsigned i = 0; i < c.direct.count; i++) {
        const ir_function *function = c.direct.items[i];
        if (!is_at_file_scope(unit, function) ||
            map_get(unit->text.macros, function->name, strlen(function->name)))
            *obstacle = arena_format(a, "'%s' is declared inside a function, or is a macro as well",
                                     function->name);
        record_declare_weak(&records, "redcc_record",
                            arena_format(a, "redcc__record_%s", function->name), function->name);
        function_declare_weak(&records, arena_format(a, "redcc__called_%s", function->name),
                              function->name);
        buffer_format(&called, "%s{&redcc__record_%s, (redcc_code)redcc__called_%s}", i ? ", " : "",
                      function->name, function->name);
        write_expectation(function, &count, &expected);
        is_direct[function->id] = true;
    }
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_import *import = unit->functions[i]->linkage.import;
        if (import && import->digest && !is_direct[unit->functions[i]->id])
            write_expectation(unit->functions[i], &count, &expected);
    }
    const char *text =
        c.direct.count == 0
            ? NULL
            : arena_format(a,
                           "%s"
                           "/* redcc: are these the functions that were analysed? */\n"
                           "static const redcc_linkage *redcc__linked(void) {\n"
                           "    static const redcc_callee called[] = {%s};\n"
                           "    static const redcc_expectation expected[] = {%s};\n"
                           "    static const redcc_linkage linkage = {called, %u, expected, %u};\n"
                           "    return &linkage;\n"
                           "}\n",
                           records.data, called.data, expected.data, c.direct.count, count);
    buffer_free(&records);
    buffer_free(&called);
    buffer_free(&expected);
    return text;
}
