// Inner loops that compute, from what they read, which element the iteration reads afterwards. An inspector that visits
// only the first and the last iteration of such a loop compares another element, or leaves the array.
// MAY-RUN-SERIALLY: the elements that are read are partly those that are updated
// INTEGERS: no
#include "case.h"

enum { ROWS = 2000, LENGTH = 4, N = ROWS * LENGTH, M = 400 };
static int at[N], begin[ROWS + 1];

static void summed(int rows, const int *b, const int *s, const double *x, double *to) {
    for (int i = 0; i < rows; i++) { // EXPECT: transformed
        int sum = 0;
        double z = 0;
        for (int j = b[i]; j < b[i + 1]; j++) {
            sum += s[j];
            z += x[j];
        }
        to[i % 200 + s[b[i]]] += z + x[sum];
    }
}

static void greatest(int rows, const int *b, const int *s, const double *x, double *to) {
    for (int i = 0; i < rows; i++) { // EXPECT: transformed
        int most = 0;
        double z = 0;
        for (int j = b[i]; j < b[i + 1]; j++) {
            const int next = s[j] > most ? s[j] : most;
            z += x[j];
            most = next;
        }
        to[i % 200 + s[b[i]]] += z * x[most];
    }
}

/* Only all of a row's elements add up to a position in the table, and 1 / sum is not a division by 0. */
static void in_table(int rows, const int *b, const int *s, const double *x, const double *table, double *to) {
    for (int i = 0; i < rows; i++) { // EXPECT: transformed
        int sum = 0;
        double z = 0;
        for (int j = b[i]; j < b[i + 1]; j++) {
            sum += s[j];
            z += x[j];
        }
        to[i % 200] += z + table[12 / sum];
    }
}

int main(void) {
    static double all[N + M];
    double table[13];
    for (int i = 0; i <= ROWS; i++)
        begin[i] = i * LENGTH;
    case_values(all, N + M);
    case_values(table, 13);
    for (int round = 0; round < 3; round++) {
        for (int i = 0; i < N; i++)
            at[i] = i % LENGTH == 1 ? N + (i / LENGTH + round) % 300 : 0;
        summed(ROWS, begin, at, all, all + N);
        greatest(ROWS, begin, at, all, all + N);
        for (int i = 0; i < N; i++)
            at[i] = i % LENGTH == 1 + i / LENGTH % 2 ? 1 + i % 12 : 0;
        in_table(ROWS, begin, at, all, table, all + N);
        for (int i = 0; i < M; i++)
            all[N + i] = all[N + i] > 1e100 || all[N + i] < -1e100 ? 1 : all[N + i];
    }
    CASE_PRINT(all);
    return 0;
}
