/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Arrays behind pointers that are read only under conditions. The pointer may differ between iterations, or its own
// address or bytes are used.
#include <string.h>

struct target { int n; double *h; double *volatile v; char name[8]; };
struct list { struct target *t; };

void moves(int n, const int *k, struct target *t, const double *x) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-conditional
        if (k[i] < 0)
            t->h++;
        else
            t->h[k[i]] += x[i];
    }
}

void another(int n, const int *k, struct target *t, struct target *other, const double *x) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-varies
        if (k[i] < 0)
            continue;
        t->h[k[i]] += x[i];
        t = k[i] > 5 ? other : t;
    }
}

/* Another function has stored the address of the pointer `t`. */
void known(struct target **);
void escaped(int n, const int *k, struct target *t, double *x, int **w) {
    known(&t);
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-conditional
        if (k[i] < 0)
            continue;
        t->h[k[i]] += x[i];
    }
}

void by_bytes(int n, const int *k, struct target *t, unsigned char *c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-conditional
        if (k[i] < 0)
            continue;
        t->h[k[i]] += 1.0;
        c[k[i]]++;
    }
}

void is_volatile(int n, const int *k, struct target *t, const double *x) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse volatile
        if (k[i] < 0)
            continue;
        t->v[k[i]] += x[i];
    }
}

void behind_updates(int n, const int *k, struct list *l, struct target **p, struct target *t) {
    for (int i = 0; i < n; i++) { // EXPECT: nothing
        if (k[i] < 0)
            continue;
        p[k[i]] += 1;
        l->t->h[k[i]] += 1.0;
    }
}
