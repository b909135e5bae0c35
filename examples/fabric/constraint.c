/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "constraint.h"

#include <stdlib.h>
#include <string.h>

#include "vector.h"

int constraints_init(constraints *c, int count) {
    *c = (constraints){.count = count};
    c->given = calloc((size_t)count + 1, sizeof *c->given);
    c->S = calloc((size_t)count + 1, sizeof *c->S);
    c->z = calloc((size_t)count + 1, sizeof *c->z);
    if (!c->given || !c->S || !c->z) {
        constraints_free(c);
        return -1;
    }
    for (int i = 0; i < count; i++)
        constraint_release(c, i);
    return 0;
}

void constraints_free(constraints *c) {
    free(c->given);
    free(c->S);
    free(c->z);
    *c = (constraints){0};
}

void constraint_release(constraints *c, int i) {
    c->given[i] = 0;
    memset(c->S[i], 0, sizeof c->S[i]);
    memset(c->z[i], 0, sizeof c->z[i]);
    for (int a = 0; a < 3; a++)
        c->S[i][a][a] = 1;
}

void constraint_give(constraints *c, int i, int count, const double (*d)[3], const double *change) {
    double e[3][3];
    int known = 0;
    constraint_release(c, i);
    for (int k = 0; k < count && known < 3; k++) {
        const double scale = 1 / vector_length(d[k]);
        double rest[3] = {d[k][0] * scale, d[k][1] * scale, d[k][2] * scale};
        double value = change[k] * scale;
        for (int m = 0; m < known; m++) {
            const double part = vector_dot(rest, e[m]);
            vector_add_scaled(rest, -part, e[m], rest);
            value -= part * vector_dot(e[m], c->z[i]);
        }
        const double square = vector_dot(rest, rest);
        if (!(square > 1e-8))
            continue;
        for (int a = 0; a < 3; a++)
            e[known][a] = rest[a] / sqrt(square);
        vector_add_scaled(c->z[i], value / sqrt(square), e[known], c->z[i]);
        known++;
    }
    for (int m = 0; m < known; m++)
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                c->S[i][a][b] -= e[m][a] * e[m][b];
    if (known == 3)
        memset(c->S[i], 0, sizeof c->S[i]); /* exactly */
    c->given[i] = (unsigned char)known;
}
