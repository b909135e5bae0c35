/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Reasons for which no other file of this folder has a loop.
// covers: row 8, row 34, row 44, row 56, row 61, row 62 of docs/constructs.md

void side_effect(int n, const int *restrict s, double *restrict h, const double *e) {
    int j = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse side-effect
        h[s[j]] += e[++j];
}

struct holder {
    double *restrict b;
};

void base_conditional(int n, const int *restrict s, struct holder *restrict out) {
    for (int t = 0; t < n; t++) // EXPECT: refuse base-conditional
        if (out)
            out->b[s[t]] += 1.0;
}

struct list {
    struct list *next;
    double w;
};

void may_alias(int n, const int *s, double *h, const struct list *first) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse may-alias
        double sum = 0;
        for (const struct list *l = first; l; l = l->next)
            sum += l->w;
        h[s[t]] += sum;
    }
}

void type_punned(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse type-punned
        ((int *)h)[s[t]]++;
}

void step(int n, const int *restrict s, double *restrict h) {
    for (int t = 1; t < n; t *= 2) // EXPECT: refuse step
        h[s[t]]++;
}

void opaque(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        h[s[t]] += ({ int k = s[t]; k; });
}

void ignored(int n, const int *restrict s, double *restrict h) {
#pragma redcc ignore
    for (int t = 0; t < n; t++) // EXPECT: refuse ignored
        h[s[t]]++;
}

void text(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        static double weights[2] = {0.5, 0.25};
        h[s[t]] += weights[t % 2];
    }
}
