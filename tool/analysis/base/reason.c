/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/reason.h"

#include <assert.h>

#include "analysis/base/atomic_call.h"
#include "analysis/base/stateful.h"

typedef struct reason_entry {
    const char *code;
    const char *slug;
    const char *message;
} reason_entry;

static const reason_entry reasons[REASON_COUNT] = {
    {NULL, NULL, NULL},
#define X(identifier, id, slug, message) {id, slug, message},
#include "analysis/base/reasons.def"
#undef X
};

/* Changes of the source that remove each reason. tests/house/check-advice applies them. */
static const char *const advices[REASON_COUNT] = {
    [REASON_ELEMENT_TYPE] = "use subscripts in place of pointers",
    [REASON_UPDATE_VALUE_USED] =
        "split the loop: its other updates, and counting alone, may run in parallel",
    [REASON_UPDATE_IN_EXPRESSION] = "make the update a separate statement",
    [REASON_ARRAY_READ] = "if the old values are meant, read from a copy made before the loop",
    [REASON_ARRAY_STORED] =
        "make the store a separate statement, and move one to a fixed element behind the loop",
    [REASON_BASE_VARIES] =
        "write an update for each array, each under its condition, or set the local pointer "
        "once, to an element of one array",
    [REASON_ROW_POINTERS] =
        "use one contiguous array, double (*a)[m], or a table of pointers made before the loop",
    [REASON_BIT_FIELD] = "use an unsigned char for each of the bit-fields",
    [REASON_INDEX_ARRAY_WRITTEN] = "compute the subscripts in a separate loop first",
    [REASON_INDEX_EXPENSIVE] = "compute the subscripts into an array in a separate loop first",
    [REASON_SIDE_EFFECT] = "move the side effect to a separate statement",
    [REASON_BASE_CONDITIONAL] = "copy it to a local pointer before the loop",
    [REASON_MAY_ALIAS] = "if they never overlap, declare the pointers restrict, or write "
                         "#pragma redcc independent above the loop",
    [REASON_OTHER_STORE] = "split the loop: store in one, accumulate in the other",
    [REASON_SCALAR_CARRIED] = "if its values do not depend on the updates, compute them into an "
                              "array in an earlier loop; if no iteration uses another's value, "
                              "declare it in the body",
    [REASON_PRIVATE_NOT_PROVED] = "if no iteration uses a value that another left in it, declare "
                                  "it inside the loop's body, or "
                                  "write #pragma redcc private(NAME) above the loop",
    [REASON_LAST_VALUE] =
        "make the assignment a statement, or find the last value in a separate loop",
    [REASON_ESCAPES] =
        "if no iteration uses a value that another left in it, declare it inside the "
        "loop's body, and pass it only to functions of this file",
    [REASON_VOLATILE] = "copy it to ordinary memory before the loop, and back after it if the loop "
                        "changes it",
    [REASON_UNION] = "use a struct",
    [REASON_THREAD_LOCAL] = "copy it to a local variable before the loop",
    [REASON_TYPE_PUNNED] = "use a pointer of the array's own type",
    [REASON_ADDRESS_SPACE] = "copy the data to an ordinary array before the loop",
    [REASON_TRIP_COUNT] =
        "find the end in an earlier loop, and write for (i = first; i < last; i++)",
    [REASON_COUNTER_MODIFIED] =
        "use another variable in the body, or list the iterations in an earlier loop",
    [REASON_BOUND_VARIES] = "copy the bound to a local variable before the loop, or count the "
                            "iterations in an earlier loop",
    [REASON_STEP] = "add a constant or a local variable that the loop does not change",
    [REASON_COUNTER_TYPE] = "use a local counter of type int, long or size_t",
    [REASON_COUNTER_WRAPS] = "use a signed counter, and < or > instead of <=, >= or !=",
    [REASON_BREAK] = "find the end in a separate loop first, and count up to it",
    [REASON_RETURN] = "find the end in a separate loop first, and count up to it",
    [REASON_GOTO] = "use structured control",
    [REASON_REGULAR_NEST] = "if iterations of the outer loop write separate rows after "
                            "interchanging the loops, do so and use #pragma omp parallel for",
    [REASON_IMPURE_CALL] = "define it static inline in a header; or, if it has none, and writes "
                           "nothing through its arguments, assert that: --pure=NAME, or #pragma "
                           "redcc pure(NAME)",
    [REASON_FUNCTION_POINTER] = "call a function by its name",
    [REASON_RECURSION] =
        "use a loop in it, or, if it has no side effects, assert that: --pure=NAME",
    [REASON_CALLEE_UPDATES] = "let it return the value, and update in the loop itself",
    [REASON_CALLEE_READS] =
        "if it reads nothing that is updated, declare the pointers restrict, or write #pragma "
        "redcc independent above the loop",
    [REASON_NO_RETURN] = "check in an earlier loop",
    [REASON_SETJMP] = "move the loop to a separate function",
    [REASON_ERRNO] = "check the arguments instead",
    [REASON_INTERPOSED] =
        "make it static, hide it (-fvisibility=hidden), or state that a replacement "
        "is equivalent (-fno-semantic-interposition)",
    [REASON_THREAD_STATE] = "call it before the loop",
    [REASON_UNSEEN_PURE] = "if it returns the same in every thread, assert that: --pure=NAME, or "
                           "#pragma redcc pure(NAME)",
    [REASON_MESSAGE_PASSING] = "exchange messages before the loop or after it",
    [REASON_OPAQUE] = "write it in plain C",
    [REASON_ERRORS] = "correct it, or pass the build's options; split what is nested too deeply",
    [REASON_COUNTER_MACRO] = "name the value before the loop, and use no macros in the loop",
    [REASON_FENV_ACCESS] = "remove the pragma from this file",
    [REASON_NO_RANGE] = "bring the text into the file",
    [REASON_NAME] = "choose another name",
    [REASON_TEXT] =
        "name types outside of the function, give arrays constant lengths, write out macros of "
        "several statements, and move directives and extern declarations out of the function",
    [REASON_COMPILER] = "move the differing text into another file",
    [REASON_SELF_INCLUDED] = "write the repeated part out",
    [REASON_OPTION] = "compile this file without the option",
    [REASON_INEXACT_OPTION] =
        "compile this file without the option, or give up the bits: --order=any",
    [REASON_IN_HEADER] = "move the function to a source file",
    [REASON_IN_MACRO] = "write the loop and its updates out",
    [REASON_DIRECTIVE_IN_RANGE] = "move the directive out of the loop",
    [REASON_BINDING] = "give one of the two another name",
    [REASON_INTERNAL] = "please report this with the source file and the command line",
    [REASON_EXISTING_OPENMP] = "compile without -fopenmp, or remove what is named here",
};

