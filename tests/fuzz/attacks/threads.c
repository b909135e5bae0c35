/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Values that belong to a thread: errno, thread-local variables, tables that a `const` function
 * returns, and character classes. The caller's values differ from those of a new thread. */
#include "fuzz/attacks/attack.h"

static operand thread_local_variable(attack *a) {
    note(a, "threads/variable");
    put(a, PART_GLOBALS, "%s_Thread_local int own$ = 1;\n", chance(a, 70) ? "static " : "");
    put(a, PART_SETUP, "own$ = %d;\n", 2 + below(a, 90));
    if (chance(a, 50)) {
        put(a, PART_GLOBALS, "static int get$(int t) {\nreturn own$ + t;\n}\n");
        return (operand){text(a, "get$((int)t)"), true, false, NULL};
    }
    return (operand){text(a, "(own$ + (int)t)"), true, false, NULL};
}

static operand table_of_the_thread(attack *a) {
    note(a, "threads/table");
    put(a, PART_SETUP, "attack_set_thread(%d);\n", 1 + below(a, 90));
    may_change(a, "attack_set_thread(%d);", 1 + below(a, 90));
    return (operand){text(a, "(attack_table())[t & 255]"), true, false, NULL};
}

static operand value_of_the_thread(attack *a) {
    note(a, "threads/value");
    put(a, PART_SETUP, "attack_set_thread(%d);\n", 1 + below(a, 90));
    may_change(a, "attack_set_thread(%d);", 1 + below(a, 90));
    if (chance(a, 40))
        return (operand){"(attack_thread_number() + (int)t)", true, false, NULL};
    return (operand){"attack_thread_value((int)t)", true, false, NULL};
}

static operand thread_itself(attack *a) {
    note(a, "threads/self");
    put(a, PART_INCLUDES, "#include <pthread.h>\n");
    put(a, PART_PARAMETERS, ", pthread_t self$");
    put(a, PART_ARGUMENTS, ", pthread_self()");
    return (operand){text(a, chance(a, 50) ? "(pthread_self() == self$)"
                                           : "(pthread_equal(pthread_self(), self$) != 0)"),
                     true, false, NULL};
}

static operand classes(attack *a) {
    note(a, "threads/classes");
    put(a, PART_INCLUDES, "#include <ctype.h>\n#include <locale.h>\n");
    put(a, PART_SETUP, "attack_set_locale();\n");
    put(a, PART_FINISH, "attack_reset_locale();\n");
    static const char *const calls[] = {"isalpha(k[t] & 255)", "isupper(k[t] & 255)",
                                        "isalnum(k[t] * 7 & 255)", "isprint(k[t] * 3 & 255)"};
    return (operand){text(a, "(%s != 0)", one_of(a, 4, calls)), true, false, NULL};
}

static operand read_errno(attack *a) {
    note(a, "threads/errno");
    put(a, PART_INCLUDES, "#include <errno.h>\n");
    put(a, PART_SETUP, "errno = %d;\n", 3 + below(a, 30));
    put(a, PART_FINISH, "errno = 0;\n");
    return (operand){"(errno + (int)t)", true, false, NULL};
}

/* The caller reads errno after the kernel has returned. */
static operand errno_afterwards(attack *a) {
    static const char *const calls[] = {"sqrt(x%s - 0.9)", "log(w[t] * w[t] * (t %% 50 > 0))",
                                        "pow(w[t] * 1e9 + 2, (double)(t %% 60))",
                                        "exp(800.0 * (t %% 64 == 9))"};
    if (!a->flags->keeps_errno || a->flags->is_fast)
        return read_errno(a);
    note(a, "threads/errno-after");
    put(a, PART_INCLUDES, "#include <errno.h>\n#include <math.h>\n");
    put(a, PART_SETUP, "errno = 0;\n");
    put(a, PART_FINISH, "attack_note(errno);\nerrno = 0;\n");
    const char *call = one_of(a, 4, calls);
    put(a, PART_BODY, "double v$ = %s;\nv$ = v$ < 1e6 ? v$ : 3;\n",
        call == calls[0] ? "sqrt(w[t] + 0.95)" : text(a, call));
    return (operand){text(a, "attack_damp(v$)"), false, false, NULL};
}

operand values_of_the_thread(attack *a) {
    switch (below(a, 8)) {
    case 0:
        return thread_local_variable(a);
    case 1:
        return table_of_the_thread(a);
    case 2:
        return value_of_the_thread(a);
    case 3:
        return thread_itself(a);
    case 4:
    case 5:
        return classes(a);
    case 6:
        return read_errno(a);
    default:
        return errno_afterwards(a);
    }
}
