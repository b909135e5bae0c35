/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compressible flow over a bump, by finite volumes on an unstructured mesh of triangles.
 *
 *   euler SIDE STEPS >flow
 *
 * A channel 3 SIDE x SIDE nodes large, with a bump on its floor, is cut into triangles. The median
 * dual around each node is a control volume: a list of edges, each with its two nodes and a normal,
 * is all that the solver knows of the mesh. A loop over the edges adds Rusanov's flux to one node
 * and subtracts it from the other. Another loop adds up wave speeds over the edges, which give the
 * time steps. Four-stage Runge-Kutta steps lead to the steady state. Every twentieth step prints
 * the residual. At the end the program prints density and momentum at the nodes.
 *
 * D. J. Mavriplis, Annu. Rev. Fluid Mech. 29 (1997) 473; A. Jameson, W. Schmidt and E. Turkel, AIAA
 * paper 81-1259; T. J. Barth, Aspects of unstructured grids, VKI lecture series 1994-05.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GAMMA 1.4
#define MACH 0.5
#define CFL 1.2

static int nnode, nedge, nwall, nfar;
static double (*x)[2], *volume;
static int (*edge)[2];
static double (*normal)[2]; /* normal of the dual face between an edge's nodes, from first to
                             * second; its length is the face's */
static int *wall, *far_node;
static double (*wall_normal)[2], (*far_normal)[2];  /* outward normals at the boundary */
static double (*q)[4], (*q0)[4], (*res)[4], *speed; /* res: residual; q: density, momenta, energy */

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) {
        fprintf(stderr, "euler: out of memory\n");
        exit(1);
    }
    return memory;
}

static void add_edge(int a, int b, const double n[2]) {
    edge[nedge][0] = a;
    edge[nedge][1] = b;
    normal[nedge][0] = n[0];
    normal[nedge][1] = n[1];
    nedge++;
}

/* Adds a part of the dual face of edge a-b to n: the part in the triangle a, b, c, as a normal that
 * points from a to b. */
static void half_face(int a, int b, int c, double n[2]) {
    const double mx = 0.5 * (x[a][0] + x[b][0]), my = 0.5 * (x[a][1] + x[b][1]);
    const double cx = (x[a][0] + x[b][0] + x[c][0]) / 3, cy = (x[a][1] + x[b][1] + x[c][1]) / 3;
    const double tx = cx - mx, ty = cy - my;
    const double sign = (x[b][0] - x[a][0]) * ty - (x[b][1] - x[a][1]) * tx > 0 ? 1.0 : -1.0;
    n[0] += sign * ty;
    n[1] -= sign * tx;
}

static void add_area(int a, int b, int c) {
    const double twice =
        (x[b][0] - x[a][0]) * (x[c][1] - x[a][1]) - (x[b][1] - x[a][1]) * (x[c][0] - x[a][0]);
    volume[a] += twice / 6;
    volume[b] += twice / 6;
    volume[c] += twice / 6;
}

static void boundary_edge(int a, int b, int *count, int *node, double (*n)[2]) {
    for (int k = 0; k < 2; k++, (*count)++) {
        node[*count] = k ? b : a;
        n[*count][0] = 0.5 * (x[b][1] - x[a][1]);
        n[*count][1] = -0.5 * (x[b][0] - x[a][0]);
    }
}

/* Makes the mesh. Node (i, j) is in column i, from 0 to nx, and row j, from 0 to ny. Each
 * quadrilateral is cut along the diagonal from (i, j) to (i + 1, j + 1). */
static void make_mesh(int nx, int ny) {
#define NODE(i, j) ((i) * (ny + 1) + (j))
    nnode = (nx + 1) * (ny + 1);
    x = allocate(nnode, sizeof *x);
    volume = allocate(nnode, sizeof *volume);
    edge = allocate(3 * (size_t)nnode, sizeof *edge);
    normal = allocate(3 * (size_t)nnode, sizeof *normal);
    wall = allocate(4 * (nx + ny), sizeof *wall);
    far_node = allocate(4 * (nx + ny), sizeof *far_node);
    wall_normal = allocate(4 * (nx + ny), sizeof *wall_normal);
    far_normal = allocate(4 * (nx + ny), sizeof *far_normal);
    for (int i = 0; i <= nx; i++)
        for (int j = 0; j <= ny; j++) {
            const double s = 3.0 * i / nx - 1.5, t = (double)j / ny;
            const double floor = 0.08 * exp(-25 * s * s);
            x[NODE(i, j)][0] = s + 0.1 / ny * sin(12.9898 * i + 78.233 * j);
            x[NODE(i, j)][1] = floor + (1 - floor) * t;
        }
    for (int i = 0; i <= nx; i++)
        for (int j = 0; j <= ny; j++) {
            double n[3][2] = {{0}};
            const int a = NODE(i, j);
            if (i < nx && j < ny) {
                add_area(a, NODE(i + 1, j), NODE(i + 1, j + 1));
                add_area(a, NODE(i + 1, j + 1), NODE(i, j + 1));
                half_face(a, NODE(i + 1, j + 1), NODE(i + 1, j), n[0]);
                half_face(a, NODE(i + 1, j + 1), NODE(i, j + 1), n[0]);
                add_edge(a, NODE(i + 1, j + 1), n[0]);
            }
            if (i < nx) {
                if (j < ny)
                    half_face(a, NODE(i + 1, j), NODE(i + 1, j + 1), n[1]);
                if (j > 0)
                    half_face(a, NODE(i + 1, j), NODE(i, j - 1), n[1]);
                add_edge(a, NODE(i + 1, j), n[1]);
            }
            if (j < ny) {
                if (i < nx)
                    half_face(a, NODE(i, j + 1), NODE(i + 1, j + 1), n[2]);
                if (i > 0)
                    half_face(a, NODE(i, j + 1), NODE(i - 1, j), n[2]);
                add_edge(a, NODE(i, j + 1), n[2]);
            }
        }
    for (int i = 0; i < nx; i++) {
        boundary_edge(NODE(i, 0), NODE(i + 1, 0), &nwall, wall, wall_normal);
        boundary_edge(NODE(i + 1, ny), NODE(i, ny), &nwall, wall, wall_normal);
    }
    for (int j = 0; j < ny; j++) {
        boundary_edge(NODE(0, j + 1), NODE(0, j), &nfar, far_node, far_normal);
        boundary_edge(NODE(nx, j), NODE(nx, j + 1), &nfar, far_node, far_normal);
    }
#undef NODE
}