const char *reason_code(reason_id id) {
    assert(id < REASON_COUNT);
    return reasons[id].code;
}

const char *reason_slug(reason_id id) {
    assert(id < REASON_COUNT);
    return reasons[id].slug;
}

reason reason_make(arena *a, reason_id id, const char *name, ir_range range) {
    assert(id > REASON_NONE && id < REASON_COUNT && name);
    reason r = {id, NULL, range, advices[id]};
    /* the format comes from reasons.def and has exactly one %s (a test checks this) */
    const char *format = reasons[id].message;
    const char *hole = strstr(format, "%s");
    if (hole)
        r.message = arena_format(a, "%.*s%s%s", (int)(hole - format), format, name, hole + 2);
    else
        r.message = format;
    return r;
}

const char *reason_advice_on_call(arena *a, const char *name, bool has_body) {
    const char *effect = has_body ? NULL : stateful_effect(name);
    const char *atomic = atomic_advice(name);
    if (atomic)
        return atomic;
    if (!has_body && stateful_is_lock(name))
        return "it is of a lock: if one thread executes the loop, remove the lock; otherwise write "
               "#pragma omp critical in its place, in the loop's own text, and #pragma omp "
               "parallel "
               "for above the loop";
    if (effect)
        return arena_format(a, "it %s: call it in a separate loop, before or after", effect);
    return has_body
               ? "let it write nothing, and store what it returns in the loop; or call it in a "
                 "separate loop before, and store what it returns"
               : advices[REASON_IMPURE_CALL];
}
