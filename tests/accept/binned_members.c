// Pairs of records: positions are read and forces updated through one pointer, as different members. The members read
// lie between updated ones and overlap none of these. Only the sum in memory, `*energy`, may overlap a member.
// INTEGERS: no
#include "case.h"

enum { N = 260 };
typedef struct triple {
    double x, y, z;
} triple;
struct body {
    triple at, pull;
    double mass, spare[2];
};
static struct body *bodies, memory[N + 1];

/* The read and the updated members alternate in memory from record to record. */
static void pull_all(int n, double *energy, double reach) {
    double dx, dy, dz, squared, f;
    int i, j;
    for (i = 0; i < n - 1; i++) // EXPECT: transformed
        for (j = i + 1; j < n; j++) {
            dx = bodies[i].at.x - bodies[j].at.x;
            dy = bodies[i].at.y - bodies[j].at.y;
            dz = bodies[i].at.z - bodies[j].at.z;
            squared = dx * dx + dy * dy + dz * dz;
            if (squared < reach) {
                f = 1.0 / (squared + 0.25);
                bodies[i].pull.x += f * dx, bodies[i].pull.y += f * dy, bodies[i].pull.z += f * dz;
                bodies[j].pull.x += -f * dx, bodies[j].pull.y += -f * dy, bodies[j].pull.z += -f * dz;
                *energy += f;
            }
        }
} // CHECKED: 20

/* The contribution reads another member through the same pointer, of a record whose number a list gives. */
static void by_list(int n, struct body *b, const int *first, const int *second) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        b[first[t]].spare[0] += b[second[t]].mass;
        b[second[t]].spare[0] -= b[first[t]].mass * 0.5;
    }
} // BINNED: 37

/* The loop updates one element of an array within the record and reads other members. */
static void by_parts(int n, struct body *b, const int *begin, const int *end) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int k = begin[t]; k < end[t]; k++) {
            b[k].spare[1] += b[k].mass * t;
            b[k].pull.z -= b[t].at.z;
        }
} // BINNED: 45

/* The same updates through pointers to records, which are set while the counters have their final values. */
static void by_pointers(int n, struct body *b, double scale) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        struct body *p = &b[i];
        for (int j = i + 1; j < n; j++) {
            struct body *const q = &b[j];
            const double d = (p->at.x - q->at.y) * scale;
            p->pull.x += d * q->mass;
            q->pull.x -= d * p->mass;
            (&b[j])->pull.y += d;
        }
    }
}

/* Pointers set before `k` changes, from a record number in a list, or in one branch only. */
static void by_moved_pointers(int n, struct body *b, const int *first, const int *second) {
    struct body *r;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k = first[t];
        struct body *p = &b[k];
        k = second[t];
        struct body *q = &b[k];
        p->spare[0] += q->mass;
        for (k = 0; k < 3; k++)
            q->spare[k & 1] -= p->mass;
        if (t % 3) {
            r = &b[k + second[t] % 2];
            r->pull.z += 0.5;
        }
    }
}

/* By their types, the member `w` may overlap the updated array `g`, and `count` may overlap the sum `*total`. */
struct counted {
    double w, v;
    int count, other;
};
static void of_two_types(int n, const struct counted *b, double *g, const long *k, const long *s, int *total) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        g[s[t]] += b[k[t]].w * 0.5;
        *total += b[k[t]].count;
    }
}

/* The records are found through a pointer in a record, and the contribution's text names this pointer again. */
struct system {
    struct body *all;
};
static void behind_a_record(int n, struct system *const *s, int here, const int *first, const double *near) {
    float w;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        w = 2.0 - near[t];
        w *= 0.75f;
        (*s)->all[first[t]].spare[1] += w * (*s)->all[here].mass;
        (*s)->all[here].spare[1] += w * (*s)->all[first[t]].mass;
    }
} // BINNED: 102

static void fill(void) {
    for (int i = 0; i <= N; i++) {
        double *part = &memory[i].at.x;
        for (unsigned k = 0; k < sizeof *memory / sizeof *part; k++)
            part[k] = case_value() + (k < 3 ? i % 13 : 0);
    }
    memory[3].pull.y = -0.0;
    bodies = memory;
}

int main(void) {
    static int first[4 * N], second[4 * N], begin[N], end[N];
    static double near[4 * N];
    case_subscripts(first, 4 * N, N);
    case_subscripts(second, 4 * N, N);
    for (int t = 0; t < N; t++) {
        begin[t] = case_below(N);
        end[t] = begin[t] + case_below(N - begin[t] + 1) - (t % 5 == 0);
    }
    static struct counted counted[2 * N];
    static long doubles[4 * N], places[4 * N];
    case_values(near, 4 * N);
    for (int t = 0; t < 4 * N; t++)
        doubles[t] = 3 * first[t] + t % 2, places[t] = second[t];
    for (int round = 0; round < 3; round++) {
        int total = 0;
        for (int i = 0; i < 2 * N; i++)
            counted[i] = (struct counted){case_value(), case_value(), i, -i};
        of_two_types(4 * N, counted, &counted[round ? round * N - N : 7].w, places, doubles, round ? &total : &counted[5].count);
        CASE_PRINT(counted);
        case_print("total", &total, sizeof total);
    }
    for (int round = 0; round < 5; round++) {
        double energy = -0.0;
        fill();
        double *const to[] = {&energy, &memory[0].at.y, &memory[N - 1].pull.z, &memory[N].pull.x, &memory[9].mass};
        pull_all(round == 4 ? 2 : N, to[round], round == 1 ? 1e6 : 20.0);
        CASE_PRINT(memory);
        CASE_PRINT(&energy);
        by_list(4 * N, memory, first, second);
        by_parts(N, memory + round % 2, begin, end);
        by_pointers(N - round, memory + round / 2, 0.25);
        by_moved_pointers(4 * N, memory, first, second);
        struct system inner = {memory}, *outer = &inner;
        behind_a_record(4 * N, &outer, round * 50, first, near);
        CASE_PRINT(memory);
    }
}
