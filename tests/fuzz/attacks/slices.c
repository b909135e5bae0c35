/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Statements that the inspector executes to find the subscripts, among statements of the executor.
 * The subscript is computed in one of many ways. Sums, extrema, counts, stores and last values
 * around it use the subscript, its address or its element in calls, operands or conditions. */
#include "fuzz/attacks/attack.h"

/* Statements that compute k, which lies in 0 ... elements - 1, and the expression by which other
 * statements name it. */
static const struct {
    const char *make, *k;
} ways[] = {
    {"int k;\nfind$(s, t, &k);\n", "k"},
    {"int k[2];\nmemcpy(k, &s[t], sizeof k);\n", "k[1]"},
    {"int k[2];\nk[0] = s[t + 1];\nfind$(s, t, k + 1);\nk[1] = s[t];\n", "k[1]"},
    {"struct place$ p;\nfind$(s, t, &p.k);\np.w = s[t + 1];\n", "p.k"},
    {"struct place$ p = {0, s[t]};\nset$(&p, s[t + 2]);\n", "p.k"},
    {"const struct place$ p = made$(s, t);\n", "p.k"},
    {"int k = s[t];\nif (s[t + 1] & 1)\nfind$(s, t + 1, &k);\n", "k"},
    {"int k = s[t];\nfor (int j = 0; j < 2; j++)\nk = s[t + j];\n", "k"},
    {"int k = taken$(s, t);\n", "k"},
    {"int k = s[t];\n(void)look$(&k);\n", "k"},
};

/* Returns an expression of the subscript. */
static const char *value(attack *a, const char *k) {
    static const char *const values[] = {"half$((int)x[%s])", "x[%s] + 1u",
                                         "(unsigned)taken$(s, %s)", "half$(%s) + (unsigned)t"};
    return text(a, values[below(a, 4)], k);
}

static const char *by_address(attack *a, const char *k) {
    return chance(a, 12) ? text(a, "look$(&%s)", k) : value(a, k);
}

/* Appends a statement that only the executor may execute. */
static void put_effect(attack *a, const char *k) {
    static const char *const effects[] = {
        "sum += %s;\n",
        "real += 0.1 * (%s);\n",
        "count += ((%s) & 3) == 1;\n",
        "{\nconst unsigned e = %s;\nif (e > most)\nmost = e;\n}\n",
        "own[t] = own[t] * 3 + (%s);\n",
        "last = %s;\n",
    };
    if (chance(a, 4)) {
        put(a, PART_GLOBALS, "if ((sum += %s) & 1)\ncount++;\n", value(a, k));
        return;
    }
    if (chance(a, 25))
        put(a, PART_GLOBALS, "if (%s & 1)\n", value(a, k));
    put(a, PART_GLOBALS, "%s", text(a, effects[below(a, 6)], by_address(a, k)));
}

static void put_update(attack *a, const char *k) {
    static const char *const updates[] = {"h[%s] += 1;\n", "h[%s] += (unsigned)t;\n",
                                          "if (s[t + 3] & 2)\nh[%s] += 3;\n"};
    if (chance(a, 30))
        put(a, PART_GLOBALS, "h[%s] += %s;\n", k, by_address(a, k));
    else
        put(a, PART_GLOBALS, updates[below(a, 3)], k);
}

static void put_functions(attack *a) {
    put(a, PART_GLOBALS,
        "struct place$ {\nint k, w;\n};\n"
        "static unsigned half$(int v) {\nreturn (unsigned)v / 2u;\n}\n"
        "static void find$(const int *s, int t, int *k) {\n*k = s[t];\n}\n"
        "static int taken$(const int *s, int t) {\nreturn s[t] / 2;\n}\n"
        "static void set$(struct place$ *p, int k) {\np->k = k;\n}\n"
        "static struct place$ made$(const int *s, int t) {\n"
        "const struct place$ p = {s[t], s[t + 1]};\nreturn p;\n}\n"
        "static unsigned look$(const int *k) {\nreturn (unsigned)*k * 5u;\n}\n");
}

static void put_kernel(attack *a, int number) {
    const int way = below(a, (int)(sizeof ways / sizeof *ways));
    put(a, PART_GLOBALS,
        "static double slices$_%d(int n, const int *restrict s, unsigned *restrict h, "
        "unsigned *restrict own, const unsigned *restrict x) {\n"
        "unsigned sum = 7, count = 0, most = 1, last = 5;\ndouble real = 0.5;\n"
        "for (int t = 0; t < n; t++) {\n%s",
        number, ways[way].make);
    for (int i = below(a, 3); i > 0; i--)
        put_effect(a, ways[way].k);
    put_update(a, ways[way].k);
    for (int i = below(a, 3); i > 0; i--)
        put_effect(a, ways[way].k);
    put(a, PART_GLOBALS, "}\nreturn real + sum * 3.0 + count + most * 0.25 + last * 0.125;\n}\n");
    put(a, PART_FINISH,
        "for (int i = 0; i < %d; i++)\n"
        "attack_note(slices$_%d(%d, s$, out$, mine$, values$));\n",
        1 + below(a, 3), number, a->trips);
}

operand slices(attack *a) {
    note(a, "slices");
    put(a, PART_INCLUDES, "#include <string.h>\n");
    put_table(a, "s", a->elements, 0);
    put_functions(a);
    put(a, PART_GLOBALS, "static unsigned out$[%d], mine$[%d], values$[%d];\n", a->elements,
        a->trips + SPARE, a->elements);
    put(a, PART_FINISH,
        "for (int i = 0; i < %d; i++)\nvalues$[i] = (unsigned)i * 2654435761u %% 1000u;\n",
        a->elements);
    for (int i = 0; i < 3; i++)
        put_kernel(a, i);
    put(a, PART_FINISH,
        "for (int i = 0; i < %d; i++)\nattack_note(out$[i]);\n"
        "for (int i = 0; i < %d; i++)\nattack_note(mine$[i]);\n",
        a->elements, a->trips);
    return (operand){"k[t]", true, true, NULL};
}
