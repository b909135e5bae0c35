/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The barrier's energy B (barrier.h), its gradient, and a positive semidefinite approximation of
 * its Hessian.
 *
 * Let x_k be the vertices' positions and w_k the weights of the nearest points (nearest.h). With u
 * = sum w_k x_k, d = |u| and n = u / d, the gradient of d with respect to x_k is exactly w_k n: at
 * the nearest points, changes of the weights do not contribute. With B' and B'' the derivatives of
 * B with respect to d, block (i, j) of the Hessian is
 *
 *     B'' w_i w_j n n' + B' d_ij,   B'' > 0, B' < 0, d_ij: second derivative of d
 *
 * Only the first term is used, which is positive semidefinite (Gauss-Newton). Newton's method still
 * converges to a zero of the gradient. The factor e(c) for parallel edges is treated in the same
 * way: its term of the Hessian is B de/dc 2 J'J with the Jacobian J of e1 x e2.
 */
#include "barrier.h"

#include <assert.h>
#include <string.h>

#include "base/chunk_sum.h"
#include "base/vector.h"

/* The energy as a function of the distance, with its derivatives. */
typedef struct curve {
    double value, first, second; /* J, N, N/m */
} curve;

static curve barrier_curve(double stiffness, double reach, double distance) {
    assert(stiffness >= 0 && reach > 0);
    const double s = distance / reach, past = s - 1;
    if (!(s > 0))
        return (curve){INFINITY, 0, 0};
    if (s >= 1)
        return (curve){0, 0, 0};
    const double l = log(s);
    return (curve){-stiffness * past * past * l,
                   -stiffness / reach * (2 * past * l + past * past / s),
                   -stiffness / (reach * reach) * (2 * l + 4 * past / s - past * past / (s * s))};
}

/* The factor for edges that are nearly parallel. */
typedef struct mollifier {
    double value, slope; /* e and de/dc; 1 and 0 if the edges are not nearly parallel */
    double cross[3];     /* e1 x e2, m^2 */
    double edge[2][3];   /* m */
} mollifier;

static double square_of_edge(const mesh *m, int i, int j) {
    double edge[3];
    vector_subtract(m->position[i], m->position[j], edge);
    return vector_dot(edge, edge);
}

static mollifier mollify(const barrier *b, const barrier_pair *pair, const double x[4][3]) {
    mollifier m = {.value = 1};
    if (pair->kind != BARRIER_EDGES)
        return m;
    const int *v = pair->vertex;
    const double eps =
        1e-3 * square_of_edge(&b->surface, v[0], v[1]) * square_of_edge(&b->surface, v[2], v[3]);
    vector_subtract(x[1], x[0], m.edge[0]);
    vector_subtract(x[3], x[2], m.edge[1]);
    vector_cross(m.edge[0], m.edge[1], m.cross);
    const double c = vector_dot(m.cross, m.cross);
    if (c < eps) {
        m.value = (2 - c / eps) * c / eps;
        m.slope = 2 * (1 - c / eps) / eps;
    }
    return m;
}

/* Returns the normal force of the pair, N. */
static double force_of(const barrier *b, const barrier_contact *touch, const double (*x)[3]) {
    double at[4][3];
    barrier_gather(touch->pair.vertex, x, at);
    return -mollify(b, &touch->pair, (const double(*)[3])at).value *
           barrier_curve(b->stiffness, touch->pair.reach, touch->at.distance).first;
}

double barrier_energy(const barrier *b, const double (*x)[3]) {
    double sum[CHUNK_SUM_MOST] = {0};
    const int count = b->list.pairs;
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int k = chunk * chunk_sum_length(count); k < chunk_sum_end(count, chunk); k++) {
            const barrier_pair *pair = &b->list.pair[k];
            double at[4][3];
            nearest found;
            barrier_gather(pair->vertex, x, at);
            barrier_nearest(b, pair, (const double(*)[3])at, &found);
            if (found.distance < pair->reach)
                sum[chunk] += mollify(b, pair, (const double(*)[3])at).value *
                              barrier_curve(b->stiffness, pair->reach, found.distance).value;
        }
    return chunk_sum_all(count, sum);
}

