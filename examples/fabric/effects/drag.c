/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Air drag and wind (see drag.h for the force). */
#include "drag.h"

#include "../vector.h"

/* d = h drag (a / 3) n n', from the edges' cross product 2 a n; 0 for a collapsed triangle. */
static void drag_matrix(const double (*x)[3], int i, int j, int k, double factor, double d[3][3]) {
    double one[3], other[3], cross[3];
    double length, scale;
    int r, c;
    vector_subtract(x[j], x[i], one);
    vector_subtract(x[k], x[i], other);
    vector_cross(one, other, cross);
    length = vector_length(cross);
    scale = length > 0 ? factor / (6 * length) : 0;
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++)
            d[r][c] = scale * cross[r] * cross[c];
}

void drag_forces(const triangle_elements *e, double drag, const double wind[3], double h,
                 const double (*x)[3], const double (*v)[3], linear_system *s) {
    int t, i, j, k, ii, jj, kk, r, c;
    double d[3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        ii = s->A.row_start[i];
        jj = s->A.row_start[j];
        kk = s->A.row_start[k];
        drag_matrix(x, i, j, k, h * drag, d);
        for (r = 0; r < 3; r++)
            for (c = 0; c < 3; c++) {
                s->b[i][r] -= d[r][c] * (v[i][c] - wind[c]);
                s->b[j][r] -= d[r][c] * (v[j][c] - wind[c]);
                s->b[k][r] -= d[r][c] * (v[k][c] - wind[c]);
                s->A.value[ii][r][c] += d[r][c];
                s->A.value[jj][r][c] += d[r][c];
                s->A.value[kk][r][c] += d[r][c];
            }
    }
}
