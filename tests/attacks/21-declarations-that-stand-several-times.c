/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The body's text occurs several times in one function. Some declarations that are valid once are
 * not valid twice. */
#include <stdio.h>

enum { COUNT = 2000, ROWS = 32 };

int k[COUNT];
extern int table[];
double h[ROWS];

double scale(double v);

void object_without_length(int n);
void object_with_length(int n);
void function(int n);
void tags(int n);
void neighbour(int n);

void object_without_length(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        extern int table[];
        h[table[t]] += 0.1;
    }
}

void object_with_length(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        extern int table[COUNT];
        h[table[t]] += 0.1;
    }
}

void function(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double scale(double v);
        h[k[t]] += scale(t);
    }
}

void tags(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        enum { WEIGHT = 3 };
        typedef double weight;
        struct inside {
            weight w;
        };
        const struct inside one = {WEIGHT};
        h[k[t]] += one.w;
    }
}

void neighbour(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += 0.5;
}

int table[COUNT];

double scale(double v) {
    return 0.1 * v;
}

int main(void) {
    for (int t = 0; t < COUNT; t++)
        k[t] = table[t] = t * 7 % ROWS;
    object_without_length(COUNT);
    object_with_length(COUNT);
    function(COUNT);
    tags(COUNT);
    neighbour(COUNT);
    for (int i = 0; i < ROWS; i++)
        printf("%a\n", h[i]);
    return 0;
}
