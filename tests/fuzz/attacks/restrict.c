/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* restrict pointers that promise nothing about other iterations, and pointers into h that are hard
 * to recognise. */
#include "fuzz/attacks/attack.h"

static operand in_body(attack *a) {
    note(a, "restrict/in-body");
    static const char *const forms[] = {
        "const %s *restrict r$ = attack_same(h);\n",
        "const %s *restrict r$ = h;\n",
        "const %s *const restrict r$ = x;\n",
        "const %s *restrict r$ = (const void *)(unsigned long)h;\n",
        "struct { const %s *restrict p; } s$ = {attack_same(h)};\nconst void *r0$ = s$.p;\n",
    };
    const int form = below(a, 5);
    put(a, PART_BODY, "%s", text(a, forms[form], a->element));
    /* The promise holds within an iteration: it does not write what it reads through r. */
    const char *base = form == 4 ? "s$.p" : "r$";
    put(a, PART_BODY, "const int i$ = (k[t] + %d) %% %d;\n", 1 + below(a, a->elements - 1),
        a->elements);
    if (form == 2)
        return (operand){text(a, "%s[t]", text(a, base)), !a->is_floating, false,
                         text(a, "((unsigned long)(x + t) != (unsigned long)(h + k[t]))")};
    return (operand){text(a, "%s[i$]", text(a, base)), !a->is_floating, false, NULL};
}

static operand of_function(attack *a) {
    note(a, "restrict/of-function");
    put(a, PART_GLOBALS, "static %s get$(const %s *restrict a, int i) {\nreturn a[i];\n}\n",
        a->element, a->element);
    return (operand){text(a, "get$(%s, (int)t)", chance(a, 70) ? "x" : "h"), !a->is_floating, false,
                     NULL};
}

/* Pointers derived from h, which a restrict parameter would permit as well. */
static operand derived(attack *a) {
    note(a, "restrict/derived");
    const char *from = text(a, "h + %d", below(a, a->trips / 2));
    static const char *const forms[] = {
        "const %s *d$ = %s;\n",
        "const %s *d$ = attack_same(%s);\n",
        "const %s *d$ = (const void *)(unsigned long)(%s);\n",
        "const %s *d$;\n{\nconst void *r$ = %s;\nmemcpy(&d$, &r$, sizeof d$);\n}\n",
        ("union { unsigned long u; const %s *p; } u$ = {.u = (unsigned long)(%s)};\n"
         "const void *r$ = u$.p;\n"),
    };
    const int form = below(a, 5);
    put(a, PART_BEFORE, "%s", text(a, forms[form], a->element, from));
    return (operand){text(a, form == 4 ? "u$.p[t]" : "d$[t]"), !a->is_floating, false, NULL};
}

operand block_restrict(attack *a) {
    switch (below(a, 4)) {
    case 0:
        return of_function(a);
    case 1:
        return derived(a);
    default:
        return in_body(a);
    }
}
