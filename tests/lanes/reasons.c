/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Each reason why a loop has no form for several iterations at once (tool/plan/lane_reasons.def). A
 * comment "lanes: SLUG" marks the line that the message names; "lanes: written" marks a loop with
 * this form. */
#include <math.h>
#include <stdint.h>

struct element {
    int node[3];
    double weight[3];
    short kind;
};

typedef const double (*points)[3];
typedef const struct element *elements;

/* ---- the loop itself ---- */

void has_the_form(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) { /* lanes: written */
        const double d = p[e[t].node[0]][0];
        b[e[t].node[1]] += d * d;
    }
}

double leaves_a_sum(int n, elements e, points p, double *restrict b) {
    double sum = 0;
    for (int t = 0; t < n; t++) { /* lanes: other-values */
        const double d = p[e[t].node[0]][0];
        b[e[t].node[1]] += d;
        sum += d;
    }
    return sum;
}

/* An inner iteration that a thread skips may set errno, so one thread executes all inner
 * iterations. */
void sets_errno_in_what_is_skipped(int n, const int (*near)[4], const double *w, points p,
                                   double *restrict b) {
    for (int t = 0; t < n; t++) { /* lanes: other-values */
        const int a = near[t][0];
        for (int k = 1; k < 4; k++) {
            const int j = near[t][k];
            const double d = p[j][0] - w[k];
            const double e = sqrt(d * d + w[k]) * 0.5 + p[j][1] * w[k] - p[j][2] * d;
            b[a] += e;
            b[j] -= e;
        }
    }
}

void counted_by_a_pointer(const struct element *begin, const struct element *end, points p,
                          double *restrict b) {
    for (const struct element *at = begin; at < end; at++) { /* lanes: counter */
        const double d = p[at->node[0]][0];
        b[at->node[1]] += d;
    }
}

void without_braces(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) /* lanes: body */
        b[e[t].node[1]] += p[e[t].node[0]][0];
}

void through_pointers(int n, elements e, points p, double *const *restrict rows) {
    for (int t = 0; t < n; t++) { /* lanes: scattered */
        const double d = p[e[t].node[0]][0];
        rows[e[t].node[1]][0] += d;
    }
}

/* ---- variables and expressions ---- */

void array_of_integers(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int row[2] = {e[t].node[0], e[t].node[1]}; /* lanes: variable-type */
        const double d = p[row[0]][0];
        b[row[1]] += d;
    }
}

void of_floats(int n, elements e, points p, float *restrict b) {
    for (int t = 0; t < n; t++) { /* lanes: written */
        const float d = (float)p[e[t].node[0]][0];
        b[e[t].node[1]] += d;
    }
}

static double kept(double value) {
    static const double most[2] = {1.0, 2.0}; /* lanes: storage */
    return value < most[0] ? value : most[1];
}

void with_a_static_variable(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = kept(p[e[t].node[0]][0]);
        b[e[t].node[1]] += d;
    }
}

void of_long_doubles(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = (double)((long double)p[e[t].node[0]][0] * 3); /* lanes: operand-type */
        b[e[t].node[1]] += d;
    }
}

void steps_in_an_operand(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        int k = 0;
        double d[2];
        d[0] = p[e[t].node[0]][k++]; /* lanes: operand-effect */
        d[1] = p[e[t].node[0]][k];
        b[e[t].node[1]] += d[0] / d[1];
    }
}

void subscript_from_a_double(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = e[t].weight[0] * 2;
        const int c = (int)d & 1; /* lanes: from-double */
        const double f = p[e[t].node[1]][c];
        b[e[t].node[0]] += f;
    }
}

void array_whole(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d[3] = {p[e[t].node[0]][0], 2.0, 3.0};
        const double *const second = d + 1; /* lanes: array-as-pointer */
        const double f = *second * 2;
        b[e[t].node[1]] += f;
    }
}

void reads_in_a_choice(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double d = e[t].kind > 2 ? p[i][0] : 0.0; /* lanes: choice */
        b[e[t].node[1]] += d * d;
    }
}

void condition_of_a_double(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        double d = p[e[t].node[0]][0];
        if (d) /* lanes: condition */
            d = 1 / d;
        b[e[t].node[1]] += d;
    }
}

void named_elements(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d[3] = {[1] = p[e[t].node[0]][0]}; /* lanes: initialiser */
        b[e[t].node[1]] += d[1] - d[0];
    }
}

static struct { double x, y; } nameless[100];

void type_without_a_name(int n, elements e, double *restrict b) {
    for (int t = 0; t < n; t++) {
        __auto_type q = &nameless[e[t].node[0]]; /* lanes: spelling */
        const double d = q->x * q->y;
        b[e[t].node[1]] += d;
    }
}

/* ---- statements ---- */

void chosen_by_switch(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        double d = p[e[t].node[0]][0];
        switch (e[t].kind) { /* lanes: statement */
        case 1:
            d *= 2;
            break;
        default:
            d -= 1;
        }
        b[e[t].node[1]] += d;
    }
}

void length_of_its_own(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        double sum = 0;
        for (int k = 0; k < e[t].kind; k++) /* lanes: loop-inside */
            sum += p[e[t].node[0]][k % 3];
        b[e[t].node[1]] += sum;
    }
}

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1];
}

void calls_in_an_update(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d[2] = {p[e[t].node[0]][0], 2.0};
        b[e[t].node[1]] += dot(d, d); /* lanes: update */
    }
}

void computes_between(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double half = 0.5 * p[i][0];
        for (int c = 0; c < 3; c++) {
            switch (c) { /* lanes: beside-update */
            case 0:
                b[e[t].node[c]] += half;
                break;
            default:
                b[e[t].node[c]] -= half;
                break;
            }
        }
    }
}

void used_again(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        int i = e[t].node[0];
        double d = p[i][0];
        b[i] += d;
        i = e[t].node[1]; /* lanes: used-below */
        d = p[i][1];
        b[i] -= d;
    }
}

/* ---- functions ---- */

void exponential(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const int i = e[t].node[0];
        const double d = sqrt(p[i][0]) * log(p[i][1]); /* lanes: call */
        b[e[t].node[1]] += d;
    }
}

static int sign(double value) {
    return value < 0 ? -1 : 1;
}

void integer_of_a_function(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = sign(p[e[t].node[0]][0]); /* lanes: call */
        b[e[t].node[1]] += d;
    }
}

static void limited(points p, int i, double f[3]) {
    if (p[i][0] > 1.0)
        return; /* lanes: return */
    for (int c = 0; c < 3; c++)
        f[c] = p[i][c];
}

void returns_early(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        double f[3] = {0};
        limited(p, e[t].node[0], f);
        b[e[t].node[1]] += f[0] - f[2];
    }
}

static double element_of(points p, const int *node, int which) {
    which = node[which]; /* lanes: parameter */
    return p[which][0];
}

void assigns_a_parameter(int n, elements e, points p, double *restrict b) {
    for (int t = 0; t < n; t++) {
        const double d = element_of(p, e[t].node, 1);
        b[e[t].node[1]] += d;
    }
}

void computed_once(int n, const double *restrict x, double *restrict h) {
    for (int t = 0; t < n; t++) /* lanes: inspector */
        h[(int)(8.0 * pow(x[t], 0.25))] += 1.0;
}
