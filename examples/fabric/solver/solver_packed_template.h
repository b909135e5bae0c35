/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Conjugate gradients on the preconditioned matrix. This file is included once per number type:
 * REAL is the type, PACKED(name) the name for it. The prefiltered matrix B = S A S + s (I - S)
 * (solver_precondition.h) is stored scaled, as A^ = C^-1 B C^-T = D^ + U + U'. C C' are the
 * preconditioner's diagonal blocks, D^ is the diagonal of A^, and U is strictly upper. The
 * iteration runs on
 *  - A^ itself (M = C C') without a preconditioner, and for Jacobi and block-Jacobi
 *  - (I + U)^-T A^ (I + U)^-1 for symmetric Gauss-Seidel
 *  - (I + F)^-T A^ (I + F)^-1 for incomplete Cholesky (F: solver_factor.h)
 * Gauss-Seidel needs no product with A^ (Eisenstat 1981): with t = (I + U)^-1 p the image of a
 * direction p is t + (I + U)^-T (p + (D^ - 2 I) t), two sweeps over U.
 */

typedef struct PACKED(system) {
    const REAL (*diagonal)[6]; /* D^, or D^ - 2 I: xx xy xz yy yz zz */
    const REAL (*upper)[3][3]; /* U, indexed as A's blocks; entries of diagonal blocks are unused */
    const REAL (*factor)[3][3]; /* F; NULL unless incomplete Cholesky */
    const REAL (*root)[3][3];   /* C^-1, lower triangles */
    REAL (*direction)[3];       /* p */
    REAL (*residual)[3];        /* residual of the transformed system */
    REAL (*correction)[3];      /* solution of the transformed system */
    REAL (*swept)[3];           /* t */
    REAL (*image)[3];
} PACKED(system);

/* Allocates the vectors; the caller sets the pointers to blocks. */
static void PACKED(allocate)(PACKED(system) * p, const block_matrix *A, arrays *own) {
    const size_t rows = (size_t)A->row_count + 1;
    p->direction = arrays_add(own, rows, sizeof *p->direction);
    p->residual = arrays_add(own, rows, sizeof *p->residual);
    p->correction = arrays_add(own, rows, sizeof *p->correction);
    p->swept = arrays_add(own, rows, sizeof *p->swept);
    p->image = arrays_add(own, rows, sizeof *p->image);
}

/* Computes to = (I + W)^-1 from, from the last row to the first. `to` and `from` may be the same
 * array. */
static void PACKED(sweep_up)(const block_matrix *A, const REAL (*W)[3][3], const REAL (*from)[3],
                             REAL (*to)[3]) {
    for (int i = A->row_count - 1; i >= 0; i--) {
        REAL t0 = from[i][0], t1 = from[i][1], t2 = from[i][2];
        for (int k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            const REAL *x = to[A->column[k]];
            t0 -= W[k][0][0] * x[0] + W[k][0][1] * x[1] + W[k][0][2] * x[2];
            t1 -= W[k][1][0] * x[0] + W[k][1][1] * x[1] + W[k][1][2] * x[2];
            t2 -= W[k][2][0] * x[0] + W[k][2][1] * x[1] + W[k][2][2] * x[2];
        }
        to[i][0] = t0;
        to[i][1] = t1;
        to[i][2] = t2;
    }
}

/* Replaces r by (I + W)^-T r. */
static void PACKED(sweep_down)(const block_matrix *A, const REAL (*W)[3][3], REAL (*r)[3]) {
    for (int i = 0; i < A->row_count; i++) {
        const REAL w0 = r[i][0], w1 = r[i][1], w2 = r[i][2];
        for (int k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            REAL *y = r[A->column[k]];
            y[0] -= W[k][0][0] * w0 + W[k][1][0] * w1 + W[k][2][0] * w2;
            y[1] -= W[k][0][1] * w0 + W[k][1][1] * w1 + W[k][2][1] * w2;
            y[2] -= W[k][0][2] * w0 + W[k][1][2] * w1 + W[k][2][2] * w2;
        }
    }
}

/* out = D x for a symmetric D */
static inline void PACKED(multiply)(const REAL D[6], const REAL x[3], REAL out[3]) {
    out[0] = D[0] * x[0] + D[1] * x[1] + D[2] * x[2];
    out[1] = D[1] * x[0] + D[3] * x[1] + D[4] * x[2];
    out[2] = D[2] * x[0] + D[4] * x[1] + D[5] * x[2];
}

/* image = A^ p. Returns p . image. */
static double PACKED(image_plain)(const PACKED(system) * s, const block_matrix *A) {
    double sum = 0;
    memset(s->image, 0, sizeof *s->image * (size_t)A->row_count);
    for (int i = 0; i < A->row_count; i++) {
        const REAL *x = s->direction[i];
        const REAL x0 = x[0], x1 = x[1], x2 = x[2];
        REAL y[3];
        PACKED(multiply)(s->diagonal[i], x, y);
        for (int k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            const REAL(*u)[3] = s->upper[k];
            const REAL *xj = s->direction[A->column[k]];
            REAL *yj = s->image[A->column[k]];
            y[0] += u[0][0] * xj[0] + u[0][1] * xj[1] + u[0][2] * xj[2];
            y[1] += u[1][0] * xj[0] + u[1][1] * xj[1] + u[1][2] * xj[2];
            y[2] += u[2][0] * xj[0] + u[2][1] * xj[1] + u[2][2] * xj[2];
            yj[0] += u[0][0] * x0 + u[1][0] * x1 + u[2][0] * x2;
            yj[1] += u[0][1] * x0 + u[1][1] * x1 + u[2][1] * x2;
            yj[2] += u[0][2] * x0 + u[1][2] * x1 + u[2][2] * x2;
        }
        for (int a = 0; a < 3; a++)
            s->image[i][a] += y[a];
        sum += (double)(x0 * s->image[i][0] + x1 * s->image[i][1] + x2 * s->image[i][2]);
    }
    return sum;
}

/* image = t + (I + U)^-T (p + (D^ - 2 I) t). Returns p . image. */
static double PACKED(image_gauss_seidel)(const PACKED(system) * s, const block_matrix *A) {
    const REAL(*restrict upper)[3][3] = s->upper;
    REAL(*restrict image)[3] = s->image;
    double sum = 0;
    PACKED(sweep_up)(A, upper, (const REAL(*)[3])s->direction, s->swept);
    memset(image, 0, sizeof *image * (size_t)A->row_count);
    for (int i = 0; i < A->row_count; i++) {
        const REAL *p = s->direction[i], *t = s->swept[i];
        REAL w[3];
        PACKED(multiply)(s->diagonal[i], t, w);
        for (int a = 0; a < 3; a++)
            w[a] += p[a] + image[i][a];
        for (int k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            REAL *y = image[A->column[k]];
            y[0] -= upper[k][0][0] * w[0] + upper[k][1][0] * w[1] + upper[k][2][0] * w[2];
            y[1] -= upper[k][0][1] * w[0] + upper[k][1][1] * w[1] + upper[k][2][1] * w[2];
            y[2] -= upper[k][0][2] * w[0] + upper[k][1][2] * w[1] + upper[k][2][2] * w[2];
        }
        for (int a = 0; a < 3; a++)
            image[i][a] = t[a] + w[a];
        sum += (double)(p[0] * image[i][0] + p[1] * image[i][1] + p[2] * image[i][2]);
    }
    return sum;
}

/* image = (I + F)^-T A^ (I + F)^-1 p. Returns p . image. The product and the second sweep share one
 * loop. */
static double PACKED(image_factored)(const PACKED(system) * s, const block_matrix *A) {
    REAL(*restrict image)[3] = s->image;
    double sum = 0;
    PACKED(sweep_up)(A, s->factor, (const REAL(*)[3])s->direction, s->swept);
    memset(image, 0, sizeof *image * (size_t)A->row_count);
    for (int i = 0; i < A->row_count; i++) {
        const REAL *p = s->direction[i], *t = s->swept[i];
        REAL w[3];
        PACKED(multiply)(s->diagonal[i], t, w);
        for (int k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            const REAL(*u)[3] = s->upper[k];
            const REAL *x = s->swept[A->column[k]];
            for (int a = 0; a < 3; a++)
                w[a] += u[a][0] * x[0] + u[a][1] * x[1] + u[a][2] * x[2];
        }
        for (int a = 0; a < 3; a++)
            w[a] += image[i][a];
        for (int k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            const REAL(*u)[3] = s->upper[k];
            const REAL(*f)[3] = s->factor[k];
            REAL *y = image[A->column[k]];
            for (int a = 0; a < 3; a++)
                y[a] += (u[0][a] * t[0] + u[1][a] * t[1] + u[2][a] * t[2]) -
                        (f[0][a] * w[0] + f[1][a] * w[1] + f[2][a] * w[2]);
        }
        for (int a = 0; a < 3; a++)
            image[i][a] = w[a];
        sum += (double)(p[0] * w[0] + p[1] * w[1] + p[2] * w[2]);
    }
    return sum;
}

static double PACKED(make_image)(const PACKED(system) * s, const block_matrix *A,
                                 preconditioner_kind kind) {
    switch (kind) {
    case PRECONDITIONER_GAUSS_SEIDEL:
        return PACKED(image_gauss_seidel)(s, A);
    case PRECONDITIONER_INCOMPLETE_CHOLESKY:
        return PACKED(image_factored)(s, A);
    default:
        return PACKED(image_plain)(s, A);
    }
}

/* Returns the blocks for the sweeps before and after the iteration, or NULL if there are none. */
static const REAL (*PACKED(swept_blocks)(const PACKED(system) * s,
                                         preconditioner_kind kind))[3][3] {
    if (kind == PRECONDITIONER_GAUSS_SEIDEL)
        return s->upper;
    return kind == PRECONDITIONER_INCOMPLETE_CHOLESKY ? s->factor : NULL;
}

/* Sets the residual to the transformed r. Returns its squared norm, r' M^-1 r. */
static double PACKED(transform)(const PACKED(system) * s, const block_matrix *A,
                                preconditioner_kind kind, const double (*r)[3]) {
    const REAL(*W)[3][3] = PACKED(swept_blocks)(s, kind);
    double sum = 0;
    for (int i = 0; i < A->row_count; i++) {
        const REAL(*root)[3] = s->root[i];
        const REAL in[3] = {(REAL)r[i][0], (REAL)r[i][1], (REAL)r[i][2]};
        s->residual[i][0] = root[0][0] * in[0];
        s->residual[i][1] = root[1][0] * in[0] + root[1][1] * in[1];
        s->residual[i][2] = root[2][0] * in[0] + root[2][1] * in[1] + root[2][2] * in[2];
    }
    if (W)
        PACKED(sweep_down)(A, W, s->residual);
    for (int i = 0; i < A->row_count; i++)
        for (int a = 0; a < 3; a++)
            sum += (double)s->residual[i][a] * (double)s->residual[i][a];
    return sum;
}

/* Adds the correction to dv, transformed back to the system's variables. */
static void PACKED(add_correction)(const PACKED(system) * s, const block_matrix *A,
                                   preconditioner_kind kind, double (*dv)[3]) {
    const REAL(*W)[3][3] = PACKED(swept_blocks)(s, kind);
    if (W)
        PACKED(sweep_up)(A, W, (const REAL(*)[3])s->correction, s->correction);
    for (int i = 0; i < A->row_count; i++) {
        const REAL(*root)[3] = s->root[i];
        const REAL *y = s->correction[i];
        dv[i][0] += (double)(root[0][0] * y[0] + root[1][0] * y[1] + root[2][0] * y[2]);
        dv[i][1] += (double)(root[1][1] * y[1] + root[2][1] * y[2]);
        dv[i][2] += (double)(root[2][2] * y[2]);
    }
}

/* Adds alpha p to the correction and subtracts alpha image from the residual. Returns the
 * residual's squared norm. */
static double PACKED(advance)(const PACKED(system) * s, int count, REAL alpha) {
    double sum[3] = {0, 0, 0};
    for (int i = 0; i < count; i++)
        for (int a = 0; a < 3; a++) {
            s->correction[i][a] += alpha * s->direction[i][a];
            s->residual[i][a] -= alpha * s->image[i][a];
            sum[a] += (double)(s->residual[i][a] * s->residual[i][a]);
        }
    return sum[0] + sum[1] + sum[2];
}

static void PACKED(update_direction)(const PACKED(system) * s, int count, REAL beta) {
    for (int i = 0; i < count; i++)
        for (int a = 0; a < 3; a++)
            s->direction[i][a] = s->residual[i][a] + beta * s->direction[i][a];
}

/* Iterates from the residual that PACKED(transform) computed, until its squared norm, at first
 * `square`, is at most `goal`. */
static solver_status PACKED(iterate)(const PACKED(system) * s, const block_matrix *A,
                                     preconditioner_kind kind, double square, double goal,
                                     long most, long *iterations) {
    const int count = A->row_count;
    memset(s->correction, 0, sizeof *s->correction * (size_t)count);
    memcpy(s->direction, s->residual, sizeof *s->direction * (size_t)count);
    for (long k = 0;; k++) {
        if (!isfinite(square))
            return SOLVER_NOT_FINITE;
        if (square <= goal)
            return SOLVER_CONVERGED;
        if (k == most)
            return SOLVER_TOO_MANY_ITERATIONS;
        const double curvature = PACKED(make_image)(s, A, kind);
        ++*iterations;
        if (!isfinite(curvature))
            return SOLVER_NOT_FINITE;
        if (!(curvature > 0))
            return SOLVER_BREAKDOWN;
        const double before = square;
        square = PACKED(advance)(s, count, (REAL)(before / curvature));
        PACKED(update_direction)(s, count, (REAL)(square / before));
    }
}
