/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* One name has several meanings: in nested scopes, as tag and variable, parameter and global, type
 * name, enumerator, or member of the runtime's structures. */
#include <stdio.h>
enum { COUNT = 3000, ROWS = 64 };
static double h[ROWS];
static int k[COUNT];
typedef int row_type;
struct pair {
    int second, first;
};
static int old_style(n, a)
int n;
const int *a;
{ return a[n]; }
static void kr(n, a) int n;
int *a;
{
    int t;
    for (t = 0; t < n; t++) // EXPECT: parallel
        h[old_style(t, a)] += 0.1;
}
static void typedef_hidden(int n) {
    int row_type = 3;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int to = k[t] * row_type;
        h[to % ROWS] += 0.1;
    }
}
static void typedef_hidden_inside(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        row_type a = k[t];
        int row_type = a * 3;
        h[row_type % ROWS] += 0.1;
    }
}
static void nested(int n) {
    int i = 5;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int to = k[t] + i;
        {
            int i = to * 3;
            {
                int i2 = i;
                {
                    int i = i2 + 1;
                    to += i;
                }
                to += i;
            }
        }
        to += i;
        h[to % ROWS] += 0.1 * i;
    }
}
static void self_shadow(int n, int w) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int v = w;
        {
            int u = v + k[t];
            int v = u;
            {
                int w = v;
                h[w % ROWS] += 0.3;
            }
        }
    }
}
static void generic(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        int to = _Generic(k[t], int : k[t] + 1, double : 0);
        h[to % ROWS] += (double)sizeof(__func__);
    }
}
static void literal(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        struct pair p = (struct pair){k[t], t};
        h[((struct pair){k[t], 1}).second] += p.first;
    }
}
static void vla(int n, int m, int v[n][m]) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        int m2 = (int)(sizeof(int[m]) / sizeof(int));
        h[(v[t][0] + m2) % ROWS] += 0.1;
    }
}
static void var_len_shadow(int n) {
    int m = 2;
    int(*a)[m] = (int(*)[m])k;
    for (int t = 0; t < n / 4; t++) { // EXPECT: refuse text
        int m = 7;
        h[(a[t][1] + m) % ROWS] += 0.1;
    }
}
static int look_static(int t) {
    static const int step[4] = {1, 2, 3, 4};
    return k[t] + step[t % 4];
}
static void look_in_static(int n) {
    static const int step[2] = {9, 8};
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[look_static(t) % ROWS] += step[t % 2];
}
static void block_function(int n) {
    int abs(int);
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        int abs(int);
        h[abs(-k[t])] += 0.1;
    }
}
static int glob = 4;
static int by_glob(int t) {
    return k[t + glob];
}
static void param_glob(int n, int glob) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[by_glob(t)] += glob;
}
struct node {
    int node;
    struct node *next;
};
static void tag_and_variable(int n, struct node *node) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        struct node *p = &node[t];
        h[p->node] += 0.5;
    }
}
#define third first
static void member_macro(int n) {
    struct pair q[2] = {{1, 2}, {3, 4}};
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[(k[t] + q[t % 2].third) % ROWS] += 0.1;
}
#undef third
static void counter_names(int n) {
    int first = 1, worker = 2, base = 3, owner = 1, origin = 2, run = 5, threads = 1;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[(k[t] + first + worker + base + owner + origin + run + threads) % ROWS] += worker;
}
enum color { RED, GREEN, BLUE = -3, HUGE = 0x7fffffff, LOW = -2147483647 - 1 };
static void enums(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        enum color c = k[t] % 2 ? RED : GREEN;
        int to = k[t];
        switch (c) {
        case RED:
            to += 1;
            break;
        case GREEN:
            to -= BLUE;
            break;
        default:
            break;
        }
        to = to & HUGE;
        if (to == LOW || -to == -BLUE)
            to = 0;
        h[to % ROWS] += 0.1;
    }
}
int main(void) {
    static struct node nodes[COUNT];
    for (int t = 0; t < COUNT; t++) {
        k[t] = t * 7 % ROWS;
        nodes[t].node = k[t];
    }
    kr(COUNT, k);
    typedef_hidden(COUNT);
    typedef_hidden_inside(COUNT);
    nested(COUNT);
    self_shadow(COUNT, 3);
    generic(COUNT);
    literal(COUNT);
    vla(COUNT / 8, 4, (int(*)[4])k);
    var_len_shadow(COUNT);
    look_in_static(COUNT);
    block_function(COUNT);
    param_glob(COUNT - 9, 3);
    tag_and_variable(COUNT, nodes);
    member_macro(COUNT);
    counter_names(COUNT);
    enums(COUNT);
    for (int i = 0; i < ROWS; i++)
        printf("%a\n", h[i]);
    return 0;
}
