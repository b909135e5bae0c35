/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "variables.h"

#include "base/system.h"
#include "spelling.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* glibc's reserved name for `environ`, because the program may define `environ` itself. */
extern char **__environ __attribute__((__weak__));

static const char *const names[] = {
#define REDCC_VARIABLE(name) name,
    REDCC_VARIABLE_LIST(REDCC_VARIABLE)
#undef REDCC_VARIABLE
    /* Variables that only redcc and redcc-cc read (tool/driver). They may still be set when the
     * program runs. */
    "REDCC_BUILD_REPORT",
    "REDCC_CACHE",
    "REDCC_CACHE_SIZE",
    "REDCC_CC",
    "REDCC_CC_DEPTH",
    "REDCC_DISABLE",
    "REDCC_KEEP",
    "REDCC_OPTS",
    "REDCC_ROOT",
    "REDCC_STRICT"};

#define REDCC_VARIABLE(name) +1
enum {
    NAMES = sizeof names / sizeof *names,
    OF_RUN = 0 REDCC_VARIABLE_LIST(REDCC_VARIABLE), /* number of variables that a translated program
                                                       reads; these are the first in names[] */
    ALIKE = 3 /* a name that differs from a build variable in fewer letters than this is taken for a
                 misspelling of it */
};
#undef REDCC_VARIABLE

/* Ignores the environment if the program has more rights than its caller (setuid), who must not
 * control where the program writes. */
const char *redcc_environment(const char *name) {
    return redcc_system_is_privileged() ? NULL : getenv(name);
}

static bool is_ours(const char *variable) {
    return strncmp(variable, "REDCC_", 6) == 0;
}

/* Is this a build variable such as "REDCC_CACHE=off"? A shell may export such variables for
 * building and running alike. */
static bool is_of_build(const char *variable) {
    const size_t length = strcspn(variable, "=");
    for (size_t n = OF_RUN; n < NAMES; n++)
        if (strlen(names[n]) == length && strncmp(variable, names[n], length) == 0)
            return true;
    return false;
}

bool redcc_any_variable(void) {
    if (!&__environ || !__environ)
        return true;
    for (char *const *each = __environ; *each; each++)
        if (is_ours(*each) && !is_of_build(*each))
            return true;
    return false;
}

/* Reports an unknown variable, unless it may be a misspelt build variable. Building reports
 * those. */
static void note_if_unknown(const char *name) {
    const size_t nearest = redcc_spelling_nearest(name, names, NAMES);
    const size_t distance = redcc_spelling_distance(name, names[nearest]);
    if (distance == 0 || (nearest >= OF_RUN && distance < ALIKE))
        return;
    fprintf(stderr,
            "redcc: the variable %s is not known, and is ignored; the nearest known is %s\n", name,
            names[redcc_spelling_nearest(name, names, OF_RUN)]);
}

void redcc_note_unknown_variables(void) {
    if (!&__environ || !__environ || redcc_system_is_privileged())
        return;
    for (char *const *each = __environ; *each; each++) {
        char name[64];
        const size_t length = strcspn(*each, "=");
        if (!is_ours(*each) || length >= sizeof name)
            continue;
        memcpy(name, *each, length);
        name[length] = '\0';
        note_if_unknown(name);
    }
}
