/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Reads through pointers in memory: the guard records their addresses row by row.
// covers: row 48 of docs/constructs.md
#include "case.h"

enum { POINTS = 2000, FEATURES = 5, CLUSTERS = 40 };
struct sample {
    double *value;
    double weight;
};
static double room[POINTS][FEATURES], centre_room[CLUSTERS][FEATURES], total[CLUSTERS];
static double *feature[POINTS], *centre[CLUSTERS];
static struct sample sample[POINTS];
static int member[POINTS], count[CLUSTERS];

static void new_centres(int n, int m, double **to, double **from) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int k = member[i];
        count[k]++;
        for (int j = 0; j < m; j++)
            to[k][j] += from[i][j];
    }
}

static void into_array(int n, double **from) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        total[member[i]] += from[i][1] * from[n - 1 - i][2];
}

static void of_members(int n, double **to) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const struct sample *p = &sample[i];
        if (p->weight > 0.25)
            to[member[i]][0] += p->weight * p->value[3];
    }
}

static void restricted(int n, double *restrict *restrict to, double *restrict const *from) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        to[member[i]][0] += from[i][4];
}

static void by_way_of_local(int n, double **to, double **from) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double *row = to[member[i]];
        const double *other = from[i];
        for (int j = 0; j < FEATURES; j++)
            row[j] -= other[j] * 0.125;
    }
}

static void all_loops(void) {
    new_centres(POINTS, FEATURES, centre, feature);
    into_array(POINTS, feature);
    of_members(POINTS, centre);
    by_way_of_local(POINTS, centre, feature);
    restricted(POINTS, (double *restrict *)centre, (double *restrict const *)feature);
}

static void twice(const char *name) {
    for (int i = 0; i < POINTS; i++)
        sample[i] = (struct sample){feature[(i * 3) % POINTS], case_value()};
    all_loops();
    all_loops();
    for (int i = 0; i < POINTS; i += 2)
        feature[i][i % FEATURES] = case_value();
    all_loops();
    for (int k = 0; k < CLUSTERS; k++)
        case_print(name, centre[k], FEATURES * sizeof(double));
    CASE_PRINT(centre_room);
    CASE_PRINT(total);
    CASE_PRINT(count);
}

int main(void) {
    case_values(&room[0][0], POINTS * FEATURES);
    case_subscripts(member, POINTS, CLUSTERS);
    for (int i = 0; i < POINTS; i++)
        feature[i] = room[i];
    for (int k = 0; k < CLUSTERS; k++)
        centre[k] = centre_room[k];
    twice("in blocks");
    for (int i = 0; i < POINTS; i += 3)
        feature[i] = room[(i * 11) % POINTS];
    twice("other rows");
    for (int k = 0; k < CLUSTERS; k++)
        centre[k] = calloc(FEATURES, sizeof(double));
    twice("allocated each");
    case_subscripts(member, POINTS, CLUSTERS);
    twice("other members");
    return 0;
}
