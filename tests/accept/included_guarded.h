#ifndef INCLUDED_GUARDED_H
#define INCLUDED_GUARDED_H
#include <assert.h>
static inline void guarded(int n, const int *s, const double *e, double *h) {
    assert(n >= 0);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += e[t];
}
#endif /* defined by no other file */
