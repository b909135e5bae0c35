// The program computes arrays' lengths at their declarations, before the loops. The analysis still knows the
// values of other variables, and treats such arrays like all others.
#include "case.h"
// INTEGERS: no

enum { N = 300 };
static double pull[N][2];

static void pairs(int n, double scale) {
    int i, j;
    double d, at[n], load[n][2], next_at[n + 1];
    for (j = 0; j < n; j++) {
        at[j] = case_value();
        next_at[j + 1] = at[j] * 0.5;
        load[j][0] = load[j][1] = 0.0;
    }
    for (int round = 0; round < 3; round++)
        for (i = 0; i < n; i++) // EXPECT: transformed
            for (j = i + 1; j < n; j++) {
                d = (at[j] - at[i]) * scale;
                if (d > 2.0)
                    d = next_at[j];
                pull[i][0] += d;
                pull[j][1] -= d;
            }
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = 0; j < i; j++) {
            d = at[i] * at[j];
            load[j][0] += d;
            load[i][1] -= d;
        }
    for (j = 0; j < n; j++)
        pull[j][0] += load[j][0] - load[j][1];
}

int main(void) {
    for (int round = 0; round < 3; round++)
        pairs(N - round, 1.0 + round);
    CASE_PRINT(pull);
}
