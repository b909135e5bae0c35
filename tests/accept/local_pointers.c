/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The element is reached through a local pointer that the iteration sets.
// covers: row 45, row 46, row 47 of docs/constructs.md
#include "case.h"

enum { N = 14000, M = 900 };
struct vector {
    double x, y, z;
};
struct particle {
    struct vector at, force;
    int contacts;
    double mass;
};
struct system {
    int count;
    struct particle *particle;
    double table[M][4];
};
static int pair[N][2], s[N];
static double v[N], b[M][3], flat[3 * M];
static struct particle particle[M];
static struct system whole;

static void rows(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *row = b[s[t]];
        row[0] += v[t];
        row[1] -= 0.5 * v[t];
        row[2] *= 0.75;
    }
}

static void records(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        struct particle *p = &particle[pair[t][0]], *q = &particle[pair[t][1]];
        const double dx = p->at.x - q->at.x, dy = p->at.y - q->at.y;
        const double f = (dx * dx + dy * dy) * p->mass;
        p->force.x += f * dx;
        p->force.y += f * dy;
        q->force.x -= f * dx;
        q->force.y -= f * dy;
        p->contacts++;
        q->contacts++;
    }
}

static void of_system(struct system *sys) {
    struct particle *p;
    struct vector *f;
    for (int t = 0; t < sys->count; t++) { // EXPECT: transformed
        double *const entry = sys->table[s[t]];
        p = sys->particle + s[t];
        f = &p->force;
        f->z += v[t];
        entry[t & 3] += v[t];
        if (entry[1] > 2.0)
            entry[1] = 0.0;
    }
}

static void linear(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *to = flat + 3 * s[t];
        for (int c = 0; c < 3; c++)
            to[c] += v[t] * c;
        *to += 1.0;
    }
}

int main(void) {
    case_values(v, N);
    for (int i = 0; i < M; i++)
        particle[i] = (struct particle){{case_value(), case_value(), 0}, {0, 0, 0}, 0, 1.5};
    whole.count = N;
    whole.particle = particle;
    for (int round = 0; round < 3; round++) {
        case_subscripts(&pair[0][0], 2 * N, M);
        case_subscripts(s, N, M);
        rows(N);
        records(N);
        of_system(&whole);
        linear(N);
        CASE_PRINT(b);
        CASE_PRINT(flat);
        CASE_PRINT(whole.table);
        for (int i = 0; i < M; i++) {
            case_print("force", &particle[i].force, sizeof particle[i].force);
            case_print("contacts", &particle[i].contacts, sizeof(int));
        }
    }
    return 0;
}
