/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Explicit dynamics of a linear elastic block of eight-node bricks, struck at one end.
 *
 * bricks SIDE STEPS >displacements
 *
 * A bar of SIDE x SIDE x 4 SIDE bricks, whose nodes are displaced irregularly, is fixed at z = 0;
 * its far end starts with a velocity. Central differences with lumped masses integrate the motion.
 * In each step a loop over the elements gathers the displacements of eight nodes and computes the
 * stresses at the centre (one-point integration). It adds a stiffness against the hourglass modes,
 * which have no strain at the centre, in the manner of Flanagan and Belytschko but without their
 * correction for distorted elements, and scatters the nodal forces. Every fiftieth step prints the
 * kinetic energy and the tip's displacement. At the end the program prints all displacements.
 *
 * T. J. R. Hughes, The Finite Element Method, Prentice-Hall 1987, chapter 9; D. P. Flanagan and T.
 * Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define YOUNG 70.0e9
#define POISSON 0.3
#define DENSITY 2700.0
#define HOURGLASS 0.05

struct mesh {
    int nnode, nelem;
    double (*x)[3];       /* positions of the nodes, m */
    int (*conn)[8];       /* [elements] the nodes of each element */
    double (*grad)[8][3]; /* [elements] derivatives of the shape functions at the centre */
    double *volume;
};

static const double corner[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
static const double mode[4][8] = {{1, 1, -1, -1, -1, -1, 1, 1},
                                  {1, -1, -1, 1, -1, 1, 1, -1},
                                  {1, -1, 1, -1, 1, -1, 1, -1},
                                  {-1, 1, -1, 1, 1, -1, 1, -1}};

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) {
        fprintf(stderr, "bricks: out of memory\n");
        exit(1);
    }
    return memory;
}

/* Makes a bar of n x n x 4 n bricks, 1 m thick. Each coordinate of each node is displaced by up to
 * a tenth of a brick's edge. */
static void make_mesh(struct mesh *m, int n) {
    const int row = n + 1, layer = row * row;
    const double h = 1.0 / n;
    m->nnode = layer * (4 * n + 1);
    m->nelem = n * n * 4 * n;
    m->x = allocate(m->nnode, sizeof *m->x);
    m->conn = allocate(m->nelem, sizeof *m->conn);
    m->grad = allocate(m->nelem, sizeof *m->grad);
    m->volume = allocate(m->nelem, sizeof *m->volume);
    for (int p = 0; p < m->nnode; p++) {
        m->x[p][0] = h * (p % row) + 0.1 * h * sin(12.9898 * p);
        m->x[p][1] = h * (p / row % row) + 0.1 * h * sin(78.233 * p);
        m->x[p][2] = h * (p / layer) + 0.1 * h * sin(37.719 * p);
    }
    for (int e = 0; e < m->nelem; e++) {
        const int p = e % n + e / n % n * row + e / (n * n) * layer;
        const int node[8] = {p,         p + 1,         p + row + 1,         p + row,
                             p + layer, p + layer + 1, p + layer + row + 1, p + layer + row};
        for (int a = 0; a < 8; a++)
            m->conn[e][a] = node[a];
    }
}

/* Computes the element's volume, and the derivatives of the trilinear shape functions at its
 * centre, from the inverse of J. J is the Jacobian of the map from the reference cube to the
 * element. */
static void shape_functions(struct mesh *m, int e) {
    double J[3][3] = {{0}}, I[3][3];
    for (int a = 0; a < 8; a++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                J[i][j] += 0.125 * corner[a][i] * m->x[m->conn[e][a]][j];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            I[j][i] = J[i1][j1] * J[i2][j2] - J[i1][j2] * J[i2][j1];
        }
    const double det = J[0][0] * I[0][0] + J[0][1] * I[1][0] + J[0][2] * I[2][0];
    m->volume[e] = 8.0 * det;
    for (int a = 0; a < 8; a++)
        for (int j = 0; j < 3; j++) {
            m->grad[e][a][j] = 0;
            for (int i = 0; i < 3; i++)
                m->grad[e][a][j] += 0.125 * corner[a][i] * I[j][i] / det;
        }
}

