/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/pointer_walks.c: the pointer's position does
// not follow from the number of earlier iterations.
// covers: row 89, row 90 of docs/constructs.md
enum { N = 4000 };
extern int s[N], counted[N];
extern double e[N], h[N];
extern const int *moved;
const int *next_of(const int *p);

void past_some(const int *p, const int *end) {
    for (; p < end; p++) { // EXPECT: refuse counter-modified
        counted[*p]++;
        if (*p == 3)
            p++;
    }
}

void in_some_iterations(const int *p, const int *end) {
    while (p < end) // EXPECT: refuse trip-count
        if (e[*p] > 0)
            counted[*p++]++;
}

void asked_for_behind(const int *p, const int *end) {
    while (p < end) { // EXPECT: refuse trip-count
        counted[*p++]++;
        h[*p] += 1.0;
    }
}

void asked_for_beside(int n, const int *p) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse side-effect
        counted[*p++]++;
        h[*p] += 1.0;
    }
}

void skipped_by_continue(const int *p, const int *end) {
    while (p < end) { // EXPECT: refuse trip-count
        if (s[0] == *p)
            continue;
        counted[*p++]++;
    }
}

void twice(const int *p, const int *end) {
    while (p < end) { // EXPECT: refuse trip-count
        counted[*p++]++;
        counted[*p++]++;
    }
}

void bound_moves(const int *p, const int *end) {
    while (p < end) { // EXPECT: refuse bound-varies
        end = end - *p % 2;
        counted[*p++]++;
    }
}

void of_the_file(const int *end) {
    for (; moved < end; moved++) // EXPECT: refuse counter-type
        counted[*moved]++;
}

void address_taken(const int *p, const int *end, const int ***kept) {
    *kept = &p;
    for (; p < end; p++) // EXPECT: refuse counter-modified
        counted[**(*kept)++]++;
}

void of_unknown_size(int m, int (*p)[m], int (*end)[m]) {
    for (; p < end; p++) // EXPECT: refuse counter-type
        counted[(*p)[0]]++;
}

void volatile_pointer(const int *end) {
    const int *volatile p = s;
    for (; p < end; p++) // EXPECT: refuse counter-type
        counted[*p]++;
}

void list_walk(const int *p, const int *end) {
    for (; p < end; p = next_of(p)) // EXPECT: refuse step
        counted[*p]++;
}

void by_subscripts(int n, const int *p) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        counted[*p]++;
        p += s[i];
    }
}

void on_one_side(int n, const int *p) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const int k = s[i] > 3 ? *p++ : 0;
        counted[k]++;
    }
}

void in_an_inner_loop(int n, const int *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse side-effect
        for (int c = 0; c < 2; c++)
            counted[*p++]++;
}

void before_the_step(int n, const int *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse side-effect
        counted[*++p]++;
}

void base_walks(int n, double *to) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-varies
        to[s[i]] += e[i];
        to++;
    }
}

int last_value(int n) {
    int j = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse side-effect
        j = s[i];
        h[s[i]] += e[j++];
    }
    return j;
}

void stores_through(int n, double *o) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        *o++ = e[i];
        h[s[i]] += e[i];
    }
}
