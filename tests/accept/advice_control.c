/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops from docs/reasons.md, section on control flow, and changed as it advises (advice_updates.c explains BEFORE).
#include "case.h"

enum { N = 2000, ROWS = 80 };
static int s[N + 1], c[N], zeros[N], calls, end_at;
static double e[N], h[ROWS];

static int next(void) { return ++calls == end_at; }

static void begin(int end) {
    calls = 0;
    end_at = end;
}

static void trip_count(int n) {
    s[n] = -1;
    int t;
#ifdef BEFORE
    t = 0;
    while (s[t] >= 0) { // BEFORE: trip-count
        h[s[t]]++;
        t++;
    }
#else
    int last = 0;
    while (s[last] >= 0)
        last++;
    for (t = 0; t < last; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
}

static void counter_modified(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: counter-modified
        h[s[t]]++;
        if (c[t]) t++;
    }
    for (int t = 0; t < n; t++) { // BEFORE: counter-modified
        t %= N;
        h[s[t]]++;
    }
#else
    static int visited[N];
    int count = 0;
    for (int t = 0; t < n; t++) {
        visited[count++] = t;
        if (c[t]) t++;
    }
    for (int k = 0; k < count; k++) // EXPECT: transformed
        h[s[visited[k]]]++;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int k = t % N;
        h[s[k]]++;
    }
#endif
}

static int bound_varies(int n, const int *c) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: bound-varies
        h[s[t]]++;
        n -= c[t];
    }
#else
    const int bound = n;
    for (int t = 0; t < bound; t++) { // EXPECT: transformed
        h[s[t]]++;
        n -= c[t];
    }
#endif
    return n;
}

static int bound_counted_first(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: bound-varies
        h[s[t]]++;
        n -= c[t];
    }
#else
    int count = 0;
    for (; count < n; count++)
        n -= c[count];
    for (int t = 0; t < count; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
    return n;
}

static void step(int n) {
    int t;
#ifdef BEFORE
    for (t = 1; t < n; t *= 2) // BEFORE: step
        h[s[t]]++;
    for (t = 0; t != n; t += 3) // BEFORE: step
        h[s[t]]++;
#else
    int powers = 0;
    for (t = 1; t < n; t *= 2)
        powers++;
    for (t = 0; t < powers; t++) // EXPECT: transformed
        h[s[1 << t]]++;
    for (t = 0; t < n; t += 3) // EXPECT: transformed
        h[s[t]]++;
#endif
}

static void counter_type(int n) {
#ifdef BEFORE
    for (float f = 0; f < n; f++) // BEFORE: counter-type
        h[s[(int)f]]++;
#else
    for (int f = 0; f < n; f++) // EXPECT: transformed
        h[s[(int)f]]++;
#endif
}

static void counter_wraps(unsigned n) {
#ifdef BEFORE
    for (unsigned t = 0; t <= n; t++) // BEFORE: counter-wraps
        h[s[t]]++;
    for (unsigned t = n; t >= 2; t -= 2) // BEFORE: counter-wraps
        h[s[t]]++;
    for (unsigned t = 0; t <= n; t++) // BEFORE: counter-wraps
        h[s[t]]++;
#else
    for (int t = 0; t <= (int)n; t++) // EXPECT: transformed
        h[s[t]]++;
    for (int t = (int)n; t >= 2; t -= 2) // EXPECT: transformed
        h[s[t]]++;
    for (unsigned t = 0; t < n + 1; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
}

static void break_off(int n) {
    begin(n / 2);
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: break
        if (next()) break;
        h[s[t]]++;
    }
#else
    int end = 0;
    while (end < n && !next())
        end++;
    for (int t = 0; t < end; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
}

static void return_early(int n) {
    begin(n / 3);
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: return
        if (next()) return;
        h[s[t]]++;
    }
#else
    int end = 0;
    while (end < n && !next())
        end++;
    for (int t = 0; t < end; t++) // EXPECT: transformed
        h[s[t]]++;
    if (end < n)
        return;
#endif
    h[0] += 1;
}

static void go_out(int n) {
    begin(n / 4);
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: goto
        if (next()) goto out;
        h[s[t]]++;
    }
    for (int t = 0; t < n; t++) { // BEFORE: goto
        if (c[t]) goto on;
        h[s[t]]++;
    on:
        h[s[t]] += e[t];
    }
out:;
#else
    int end = 0;
    while (end < n && !next())
        end++;
    for (int t = 0; t < end; t++) // EXPECT: transformed
        h[s[t]]++;
    if (end == n)
        for (int t = 0; t < n; t++) { // EXPECT: transformed
            if (!c[t])
                h[s[t]]++;
            h[s[t]] += e[t];
        }
#endif
}

int main(void) {
    case_subscripts(s, N, ROWS);
    case_subscripts(c, N, 2);
    case_values(e, N);
    for (int round = 0; round < 3; round++) {
        trip_count(N);
        counter_modified(N);
        h[1] += bound_varies(N, zeros) + bound_counted_first(N);
        step(N / 3 * 3);
        counter_type(N);
        counter_wraps(N - 1);
        break_off(N);
        return_early(N);
        go_out(N);
        begin(0);
        go_out(N);
    }
    CASE_PRINT(h);
    return 0;
}