static double pressure(const double u[4]) {
    return (GAMMA - 1) * (u[3] - 0.5 * (u[1] * u[1] + u[2] * u[2]) / u[0]);
}

/* Computes Rusanov's flux f through a face with normal n between states l and r: the mean of both
 * fluxes, minus half the fastest wave speed times the jump r - l. */
static void rusanov(const double l[4], const double r[4], const double n[2], double f[4]) {
    const double size = sqrt(n[0] * n[0] + n[1] * n[1]);
    const double pl = pressure(l), pr = pressure(r);
    const double ul = (l[1] * n[0] + l[2] * n[1]) / l[0], ur = (r[1] * n[0] + r[2] * n[1]) / r[0];
    const double sl = fabs(ul) + size * sqrt(GAMMA * pl / l[0]);
    const double sr = fabs(ur) + size * sqrt(GAMMA * pr / r[0]);
    const double s = sl > sr ? sl : sr;
    f[0] = 0.5 * (l[0] * ul + r[0] * ur - s * (r[0] - l[0]));
    f[1] = 0.5 * (l[1] * ul + pl * n[0] + r[1] * ur + pr * n[0] - s * (r[1] - l[1]));
    f[2] = 0.5 * (l[2] * ul + pl * n[1] + r[2] * ur + pr * n[1] - s * (r[2] - l[2]));
    f[3] = 0.5 * ((l[3] + pl) * ul + (r[3] + pr) * ur - s * (r[3] - l[3]));
}

static void wave_speeds(void) {
    for (int p = 0; p < nnode; p++)
        speed[p] = 0;
    for (int e = 0; e < nedge; e++) {
        const int a = edge[e][0], b = edge[e][1];
        const double nx = normal[e][0], ny = normal[e][1];
        const double rho = 0.5 * (q[a][0] + q[b][0]), p = 0.5 * (pressure(q[a]) + pressure(q[b]));
        const double mx = 0.5 * (q[a][1] + q[b][1]), my = 0.5 * (q[a][2] + q[b][2]);
        const double s =
            fabs(mx * nx + my * ny) / rho + sqrt(GAMMA * p / rho) * sqrt(nx * nx + ny * ny);
        speed[a] += s;
        speed[b] += s;
    }
}

static void residual(const double far_state[4]) {
    memset(res, 0, sizeof *res * (size_t)nnode);
    for (int e = 0; e < nedge; e++) {
        const int a = edge[e][0], b = edge[e][1];
        double f[4];
        rusanov(q[a], q[b], normal[e], f);
        for (int k = 0; k < 4; k++) {
            res[a][k] += f[k];
            res[b][k] -= f[k];
        }
    }
    for (int w = 0; w < nwall; w++) {
        const double p = pressure(q[wall[w]]);
        res[wall[w]][1] += p * wall_normal[w][0];
        res[wall[w]][2] += p * wall_normal[w][1];
    }
    for (int w = 0; w < nfar; w++) {
        double f[4];
        rusanov(q[far_node[w]], far_state, far_normal[w], f);
        for (int k = 0; k < 4; k++)
            res[far_node[w]][k] += f[k];
    }
}

/* Executes one step of four stages with local time steps. A node's time step divided by its volume
 * is CFL / speed. */
static void runge_kutta(const double far_state[4]) {
    static const double stage[4] = {0.25, 1.0 / 3, 0.5, 1.0};
    memcpy(q0, q, sizeof *q * (size_t)nnode);
    wave_speeds();
    for (int s = 0; s < 4; s++) {
        residual(far_state);
        for (int p = 0; p < nnode; p++)
            for (int k = 0; k < 4; k++)
                q[p][k] = q0[p][k] - stage[s] * CFL / speed[p] * res[p][k];
    }
}

int main(int argc, char **argv) {
    if (argc != 3 || atoi(argv[1]) < 4 || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: euler SIDE (4 or more) STEPS\n");
        return 2;
    }
    const int side = atoi(argv[1]), steps = atoi(argv[2]);
    const double far_state[4] = {1, MACH, 0, 1 / (GAMMA * (GAMMA - 1)) + 0.5 * MACH * MACH};
    make_mesh(3 * side, side);
    q = allocate(nnode, sizeof *q);
    q0 = allocate(nnode, sizeof *q0);
    res = allocate(nnode, sizeof *res);
    speed = allocate(nnode, sizeof *speed);
    for (int p = 0; p < nnode; p++)
        memcpy(q[p], far_state, sizeof far_state);
    for (int step = 1; step <= steps; step++) {
        runge_kutta(far_state);
        if (step % 20 == 0) {
            double sum = 0;
            for (int p = 0; p < nnode; p++)
                sum += res[p][0] * res[p][0] / (volume[p] * volume[p]);
            printf("%6d %.17g\n", step, sqrt(sum / nnode));
        }
    }
    for (int p = 0; p < nnode; p++)
        printf("%.17g %.17g %.17g\n", q[p][0], q[p][1], q[p][2]);
    return 0;
}
