/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Headers whose text would change its meaning in this file, and a header whose loop is refused for another reason.
#include "included_values.h"
#include "included_counter.h"
#include "included_open.h"
ends_here = 3;
inline
#include "included_inside.h"
#include "included_next.h"

int caller(int n, const int *restrict s, double *restrict h, int *restrict place) {
    counted(n, s, h);
    open_end(n, s, h);
    after_open(n, s, h);
    asks(n, s, h);
    for (int t = 0; t < n; t *= 2) // EXPECT: refuse step
        h[s[t]]++;
    return put(n, s, place) + ends_here;
}
