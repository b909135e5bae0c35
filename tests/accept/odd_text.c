/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Lines that end in CR LF, names in UTF-8, digraphs, a name spliced across two lines, and a byte order mark.
// covers: row 63 of docs/constructs.md
// COMPILERS: gcc clang-19
%:include "case.h"

enum <% N = 6000, M = 400 %>;
static int indiсes<:N:>;
static double größe<:N:>, h<:M:>;

static void odd(int n) {
    for (int t = 0; t < n; t++) <% // EXPECT: transformed
        h[indiсes<:t:>] +\
= größe[t];
    %>
	for (int t = 0; /* > */ t < n; t++)	if (t % 2) h<:indiсes[t]:> -= gr\
öße[t];
}

int main(void) {
    case_values(größe, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(indiсes, N, M);
        odd(N);
        CASE_PRINT(h);
    }
    return 0;
}
