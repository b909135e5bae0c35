/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The loop assigns a variable. After the loop, or around it, statements of all kinds may read the
 * variable or write it first. The statements are in a function of their own, and the loop is at a
 * random place among them. */
#include "fuzz/attacks/attack.h"

enum { DEEPEST = 4 };

/* The statements around a statement. */
typedef struct place {
    int depth;
    bool is_in_loop, is_in_switch;
} place;

static void put_statement(attack *a, place p, bool holds_loop);

static place inside(place p) {
    p.depth++;
    return p;
}

/* A condition whose value no compiler knows. */
#define CHOICE "(c[at++ & 63] & 1)"

/* The loop: x is assigned in each iteration or in some, or is a counter. */
static void put_loop(attack *a) {
    static const char *const loops[] = {
        "for (int t = 0; t < n; t++) {\nx = s[t] & 7;\nh[s[t]] += x;\n}\n",
        "for (int t = 0; t < n; t++) {\nif (s[t] & 1)\ncontinue;\nx = s[t];\nh[x] += 1;\n}\n",
        "for (int t = 0; t < n; t++) {\nif (s[t] %% 3 == 0)\nx = s[t];\nh[s[t]] += 1;\n}\n",
        "for (x = 0; x < (unsigned)n; x++)\nh[s[x]] += 1;\n",
        "for (int t = 0; t < n; t++)\nfor (x = 0; x < 3; x++)\nh[s[t + x]] += x;\n",
    };
    put(a, PART_GLOBALS, "%s", text(a, loops[below(a, 5)]));
}

static void put_plain(attack *a) {
    static const char *const statements[] = {
        "x = 1;\n",
        "x = y + 2;\n",
        "x = 4;\n",
        "y = y * 3 + x;\n",
        "y += " CHOICE " && (x = 2, 1);\n",
        "y += " CHOICE " || (x = 5);\n",
        "y += " CHOICE " ? (x = 3) : 1;\n",
        "y += " CHOICE " ? (x = 6) : x;\n",
        "x = y, y += x;\n",
        "x += 1;\n",
        "{\nunsigned v = x;\ny += v;\n}\n",
        "y += (x = 7) + " CHOICE ";\n",
        "(void)__builtin_constant_p(x = 1);\n",
        "y += (unsigned)sizeof(x = 1);\n",
    };
    put(a, PART_GLOBALS, "%s", text(a, "%s", statements[below(a, 14)]));
}

static void put_jump(attack *a, place p) {
    if (chance(a, 60))
        put(a, PART_GLOBALS, "if " CHOICE "\n");
    if (p.is_in_loop && chance(a, 50))
        put(a, PART_GLOBALS, "continue;\n");
    else if (p.is_in_loop || p.is_in_switch)
        put(a, PART_GLOBALS, "break;\n");
    else
        put(a, PART_GLOBALS, "return y;\n");
}

/* Appends some statements; if `holds_loop`, the loop is one of them. */
static void put_block(attack *a, place p, bool holds_loop) {
    const int count = 1 + below(a, 3), at = holds_loop ? below(a, count) : count;
    put(a, PART_GLOBALS, "{\n");
    for (int i = 0; i < count; i++)
        put_statement(a, inside(p), i == at);
    put(a, PART_GLOBALS, "}\n");
}

static void put_loop_around(attack *a, place p, bool holds_loop) {
    static const char *const heads[] = {
        "for (int i$_%d = 0; i$_%d < 2; i$_%d++)\n",
        "for (int i$_%d = 0; i$_%d < 3 && " CHOICE "; x = 9, i$_%d++)\n",
        "for (unsigned i$_%d = x & 1; i$_%d < 2; i$_%d++)\n",
    };
    const int d = p.depth, form = below(a, 5);
    const place body = {.depth = d, .is_in_loop = true};
    if (form < 3) {
        put(a, PART_GLOBALS, heads[form], d, d, d);
        put_block(a, body, holds_loop);
        return;
    }
    put(a, PART_GLOBALS, "int w$_%d = 0;\n", d);
    put(a, PART_GLOBALS, form == 3 ? "while (w$_%d++ < 2)\n" : "do\n", d);
    put_block(a, body, holds_loop);
    if (form == 4)
        put(a, PART_GLOBALS, "while (w$_%d++ < 1%s);\n", d, chance(a, 30) ? " && x" : "");
}

static void put_switch(attack *a, place p, bool holds_loop) {
    const int at = holds_loop ? below(a, 3) : 3;
    p.is_in_switch = true;
    put(a, PART_GLOBALS, "switch (c[at++ & 63]) {\n");
    for (int i = 0; i < 3; i++) {
        put(a, PART_GLOBALS, i == 2 && chance(a, 50) ? "default:\n" : "case %d:\n", i);
        put_statement(a, inside(p), i == at);
        put_plain(a);
        if (chance(a, 60))
            put(a, PART_GLOBALS, "break;\n");
    }
    put(a, PART_GLOBALS, "}\n");
}

static void put_statement(attack *a, place p, bool holds_loop) {
    const int kind = p.depth < DEEPEST ? below(a, holds_loop ? 7 : 10) : 10;
    if (kind < 2) {
        put(a, PART_GLOBALS, "if " CHOICE "\n");
        put_block(a, p, holds_loop);
        if (chance(a, 50)) {
            put(a, PART_GLOBALS, "else\n");
            put_block(a, p, false);
        }
    } else if (kind < 4) {
        put(a, PART_GLOBALS, "{\n");
        put_loop_around(a, inside(p), holds_loop);
        put(a, PART_GLOBALS, "}\n");
    } else if (kind == 4) {
        put_switch(a, p, holds_loop);
    } else if (holds_loop) {
        put_loop(a);
    } else if (kind == 5) {
        put_jump(a, p);
    } else {
        put_plain(a);
    }
}

operand behind_the_loop(attack *a) {
    note(a, "behind");
    put_table(a, "s", a->elements, 0);
    put_table(a, "c", 3, 0);
    put(a, PART_GLOBALS,
        "static unsigned out$[%d];\n"
        "static unsigned behind$(unsigned at, const int *c, int n, const int *s, unsigned *h) {\n"
        "unsigned x = 7, y = 0;\n",
        a->elements);
    for (int i = below(a, 2); i > 0; i--)
        put_statement(a, (place){.depth = 1}, false);
    put_statement(a, (place){0}, true);
    for (int i = 1 + below(a, 3); i > 0; i--)
        put_statement(a, (place){.depth = 1}, false);
    put(a, PART_GLOBALS, "return y%s;\n}\n", chance(a, 30) ? " * 31 + x" : "");
    put(a, PART_FINISH,
        "for (int i = 0; i < %d; i++)\n"
        "attack_note(behind$((unsigned)i, c$, %d, s$, out$));\n"
        "for (int i = 0; i < %d; i++)\nattack_note(out$[i]);\n",
        2 + below(a, 4), a->trips, a->elements);
    return (operand){"k[t]", true, true, NULL};
}