/* block (p, q) += factor a_p a_q M for p <= q, with the weights a. */
static void add_blocks(double factor, const double weight[4], const double m[3][3],
                       double block[10][3][3]) {
    int k = 0;
    for (int p = 0; p < 4; p++)
        for (int q = p; q < 4; q++, k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    block[k][r][c] += factor * weight[p] * weight[q] * m[r][c];
}

/* Adds the terms of the factor e. When vertex k moves by dx, y = e1 x e2 changes by J_k dx = sign
 * (other x dx); `other` is the edge without vertex k. */
static void add_mollifier(double energy, const mollifier *m, barrier_element *e) {
    static const double sign[4] = {1, -1, -1, 1};
    int k = 0;
    for (int p = 0; p < 4; p++) {
        double turned[3]; /* J_p' cross */
        const double *other = m->edge[p < 2];
        vector_cross(m->cross, other, turned);
        vector_add_scaled(e->gradient[p], 2 * energy * m->slope * sign[p], turned, e->gradient[p]);
        for (int q = p; q < 4; q++, k++) {
            const double *of = m->edge[q < 2], both = vector_dot(other, of);
            const double factor = 2 * energy * m->slope * sign[p] * sign[q];
            for (int r = 0; r < 3; r++) /* J_p' J_q = (a.b) I - b a' with a = other, b = of */
                for (int c = 0; c < 3; c++)
                    e->block[k][r][c] += factor * ((r == c ? both : 0) - of[r] * other[c]);
        }
    }
}

static void make_contact(const barrier *b, const barrier_contact *touch, const double (*x)[3],
                         barrier_element *e) {
    const curve of = barrier_curve(b->stiffness, touch->pair.reach, touch->at.distance);
    double at[4][3], across[3][3];
    barrier_gather(touch->pair.vertex, x, at);
    const mollifier m = mollify(b, &touch->pair, (const double(*)[3])at);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            across[r][c] = touch->at.normal[r] * touch->at.normal[c];
    for (int k = 0; k < 4; k++)
        vector_add_scaled(e->gradient[k], m.value * of.first * touch->at.weight[k],
                          touch->at.normal, e->gradient[k]);
    add_blocks(m.value * of.second, touch->at.weight, (const double(*)[3])across, e->block);
    if (m.slope > 0)
        add_mollifier(of.value, &m, e);
}

/* Computes how far the features have slipped along each other since the step began. Returns the
 * length, m. */
static double slip_of(const barrier *b, const barrier_grip *grip, const double (*x)[3],
                      double slip[3]) {
    const nearest *at = &grip->touch.at;
    for (int a = 0; a < 3; a++) {
        slip[a] = 0;
        for (int k = 0; k < 4; k++) {
            const int i = grip->touch.pair.vertex[k];
            slip[a] += at->weight[k] * (x[i][a] - b->begin[i][a]);
        }
    }
    vector_add_scaled(slip, -vector_dot(slip, at->normal), at->normal, slip);
    return vector_length(slip);
}

/*
 * Li et al. 2020, equations 19 to 21: with the greatest friction force `most`, a slip of y m has
 * the potential most f0(y), f0' = f1, with
 *     f1 = 2 y / e - (y / e)^2   y < e = h slip_speed, else 1
 */
double barrier_friction(const barrier *b, double h, const double (*x)[3]) {
    assert(h > 0 && b->slip_speed > 0);
    double sum[CHUNK_SUM_MOST] = {0};
    const double e = h * b->slip_speed;
    const int count = b->list.grips;
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int k = chunk * chunk_sum_length(count); k < chunk_sum_end(count, chunk); k++) {
            double slip[3];
            const double y = slip_of(b, &b->list.grip[k], x, slip);
            sum[chunk] +=
                b->list.grip[k].most * (y < e ? y * y / e - y * y * y / (3 * e * e) + e / 3 : y);
        }
    return chunk_sum_all(count, sum);
}

/* The Hessian, `most` times f1 / y (I - n n' - t t') + f1' t t' with t = slip / y, is positive
 * semidefinite. */
static void make_grip(const barrier *b, const barrier_grip *grip, double h, const double (*x)[3],
                      barrier_element *e) {
    const double small = h * b->slip_speed;
    double slip[3], m[3][3];
    const double y = slip_of(b, grip, x, slip);
    const double f1_over_y = grip->most * (y < small ? (2 - y / small) / small : 1 / y);
    const double along = grip->most * (y < small ? 2 * (1 - y / small) / small : 0);
    const double *n = grip->touch.at.normal;
    for (int k = 0; k < 4; k++)
        vector_add_scaled(e->gradient[k], f1_over_y * grip->touch.at.weight[k], slip,
                          e->gradient[k]);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            m[r][c] = f1_over_y * ((r == c ? 1 : 0) - n[r] * n[c]) +
                      (y > 0 ? (along - f1_over_y) * slip[r] * slip[c] / (y * y) : 0);
    add_blocks(1, grip->touch.at.weight, (const double(*)[3])m, e->block);
}

static double friction_of(const barrier *b, const barrier_pair *pair) {
    return pair->collider >= 0 ? b->scene->colliders[pair->collider].friction
                               : b->scene->self_collision.friction;
}

int barrier_grip_contacts(barrier *b) {
    barrier_list *list = &b->list;
    list->grips = 0;
    if (array_grow(&list->grip, &list->grip_room, list->contacts, sizeof *list->grip) != 0)
        return -1;
    for (int k = 0; k < list->contacts; k++) {
        const barrier_contact *touch = &list->contact[k];
        const double most =
            friction_of(b, &touch->pair) * force_of(b, touch, (const double(*)[3])b->begin);
        if (most > 0)
            list->grip[list->grips++] = (barrier_grip){*touch, most};
    }
    return 0;
}

int barrier_make_elements(barrier *b, double h, const double (*x)[3]) {
    barrier_list *list = &b->list;
    list->elements = 0;
    if (array_grow(&list->element, &list->element_room, (long)list->contacts + list->grips,
                   sizeof *list->element) != 0)
        return -1;
    list->elements = list->contacts + list->grips;
#pragma omp parallel for schedule(static)
    for (int k = 0; k < list->elements; k++) {
        barrier_element *e = &list->element[k];
        const barrier_grip *grip = k < list->contacts ? NULL : &list->grip[k - list->contacts];
        const barrier_contact *touch = grip ? &grip->touch : &list->contact[k];
        memset(e, 0, sizeof *e);
        memcpy(e->vertex, touch->pair.vertex, sizeof e->vertex);
        if (grip)
            make_grip(b, grip, h, x, e);
        else
            make_contact(b, touch, x, e);
    }
    return 0;
}
