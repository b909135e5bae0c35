/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// &h has the type pointer to array. In the parallel form `h` would be a pointer to elements, and &h another type.
enum { N = 4000 };
static double h[N], rows[40][100];
struct holder {
    int count;
    double h[N];
};

static double size_of(double (*p)[N]) {
    return (double)sizeof *p;
}

void pointer_to_array(int n, const int *s) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        double(*q)[N] = &h;
        (*q)[s[t]] += 1.0;
    }
}

void pointer_to_rows(int n, const int *s) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        double(*q)[40][100] = &rows;
        (*q)[s[t]][3] += 1.0;
    }
}

void pointer_to_member(struct holder *p, int n, const int *s) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        double(*q)[N] = &p->h;
        (*q)[s[t]] += 1.0;
    }
}

void end_of_array(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[s[t]] += (double)((char *)(&h + 1) - (char *)h);
}

void handed_over(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[s[t]] += size_of(&h);
}
