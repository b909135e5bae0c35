/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/do_loops.c: their conditions do not give the
// trip count, or must not be evaluated before the first iteration.
// covers: row 91 of docs/constructs.md
#include <stddef.h>

enum { N = 4000 };
extern int s[N], m[N];
extern double e[N], h[N];
extern int count(void);

void asks_more(int n) {
    do { // EXPECT: refuse trip-count
        h[s[n]] += e[n];
    } while (--n && s[n] > 3);
}

void steps_twice(int n) {
    do { // EXPECT: refuse counter-modified
        h[s[n]] += e[n];
        n--;
    } while (--n > 0);
}

void goes_on_without_a_step(int n) {
    int i = 0;
    do { // EXPECT: refuse trip-count
        if (s[i] > 3)
            continue;
        h[s[i]] += e[i];
        i++;
    } while (i < n);
}

void ends_before(int n) {
    do { // EXPECT: refuse array-read
        if (h[s[n]] > 3)
            break;
        h[s[n]] += e[n];
    } while (--n);
}

void bound_in_the_body(int n, int low) {
    do { // EXPECT: refuse bound-varies
        h[s[n]] += e[n];
        low = s[n];
    } while (--n > low);
}

void without_an_end(size_t n) {
    do { // EXPECT: refuse counter-wraps
        h[s[n]] += e[n];
    } while (--n >= 0);
}

void narrow(unsigned short n) {
    do { // EXPECT: refuse counter-wraps
        h[s[n]] += e[n];
    } while (--n);
}

void to_a_wide_bound(unsigned n, unsigned long low) {
    do { // EXPECT: refuse counter-wraps
        h[s[n]] += e[n];
    } while (--n != low);
}

void unsigned_asked_before(unsigned n, unsigned low) {
    do { // EXPECT: refuse counter-wraps
        h[s[n]] += e[n];
    } while (n-- > low);
}

void once_more_by_equality(int n) {
    do { // EXPECT: refuse trip-count
        h[s[n]] += e[n];
    } while (n-- == 4);
}

void away(int n, int bound) {
    do { // EXPECT: refuse step
        h[s[n]] += e[n];
    } while (--n < bound);
}

void address_taken(int n) {
    int *p = &n;
    do { // EXPECT: refuse counter-modified
        h[s[n]] += e[n];
        *p = 3;
    } while (--n);
}

void changes_by_itself(volatile int n) {
    do { // EXPECT: refuse counter-type
        h[s[n]] += e[n];
    } while (--n);
}

extern int shared;

void global(void) {
    do { // EXPECT: refuse counter-type
        h[s[shared]] += e[shared];
    } while (--shared);
}

void pointer_behind_its_end(const int *p, const int *end) {
    do { // EXPECT: refuse counter-type
        h[*p] += 1;
    } while (p++ < end);
}

/* The condition may be undefined before the first iteration: c may overlap d, and d[0] may be 0 until it is updated. */
void divides(int *c, const int *d, int n) {
    int i = 0;
    do { // EXPECT: refuse trip-count
        c[s[i]] += 1;
    } while (++i < n / d[0]);
}

void looks_up(int *c, const int *d) {
    int i = 0;
    do { // EXPECT: refuse trip-count
        c[s[i]] += 1;
    } while (++i < m[d[0]]);
}

struct grid {
    const int *n;
};

void follows(int *c, const struct grid *g) {
    int i = 0;
    do { // EXPECT: refuse trip-count
        c[s[i]] += 1;
    } while (++i < *g->n);
}

extern const struct grid *current;

void follows_a_global(int *c) {
    int i = 0;
    do { // EXPECT: refuse trip-count
        c[s[i]] += 1;
    } while (++i < current->n[0]);
}

void calls(int n) {
    do { // EXPECT: refuse trip-count
        h[s[n]] += e[n];
    } while (--n > count());
}

/* A directive within the loop, or a macro, determines the loop's text. */
void ends_in_a_branch(int n) {
    do { // EXPECT: refuse directive-in-range
        h[s[n]] += e[n];
    } while (--n > 0)
#ifndef OTHER
        ;
#endif
}

#define END ;

void semicolon_of_a_macro(int n) {
    do { // EXPECT: refuse text
        h[s[n]] += e[n];
    } while (--n > 0) END
}
