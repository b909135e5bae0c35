/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Declarations and expressions that occur twice in the generated text of a loop. They must compile,
 * and mean the same. */
#include "fuzz/attacks/attack.h"

/* Texts of the body; each declares an int e$. `other$` is a table of the file. */
static const char *const texts[] = {
    "extern int other$[];\nconst int e$ = other$[t];\n",
    "extern int other$[], more$[];\nconst int e$ = other$[t] + 0 * (int)(more$ == other$);\n",
    "int attack_below(int);\nconst int e$ = other$[t] + 0 * (int)sizeof(&attack_below);\n",
    "__auto_type e$ = other$[t];\n",
    "__typeof__(other$[0]) e$ = other$[t];\n",
    "const int e$ = __extension__({ int v$ = other$[t]; v$ + 1; });\n",
    "const int e$ = ((struct { int a, b; }){other$[t], 1}).a;\n",
    "const int e$ = ((int[]){1, other$[t], 3})[1];\n",
    "const int v$[3] = {[1] = other$[t], [0] = 2};\nconst int e$ = v$[1] + v$[0] + v$[2];\n",
    "_Static_assert(sizeof(int) == 4, \"\");\nconst int e$ = other$[t];\n",
    "const int e$ = _Generic(other$[t], int: other$[t] + 1, default: 0);\n",
    "typedef int word$;\nword$ e$ = (word$)other$[t];\n",
    "enum { one$ = 1, two$ };\nconst int e$ = other$[t + two$] + one$;\n",
    "struct pair$ { int a; short b; } p$ = {other$[t], 4};\nconst int e$ = p$.a + p$.b;\n",
    "union both$ { int i; unsigned char c[4]; } b$ = {other$[t]};\nconst int e$ = b$.c[0];\n",
    "struct { unsigned b : 5, : 0, c : 3; } f$ = {(unsigned)other$[t] & 31, 2};\n"
    "const int e$ = (int)f$.b + (int)f$.c;\n",
    "int e$;\n{\nint t$ = other$[t];\ne$ = t$;\n}\n",
    "int e$ = 0;\nswitch (other$[t] & 3) {\ncase 0:\ne$ = 5;\nbreak;\ncase 1:\ne$ = 6;\ndefault:\n"
    "e$++;\n}\n",
    "int e$ = 0;\nfor (int i$ = 0; i$ < 3; i$++) {\nif (other$[t + i$] & 1)\ncontinue;\ne$ += "
    "i$;\n}\n",
    "int e$ = 0, i$ = 4;\ndo\ne$ += other$[t + i$];\nwhile (--i$);\n",
    "int v$[t % 3 + 1];\nv$[t % 3] = other$[t];\nconst int e$ = v$[t % 3];\n",
    "const int e$ = other$<:t:> + '\\?' + L'a' + 0x1p2 + 1e1;\n",
    "const int e$ = (int)(sizeof \"ab\" \"cd\") + other$[t];\n",
    "const int e$ = other$[t] ?: 7;\n",
    "const int e$ = (other$[t], other$[t + 1]);\n",
    "register int e$ = other$[t];\n",
    "const volatile int v$ = other$[t];\nconst int e$ = v$;\n",
    "int e$ = other$[t];\ne$ <<= 1, e$ ^= 5;\n",
    "int e$ __attribute__((unused, aligned(16))) = other$[t];\n",
    "const int e$ = __builtin_choose_expr(1, other$[t], 1.0);\n",
    "const int e$ = (__func__)[0] + other$[t];\n",
    "const int e$ = __LINE__ * 0 + other$[t];\n",
    "int const *const *const q$ = &(const int *){other$};\nconst int e$ = (*q$)[t];\n",
    "const int e$ = (&other$[t])[-1 + 1];\n",
    "int (*const whole$)[] = &other$;\nconst int e$ = (*whole$)[t];\n",
    "const int e$ = t[other$];\n",
    "_Alignas(32) int e$ = other$[t];\n",
    "struct node$ { struct node$ *next; int v; } a$ = {0, other$[t]}, b$ = {&a$, 1};\n"
    "const int e$ = b$.next->v;\n",
    "int m$[2][2] = {{1, other$[t]}, {2}};\nconst int e$ = m$[0][1] + m$[1][1];\n",
    "_Bool v$ = other$[t];\nconst int e$ = v$ + 1;\n",
    "const int e$ = !!other$[t] + ~other$[t + 1];\n",
    "const int (*const p$)[2] = (const int (*)[2])other$;\nconst int e$ = p$[t / 2][1];\n",
};

operand odd_text(attack *a) {
    note(a, "text");
    put_table(a, "other", a->elements, 0);
    if (chance(a, 50)) {
        const int count = (int)(sizeof texts / sizeof *texts);
        put(a, PART_GLOBALS, "extern int more$[];\nint more$[3];\n");
        put(a, PART_BODY, "%s", text(a, "%s", texts[below(a, count)]));
        return (operand){text(a, "e$"), true, false, NULL};
    }
    /* for the texts about an external object: all its declarations may be repeated */
    if (chance(a, 30))
        put(a, PART_GLOBALS, "extern int tab$[];\n");
    put(a, PART_GLOBALS, "int tab$[%d];\n", a->trips + SPARE);
    put(a, PART_SETUP, "attack_fill_ints(tab$, %d, %d);\n", a->trips + SPARE, a->elements);
    put(a, PART_BODY, "%sextern int tab$[];\n",
        chance(a, 30) ? "extern int attack_below(int);\n" : "");
    return (operand){text(a, "tab$[t]"), true, true, NULL};
}
