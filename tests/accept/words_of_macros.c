// Function-like macros named like members of the runtime's structures: generated code never has a
// parenthesis after these names.
// INTEGERS: no
#include "case.h"

enum { N = 4000, K = 90, W = 3 };
#define at(t) place[t]
#define row(i) h[i]
#define value(t) (1.0 / (1 + (t)))
#define x(i, c) h[i][c]
#define first(t) place[W * (t)]
#define last(t) place[W * (t) + W - 1]
#define k(t) place[t]
#define copy(a, b) ((a) = (b))
#define base(p) (&(p)[0])
#define count(p) ++*(p)
#define set(p, v) (*(p) = (v))
#define end(n) ((n) / W)

static int place[N];
static double h[K][W];
static long n[K];

static void by_macros(void) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        x(at(t), t % W) += value(t);
    for (int t = 0; t < end(N); t++) { // EXPECT: transformed
        row(first(t))[0] -= 0.25;
        row(last(t))[2] += value(k(t));
    }
    for (int t = 0; t < N; t++) // EXPECT: transformed
        n[k(t)] += 2;
}

int main(void) {
    case_subscripts(place, N, K);
    for (int round = 0; round < 4; round++)
        by_macros();
    CASE_PRINT(h);
    CASE_PRINT(n);
}
