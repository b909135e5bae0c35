/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "constraint.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

int constraints_init(constraints *c, int count) {
    *c = (constraints){.count = count};
    c->given = calloc((size_t)count + 1, sizeof *c->given);
    return c->given ? 0 : -1;
}

void constraints_free(constraints *c) {
    free(c->given);
    free(c->place);
    free(c->list);
    *c = (constraints){0};
}

int constraint_place(constraints *c, int i) {
    assert(i >= 0 && i < c->count);
    enum { first_room = 16 };
    if (!c->place) {
        c->place = malloc(sizeof *c->place * (size_t)c->count);
        for (int k = 0; c->place && k < c->count; k++)
            c->place[k] = -1;
    }
    if (!c->place)
        return -1;
    if (c->place[i] >= 0)
        return 0;
    if (c->used == c->room) {
        const int wanted = c->room > 0 ? c->room + c->room / 2 : first_room;
        const int room = wanted < c->count ? wanted : c->count;
        vertex_constraint *more = realloc(c->list, (size_t)room * sizeof *more);
        if (!more)
            return -1;
        c->list = more;
        c->room = room;
    }
    c->place[i] = c->used++;
    return 0;
}

void constraint_release(constraints *c, int i) {
    c->given[i] = 0;
}

void constraint_give(constraints *c, int i, int count, const double (*d)[3], const double *change) {
    assert(c->place && c->place[i] >= 0 && c->place[i] < c->used);
    vertex_constraint *of = &c->list[c->place[i]];
    double e[3][3];
    int known = 0;
    *of = (vertex_constraint){.S = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int k = 0; k < count && known < 3; k++) {
        const double scale = 1 / vector_length(d[k]);
        double rest[3] = {d[k][0] * scale, d[k][1] * scale, d[k][2] * scale};
        double value = change[k] * scale;
        for (int m = 0; m < known; m++) {
            const double part = vector_dot(rest, e[m]);
            vector_add_scaled(rest, -part, e[m], rest);
            value -= part * vector_dot(e[m], of->z);
        }
        const double square = vector_dot(rest, rest);
        if (!(square > 1e-8))
            continue;
        for (int a = 0; a < 3; a++)
            e[known][a] = rest[a] / sqrt(square);
        vector_add_scaled(of->z, value / sqrt(square), e[known], of->z);
        known++;
    }
    for (int m = 0; m < known; m++)
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                of->S[a][b] -= e[m][a] * e[m][b];
    if (known == 3)
        memset(of->S, 0, sizeof of->S); /* exactly 0, without rounding errors */
    c->given[i] = (unsigned char)known;
}
