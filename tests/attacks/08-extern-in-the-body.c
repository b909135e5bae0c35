/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A declaration in the loop's body names an object of the file, whose name a local variable or
 * parameter hides outside the body. Other functions declare the same object. */
#include <stdio.h>

enum { COUNT = 2000, ROWS = 32 };

int table[COUNT];
int shift;
double h[ROWS];

void parameter(const int *table, int n);
void local(int n);
void in_a_block(const int *table, int n);
void named_by_two(int n);
void neighbour(int n);
int first(void);

void parameter(const int *table, int n) {
    double sum = 0;
    for (int t = 0; t < n; t++)
        sum += table[t];
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        extern int table[];
        h[table[t]] += sum;
    }
}

void local(int n) {
    int shift = 3;
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        double weight = shift;
        extern int shift;
        h[(table[t] + shift) % ROWS] += weight;
    }
}

void in_a_block(const int *table, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        double weight = table[t];
        {
            extern int table[COUNT];
            h[table[t]] += weight;
        }
    }
}

void named_by_two(int n) {
    extern int table[];
    extern int shift;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[(table[t] + shift) % ROWS] += 0.5;
}

void neighbour(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[table[t]] += 0.5;
}

int first(void) {
    extern int table[];
    extern int shift;
    return table[0] + shift;
}

int main(void) {
    static int other[COUNT];
    for (int t = 0; t < COUNT; t++) {
        table[t] = t * 7 % ROWS;
        other[t] = t * 3 % ROWS;
    }
    shift = 1;
    parameter(other, COUNT);
    local(COUNT);
    in_a_block(other, COUNT);
    named_by_two(COUNT);
    neighbour(COUNT);
    for (int i = 0; i < ROWS; i++)
        printf("%a\n", h[i]);
    return first() - 1;
}
