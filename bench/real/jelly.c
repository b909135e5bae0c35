/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A block of jelly that falls on its edge: large deformations of tetrahedra, explicit in time.
 *
 *   jelly SIDE STEPS >motion
 *
 * A block of SIDE^3 cubes, each cut into five tetrahedra, is tilted above a floor. The material is
 * stable Neo-Hookean, with viscous damping. Each step adds the forces of all tetrahedra to their
 * nodes, and the forces of springs that push nodes out of the floor. Then it moves the nodes
 * (symplectic Euler). Every fiftieth step prints energies and the lowest node. At the end the
 * program prints some of the nodes.
 *
 * B. Smith, F. de Goes, T. Kim: Stable Neo-Hookean Flesh Simulation, ACM Trans. Graph. 37 (2018)
 * 12, equations 13 and 18. J. Teran, S. Blemker, V. Ng Thow Hing, R. Fedkiw: Finite Volume Methods
 * for the Simulation of Skeletal Muscle, SCA 2003.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SHEAR 4e4  /* Lame's mu, Pa */
#define BULK 2e5   /* Lame's lambda, Pa */
#define VISCOUS 15 /* Pa s */
#define DENSITY 1000.0
#define FLOOR 2e3 /* stiffness of the spring that pushes a node out of the floor, N/m */
#define GRAVITY 9.81

static int nodes, tets;
static double (*x)[3], (*v)[3], (*f)[3], *mass;
static int (*tet)[4];
static double (*rest)[3][3], *rest_volume; /* rest: inverse of the matrix of edges at rest */

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) {
        fprintf(stderr, "jelly: out of memory\n");
        exit(1);
    }
    return memory;
}

/* ---- small matrices ------------------------------------------------------------------------- */

static double determinant(double a[3][3]) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
           a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/* Computes c, the cofactors of matrix a. They are the derivatives of a's determinant with respect
 * to its entries. */
static void cofactors(double a[3][3], double c[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            c[i][j] = a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
        }
}

