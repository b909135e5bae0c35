/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Each loop differs from one of accept/changed_parameters.c in one point, which makes its subscripts unknown.

static int next(int at) {
    while (at > 9)
        at -= 7;
    return at;
}

/* The parameter changes in a loop: a later turn reads with the value of an earlier one. */
static float in_loop(const float *table, int at) {
    float sum = 0;
    for (int a = 0; a < 3; a++) {
        sum += table[at];
        at += 2;
    }
    return sum;
}

void by_loops(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += in_loop(table, k[t]);
}

/* The subscript is the value that the previous turn gave the local variable. */
static float carried(const float *table, const int *list) {
    float sum = 0;
    int at = 0;
    for (int a = 0; a < 3; a++) {
        sum += table[at];
        at = list[a];
    }
    return sum;
}

void by_turns(int n, const int *s, const int (*k)[3], const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += carried(table, k[t]);
}

/* A jump skips the change. */
static float passed_by(const float *table, int at, int which) {
    switch (which) {
        at = 3;
    case 1:;
        return table[at];
    default:
        return 0;
    }
}

void by_cases(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += passed_by(table, k[t], t);
}

/* A jump into the branch skips the change. */
static float into_branch(const float *table, int at, int which) {
    switch (which) {
    default:
        if (at > 5) {
            at = 3;
        case 1:
            which = 2;
        }
    }
    return table[at] + which;
}

void by_branches(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += into_branch(table, k[t], t);
}

static float again(const float *table, int at) {
    if (at < 3)
        goto behind;
    at = 3;
behind:;
    return table[at];
}

void by_labels(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += again(table, k[t]);
}

/* The parameter changes through its address, or to the result of a function with a loop. */
static float by_address(const float *table, int at) {
    int *const to = &at;
    at += 1;
    *to += 2;
    return table[at];
}

void by_addresses(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += by_address(table, k[t]);
}

static float by_call(const float *table, int at) {
    at = next(at);
    return table[at];
}

void by_calls(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += by_call(table, k[t]);
}

/* The change is part of a larger expression. */
static float in_parts(const float *table, int at) {
    if (at++ > 3)
        return 0;
    return table[at];
}

void by_parts(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += in_parts(table, k[t]);
}

static float in_sum(const float *table, int at) {
    int to;
    const float sum = (to = at + 2) > 5;
    at = 7;
    return table[to] + sum * at;
}

void by_sums(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += in_sum(table, k[t]);
}

/* The pointer to the table changes. */
static float by_pointer(const float *table, int at) {
    if (at > 4)
        table += 2;
    return table[at];
}

void by_pointers(int n, const int *s, const int *k, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += by_pointer(table, k[t]);
}

/* A value that only some branches set. */
static float in_one(const float *table, const int *list, int at) {
    int to;
    if (at > 4)
        to = list[at];
    else if (at > 2)
        to = at;
    return at > 2 ? table[to] : 0;
}

void by_one(int n, const int *s, const int *k, const int *list, const float *table, float *b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        b[s[t]] += in_one(table, list, k[t]);
}