/* Computes the nodal forces f of an element from its nodes' displacements u. */
static void element_force(const double grad[8][3], double volume, const double u[8][3],
                          double f[8][3]) {
    const double mu = YOUNG / (2 * (1 + POISSON));
    const double lambda = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON));
    double H[3][3] = {{0}}, s[3][3], q[4][3];
    for (int a = 0; a < 8; a++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                H[i][j] += u[a][i] * grad[a][j];
    const double trace = lambda * (H[0][0] + H[1][1] + H[2][2]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            s[i][j] = volume * (mu * (H[i][j] + H[j][i]) + (i == j ? trace : 0.0));
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) {
            q[k][i] = 0;
            for (int a = 0; a < 8; a++)
                q[k][i] += mode[k][a] * u[a][i];
        }
    const double stiff = HOURGLASS * (lambda + 2 * mu) * cbrt(volume) / 8.0;
    for (int a = 0; a < 8; a++)
        for (int i = 0; i < 3; i++) {
            f[a][i] = grad[a][0] * s[i][0] + grad[a][1] * s[i][1] + grad[a][2] * s[i][2];
            for (int k = 0; k < 4; k++)
                f[a][i] += stiff * mode[k][a] * q[k][i];
        }
}

static void internal_forces(const struct mesh *m, double (*u)[3], double (*force)[3]) {
    for (int e = 0; e < m->nelem; e++) {
        double ue[8][3], fe[8][3];
        for (int a = 0; a < 8; a++)
            for (int i = 0; i < 3; i++)
                ue[a][i] = u[m->conn[e][a]][i];
        element_force(m->grad[e], m->volume[e], ue, fe);
        for (int a = 0; a < 8; a++)
            for (int i = 0; i < 3; i++)
                force[m->conn[e][a]][i] -= fe[a][i];
    }
}

static void report(const struct mesh *m, int step, const double *mass, double (*u)[3],
                   double (*v)[3]) {
    double kinetic = 0;
    for (int p = 0; p < m->nnode; p++)
        kinetic += 0.5 * mass[p] * (v[p][0] * v[p][0] + v[p][1] * v[p][1] + v[p][2] * v[p][2]);
    printf("%6d %.17g %.17g\n", step, kinetic, u[m->nnode - 1][2]);
}

/* Central differences: velocities at half steps, displacements at whole ones. */
static void integrate(const struct mesh *m, double dt, const double *mass, double (*force)[3],
                      double (*v)[3], double (*u)[3], int fixed) {
    for (int p = 0; p < m->nnode; p++)
        for (int i = 0; i < 3; i++) {
            v[p][i] = p < fixed ? 0.0 : v[p][i] + dt * force[p][i] / mass[p];
            u[p][i] += dt * v[p][i];
            force[p][i] = 0;
        }
}

int main(int argc, char **argv) {
    if (argc != 3 || atoi(argv[1]) < 2 || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: bricks SIDE (2 or more) STEPS\n");
        return 2;
    }
    const int side = atoi(argv[1]), steps = atoi(argv[2]);
    const int fixed = (side + 1) * (side + 1);
    struct mesh m;
    make_mesh(&m, side);
    double *mass = allocate(m.nnode, sizeof *mass);
    double(*u)[3] = allocate(m.nnode, sizeof *u), (*v)[3] = allocate(m.nnode, sizeof *v);
    double(*force)[3] = allocate(m.nnode, sizeof *force);
    for (int e = 0; e < m.nelem; e++) {
        shape_functions(&m, e);
        for (int a = 0; a < 8; a++)
            mass[m.conn[e][a]] += 0.125 * DENSITY * m.volume[e];
    }
    for (int p = m.nnode - fixed; p < m.nnode; p++)
        v[p][2] = -10.0;
    const double dt = 0.4 / side / sqrt(1.35 * YOUNG / DENSITY); /* below Courant's limit */
    for (int step = 1; step <= steps; step++) {
        internal_forces(&m, u, force);
        integrate(&m, dt, mass, force, v, u, fixed);
        if (step % 50 == 0)
            report(&m, step, mass, u, v);
    }
    for (int p = 0; p < m.nnode; p++)
        printf("%.17g %.17g %.17g\n", u[p][0], u[p][1], u[p][2]);
    return 0;
}
