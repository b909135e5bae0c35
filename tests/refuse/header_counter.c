/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Macros from a header or an option contain __COUNTER__: a second copy of the loop's text would change its values.
// FLAGS: -DOF_OPTION=__COUNTER__
#include "header_counter.h"

int by_header(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse counter-macro
        h[k[t]] += OF_HEADER;
    return OF_HEADER;
}

int by_option(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse counter-macro
        h[k[t]] += OF_OPTION;
    return OF_OPTION;
}

int by_condition(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse counter-macro
#if OF_HEADER > 3
        h[k[t]] += 1;
#endif
        h[k[t]] += 2;
    }
    return OF_HEADER;
}
