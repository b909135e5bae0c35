/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reasons R2xx. Covers rows 12, 13, 29, 30, 44, 46, 59 and 60 of docs/constructs.md. */
#include <string.h>

struct list {
    int key;
    double value;
    struct list *next;
};

void may_alias(int n, struct list **head, int *h) {
    for (int i = 0; i < n; i++) {
        struct list *p = head[i];
        while (p) { // EXPECT: refuse trip-count
            h[p->key] += 1;
            p = p->next;
        }
    }
}

void chasing_apart(int n, struct list **head, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 not-verifiable
        for (struct list *p = head[i]; p; p = p->next)
            h[p->key] += 1.0;
}

void unknown_reads(int n, const int *s, struct list **head, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse may-alias
        double sum = 0;
        for (struct list *p = head[i]; p; p = p->next)
            sum += p->value;
        h[s[i]] += sum;
    }
}

struct output {
    double *b;
};

void optional(int n, const int *s, struct output *o) {
    for (int i = 0; i < n; i++) // EXPECT: refuse base-conditional
        if (o)
            o->b[s[i]] += 1.0;
}

/* the pointer was valid before the loop, but its target may have been freed */
void not_optional(int n, const int *s, struct output *o) {
    o->b[0] = 0;
    for (int i = 0; i < n; i++) // EXPECT: refuse base-conditional
        if (s[i] > 0)
            o->b[s[i]] += 1.0;
}

void other_store(int n, const int *s, double *restrict h, double *restrict o) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        o[0] = i;
        h[s[i]] += 1.0;
    }
}

double scalar_carried(int n, const int *s, double *h) {
    double sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        sum += s[i];
        h[s[i]] += sum;
    }
    return sum;
}

void previous(int n, const int *s, double *h) {
    int k = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[k] += 1.0;
        k = s[i];
    }
}

void sometimes(int n, const int *s, double *h) {
    int k = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        if (s[i] > 0)
            k = s[i];
        h[k] += 1.0;
    }
}

int global_count;

void global_scalar(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        global_count++;
        h[s[i]] += 1.0;
    }
}

struct totals {
    double *b;
    double sum;
};

void memory_scalar(int n, const int *s, struct totals *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transform t->b(+) guards=1
        t->sum += 1.0;
        t->b[s[i]] += 1.0;
    }
}

void private_not_proved(int n, const int *s, double *h) {
    double f[3];
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        f[0] = 1.0;
        if (s[i] > 2)
            f[1] = 2.0;
        h[s[i]] += f[0] + f[1];
    }
}

static void fill_two(double *f) {
    f[0] = 1;
    f[1] = 2;
}

void half_filled(int n, const int *s, double *h) {
    double f[3] = {0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        fill_two(f);
        f[2] += 1;
        h[s[i]] += f[2];
    }
}

int last_value(int n, const int *s, double *h) {
    int k = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse last-value
        if (s[i] > 0) {
            int place = k = s[i];
            h[place] += 1.0;
        }
    }
    return k;
}

double *kept;

void escapes(int n, const int *s, double *h) {
    double f[3];
    kept = f;
    for (int i = 0; i < n; i++) { // EXPECT: refuse escapes
        f[0] = s[i];
        h[s[i]] += f[0];
    }
}

void through_pointer(int n, const int *s) {
    double f[3] = {0};
    double *b = f;
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        f[0] = s[i];
        b[s[i]] += f[0];
    }
}

void volatile_array(int n, const int *s, volatile double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse volatile
        h[s[i]] += 1.0;
}

void volatile_index(int n, volatile int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse volatile
        h[s[i]] += 1.0;
}

void atomic_array(int n, const int *s, _Atomic int *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse volatile
        h[s[i]] += 1;
}

_Thread_local double scale;

void thread_local_scalar(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse thread-local
        h[s[i]] += scale;
}

void punned(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse type-punned
        ((int *)h)[s[i]] += 1;
}

void character_view(int n, const int *s, unsigned char *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += 1;
}

void pointer_changed(int n, const int *s, struct totals *t, struct totals *u) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        t->b[s[i]] += 1.0;
        u->b = t->b + 1;
    }
}

void own_pointer_overwritten(int n, const int *s, long **h, long *g) {
    for (int i = 0; i < n; i++) // EXPECT: transform g(+)
        g[s[i]] += 1;
    for (int i = 0; i < n; i++) // EXPECT: transform h(+,kept)
        h[s[i]][0] += 1;
}