static void product(double a[3][3], double b[3][3], double c[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
}

/* Sets the columns of d to the edges from a tetrahedron's first node to the others. */
static void edges(const double (*of)[3], const int n[4], double d[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            d[i][j] = of[n[j + 1]][i] - of[n[0]][i];
}

/* ---- the block ------------------------------------------------------------------------------ */

static int node_at(int side, int i, int j, int k) {
    return (i * (side + 1) + j) * (side + 1) + k;
}

static void make_block(int side) {
    static const int even[5][4] = {
        {0, 1, 3, 5}, {0, 3, 2, 6}, {0, 5, 4, 6}, {3, 5, 7, 6}, {0, 3, 5, 6}};
    static const int odd[5][4] = {
        {1, 0, 4, 2}, {1, 2, 3, 7}, {1, 4, 5, 7}, {4, 2, 6, 7}, {1, 4, 2, 7}};
    const double h = 1.0 / side, turn = 0.5;
    nodes = (side + 1) * (side + 1) * (side + 1);
    tets = 5 * side * side * side;
    x = allocate(nodes, sizeof *x);
    v = allocate(nodes, sizeof *v);
    f = allocate(nodes, sizeof *f);
    mass = allocate(nodes, sizeof *mass);
    tet = allocate(tets, sizeof *tet);
    rest = allocate(tets, sizeof *rest);
    rest_volume = allocate(tets, sizeof *rest_volume);
    for (int i = 0; i <= side; i++)
        for (int j = 0; j <= side; j++)
            for (int k = 0; k <= side; k++) {
                double *p = x[node_at(side, i, j, k)];
                p[0] = i * h;
                p[1] = cos(turn) * j * h - sin(turn) * k * h;
                p[2] = sin(turn) * j * h + cos(turn) * k * h + 0.02;
            }
    int t = 0;
    for (int i = 0; i < side; i++)
        for (int j = 0; j < side; j++)
            for (int k = 0; k < side; k++)
                for (int c = 0; c < 5; c++, t++)
                    for (int a = 0; a < 4; a++) {
                        const int corner = ((i + j + k) % 2 ? odd : even)[c][a];
                        tet[t][a] = node_at(side, i + (corner >> 2), j + (corner >> 1 & 1),
                                            k + (corner & 1));
                    }
    for (t = 0; t < tets; t++) {
        double d[3][3], c[3][3];
        edges((const double(*)[3])x, tet[t], d);
        if (determinant(d) < 0) {
            const int last = tet[t][3];
            tet[t][3] = tet[t][2];
            tet[t][2] = last;
            edges((const double(*)[3])x, tet[t], d);
        }
        const double six = determinant(d);
        cofactors(d, c);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                rest[t][i][j] = c[j][i] / six;
        rest_volume[t] = six / 6;
        for (int a = 0; a < 4; a++)
            mass[tet[t][a]] += DENSITY * six / 24;
    }
}

/* ---- forces --------------------------------------------------------------------------------- */

/* Computes p, the first Piola-Kirchhoff stress, from the deformation gradient and its rate. Returns
 * the energy density. */
static double stress(double deformation[3][3], double rate[3][3], double p[3][3]) {
    const double alpha = 1 + 0.75 * SHEAR / BULK;
    double c[3][3], square = 0;
    cofactors(deformation, c);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            square += deformation[i][j] * deformation[i][j];
    const double volume = determinant(deformation);
    const double shear = SHEAR * (1 - 1 / (square + 1)), pressure = BULK * (volume - alpha);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            p[i][j] = shear * deformation[i][j] + pressure * c[i][j] + VISCOUS * rate[i][j];
    return 0.5 * SHEAR * (square - 3 - log(square + 1)) +
           0.5 * BULK * (volume - alpha) * (volume - alpha);
}

static double elastic_forces(void) {
    double energy = 0;
    for (int t = 0; t < tets; t++) {
        const int *n = tet[t];
        double d[3][3], deformation[3][3], rate[3][3], p[3][3];
        edges((const double(*)[3])x, n, d);
        product(d, rest[t], deformation);
        edges((const double(*)[3])v, n, d);
        product(d, rest[t], rate);
        energy += rest_volume[t] * stress(deformation, rate, p);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) { /* forces -V P B^T, column by column; V: volume at rest,
                                             B: inverse of the edges at rest, P: stress */
                const double force =
                    rest_volume[t] *
                    (p[i][0] * rest[t][j][0] + p[i][1] * rest[t][j][1] + p[i][2] * rest[t][j][2]);
                f[n[j + 1]][i] -= force;
                f[n[0]][i] += force;
            }
    }
    return energy;
}

static double move(double dt) {
    double kinetic = 0;
    for (int i = 0; i < nodes; i++) {
        f[i][2] -= mass[i] * GRAVITY;
        if (x[i][2] < 0) {
            f[i][2] -= FLOOR * x[i][2];
            v[i][0] *= 0.99;
            v[i][1] *= 0.99;
        }
        for (int c = 0; c < 3; c++) {
            v[i][c] += dt / mass[i] * f[i][c];
            x[i][c] += dt * v[i][c];
            kinetic += 0.5 * mass[i] * v[i][c] * v[i][c];
        }
    }
    return kinetic;
}

static double lowest(void) {
    double z = x[0][2];
    for (int i = 1; i < nodes; i++)
        z = x[i][2] < z ? x[i][2] : z;
    return z;
}

int main(int argc, char **argv) {
    if (argc != 3 || atoi(argv[1]) < 2 || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: jelly SIDE (2 or more) STEPS\n");
        return 2;
    }
    const int side = atoi(argv[1]), steps = atoi(argv[2]);
    make_block(side);
    const double dt = 0.2 / side / sqrt((BULK + 2 * SHEAR) / DENSITY);
    for (int step = 1; step <= steps; step++) {
        memset(f, 0, (size_t)nodes * sizeof *f);
        const double elastic = elastic_forces(), kinetic = move(dt);
        if (step % 50 == 0 || step == steps)
            printf("%6d %.17g %.17g %.17g\n", step, elastic, kinetic, lowest());
    }
    for (int i = 0; i < nodes; i += 1 + nodes / 5000)
        printf("%.17g %.17g %.17g\n", x[i][0], x[i][1], x[i][2]);
    return 0;
}
