#if __has_include("nothing.h")
#include "nothing.h"
#endif
static void asks(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse in-header
        h[s[t]]++;
}
