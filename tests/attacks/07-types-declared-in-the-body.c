/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The loop's body declares an enumeration, a tag or a type name that has another meaning outside. The
 * inspector must use the meaning in the body. */
#include <stdio.h>

enum { COUNT = 3000, ROWS = 64 };
enum { SHIFT = 1, OTHER = 2 };

static double h[ROWS];
static int k[COUNT], data[4 * COUNT];

struct pair {
    int second, first;
};

typedef unsigned char narrow;

static void enumerator(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        enum { SHIFT = 5 };
        h[(k[t] + SHIFT) % ROWS] += 0.1 * t;
    }
}

static void enumerator_inside(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int to = k[t] + SHIFT;
        {
            enum { SHIFT = 9 };
            to += SHIFT;
        }
        h[to % ROWS] += 0.1 * SHIFT;
    }
}

static void enumerator_in_a_declaration(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int to = (int)sizeof(enum { SHIFT = 7, LATER }) + SHIFT + LATER;
        h[(k[t] + to) % ROWS] += 0.1;
    }
}

static void tag(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        struct pair {
            int first, second;
        } p = {k[t], t};
        h[p.first] += 0.1 * p.second;
    }
}

static void tag_behind_a_pointer(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        struct pair {
            int first, second;
        };
        const struct pair *p = (const struct pair *)(data + 2 * t);
        h[p->first] += 0.1 * p->second;
    }
}

static void size(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        struct pair {
            int a[5];
        };
        h[(k[t] + (int)(sizeof(struct pair) / sizeof(int))) % ROWS] += 0.1;
    }
}

static void type_name(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        typedef unsigned short narrow;
        narrow to = (narrow)(k[t] * 300);
        h[to % ROWS] += 0.1 * (double)sizeof(narrow);
    }
}

static void anonymous(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        struct {
            int first, second;
        } p = {k[t], t};
        h[p.first] += 0.1 * p.second;
    }
}

static void only_inside(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        struct place {
            int row;
            double weight;
        };
        struct place where = {k[t], 0.25};
        h[where.row] += where.weight;
    }
}

static void in_the_function(int n) {
    struct pair {
        int first, second;
    };
    enum { SHIFT = 11 };
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        struct pair p = {k[t], t};
        h[(p.first + SHIFT) % ROWS] += 0.1 * p.second;
    }
}

static void neighbour(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[(k[t] + SHIFT) % ROWS] += 0.1 * OTHER;
}

int main(void) {
    for (int t = 0; t < COUNT; t++)
        k[t] = t * 7 % ROWS;
    for (int t = 0; t < 4 * COUNT; t++)
        data[t] = t * 11 % ROWS;
    enumerator(COUNT);
    enumerator_inside(COUNT);
    enumerator_in_a_declaration(COUNT);
    tag(COUNT);
    tag_behind_a_pointer(COUNT);
    size(COUNT);
    type_name(COUNT);
    anonymous(COUNT);
    only_inside(COUNT);
    in_the_function(COUNT);
    neighbour(COUNT);
    for (int i = 0; i < ROWS; i++)
        printf("%a\n", h[i]);
    return 0;
}
