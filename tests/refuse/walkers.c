/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/walkers.c: how the pointer is set, stepped, passed on or used.
// covers: row 47, row 89 of docs/constructs.md
enum { N = 4000 };
extern int place[N], length[N];
extern double e[N], weight[40];
void note(double **);

void two_starts(int n, double *to, double *from) {
    for (int t = 0; t < n; t++) {
        double *q = to + place[t];
        if (length[t] > 3)
            q = from + place[t];
        for (int c = 0; c < length[t]; c++, q++) // EXPECT: refuse base-varies
            q[place[c]] += e[t];
    }
}

void of_the_iteration_before(int n, double *to) {
    double *q;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        if (t % 3 == 0)
            q = to + place[t];
        for (int c = 0; c < length[t]; c++, q++)
            *q += e[t];
    }
}

void stepped_in_the_update(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse side-effect
        double *q = to + place[t];
        for (int c = 0; c < length[t]; c++)
            *q++ += e[t];
    }
}

void given_away(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        double *q = to + place[t];
        note(&q);
        for (int c = 0; c < 5; c++, q++)
            *q += e[t];
    }
}

void read_beside(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        double *q = to + place[t];
        for (int c = 0; c < 5; c++, q++)
            *q += to[place[t]] * weight[c];
    }
}

void of_another_type(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse type-punned
        float *q = (float *)(to + place[t]);
        for (int c = 0; c < 5; c++, q++)
            *q += (float)weight[c];
    }
}
