/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The passes of an iteration. */
#include "solver_domains_parts.h"

#include "base/vector.h"

/* Subtracts the row of U times x from t. */
static inline void subtract_row(const block_matrix *U, int row, const double (*x)[3], double t[3]) {
    double t0 = t[0], t1 = t[1], t2 = t[2];
    for (int k = U->row_start[row]; k < U->row_start[row + 1]; k++) {
        const double *y = x[U->column[k]];
        const double(*u)[3] = (const double(*)[3])U->value[k];
        t0 -= u[0][0] * y[0] + u[0][1] * y[1] + u[0][2] * y[2];
        t1 -= u[1][0] * y[0] + u[1][1] * y[1] + u[1][2] * y[2];
        t2 -= u[2][0] * y[0] + u[2][1] * y[1] + u[2][2] * y[2];
    }
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
}

/* Hardware prefetchers do not predict descending rows with ascending blocks, so a row is prefetched
 * this number of rows ahead. */
enum { ROWS_AHEAD = 16 };

void domain_sweep_up(const domain_solver *d, int domain, const double (*from)[3], double (*to)[3]) {
    const block_matrix *within = &d->within;
    for (int i = d->start[domain + 1] - 1; i >= d->start[domain]; i--) {
        double t[3] = {from[i][0], from[i][1], from[i][2]};
        const int next = i > ROWS_AHEAD ? i - ROWS_AHEAD : 0;
        for (int k = within->row_start[next]; k < within->row_start[next + 1]; k++)
            __builtin_prefetch(within->value[k]);
        subtract_row(&d->across, i, (const double(*)[3])to, t); /* an odd domain's row is empty */
        subtract_row(within, i, (const double(*)[3])to, t);
        for (int a = 0; a < 3; a++)
            to[i][a] = t[a];
    }
}

/* Subtracts from r[column] the transposed column of `across` times r of even domains, which are
 * swept before. */
static void subtract_column(const domain_solver *d, int column, double (*r)[3]) {
    double t0 = 0, t1 = 0, t2 = 0;
    for (int k = d->columns.start[column]; k < d->columns.start[column + 1]; k++) {
        const double *w = r[d->columns.entry[k].row];
        const double(*u)[3] = (const double(*)[3])d->across.value[d->columns.entry[k].block];
        t0 -= u[0][0] * w[0] + u[1][0] * w[1] + u[2][0] * w[2];
        t1 -= u[0][1] * w[0] + u[1][1] * w[1] + u[2][1] * w[2];
        t2 -= u[0][2] * w[0] + u[1][2] * w[1] + u[2][2] * w[2];
    }
    r[column][0] += t0;
    r[column][1] += t1;
    r[column][2] += t2;
}

void domain_sweep_down(const domain_solver *d, int domain, double (*r)[3]) {
    const block_matrix *U = &d->within;
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++) {
        subtract_column(d, i, r); /* an even domain's column is empty */
        for (int k = U->row_start[i]; k < U->row_start[i + 1]; k++) {
            /* r[i] is read here and not in front of the loop. Otherwise redcc would consider this
             * loop, whose rows are too short to run in parallel. */
            const double w0 = r[i][0], w1 = r[i][1], w2 = r[i][2];
            double *y = r[U->column[k]];
            const double(*u)[3] = (const double(*)[3])U->value[k];
            y[0] -= u[0][0] * w0 + u[1][0] * w1 + u[2][0] * w2;
            y[1] -= u[0][1] * w0 + u[1][1] * w1 + u[2][1] * w2;
            y[2] -= u[0][2] * w0 + u[1][2] * w1 + u[2][2] * w2;
        }
    }
}

void domain_scale(domain_solver *d, const double (*r)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < d->A->row_count; i++) {
        const double(*root)[3] = (const double(*)[3])d->root[i];
        d->residual[i][0] = root[0][0] * r[i][0];
        d->residual[i][1] = root[1][0] * r[i][0] + root[1][1] * r[i][1];
        d->residual[i][2] = root[2][0] * r[i][0] + root[2][1] * r[i][1] + root[2][2] * r[i][2];
    }
}

double domain_transform(domain_solver *d, int domain) {
    double sum = 0;
    if (domain % 2)
        domain_sweep_down(d, domain, d->residual);
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++)
        sum += vector_dot(d->residual[i], d->residual[i]);
    return sum;
}

void domain_sweep_direction(domain_solver *d, int domain) {
    const int whole = !d->has_between;
    domain_sweep_up(d, domain, (const double(*)[3])d->direction, d->swept);
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++)
        for (int a = 0; a < 3; a++)
            d->image[i][a] =
                d->direction[i][a] + (whole ? vector_dot(d->between.value[i][a], d->swept[i]) : 0);
    if (whole && domain % 2 == 0)
        domain_sweep_down(d, domain, d->image);
}

/* Computes the image of p at vertex i, t + (I + U)^-T w. It is not stored, because odd domains read
 * w of even domains while they are swept down. */
static inline void image_at(const domain_solver *d, int i, double image[3]) {
    vector_add_scaled(d->image[i], 1, d->swept[i], image);
}

double domain_finish_image(domain_solver *d, int domain) {
    double sum = 0;
    if (domain % 2)
        domain_sweep_down(d, domain, d->image);
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++) {
        double image[3];
        image_at(d, i, image);
        sum += vector_dot(d->direction[i], image);
    }
    return sum;
}

double domain_advance(domain_solver *d, int domain, double alpha) {
    double sum = 0;
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++) {
        double image[3];
        image_at(d, i, image);
        vector_add_scaled(d->correction[i], alpha, d->direction[i], d->correction[i]);
        vector_add_scaled(d->residual[i], -alpha, image, d->residual[i]);
        sum += vector_dot(d->residual[i], d->residual[i]);
    }
    return sum;
}

void domain_update_direction(domain_solver *d, int domain, double beta) {
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++)
        vector_add_scaled(d->residual[i], beta, d->direction[i], d->direction[i]);
}

void domain_add_correction(const domain_solver *d, double (*dv)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < d->A->row_count; i++) {
        const double(*root)[3] = (const double(*)[3])d->root[i];
        const double *y = d->correction[i];
        dv[i][0] += root[0][0] * y[0] + root[1][0] * y[1] + root[2][0] * y[2];
        dv[i][1] += root[1][1] * y[1] + root[2][1] * y[2];
        dv[i][2] += root[2][2] * y[2];
    }
}
