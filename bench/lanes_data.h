/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef BENCH_LANES_DATA_H
#define BENCH_LANES_DATA_H

#include "lanes_kernels.h"

/** A sparse matrix in rows, columns ascending. */
struct pattern {
    int *start, *column; /* [rows + 1], [start[rows]] */
};

/** A square mesh, each square halved, with what the kernels make of it. */
struct mesh {
    int side, nodes, triangles, edges, tetrahedra;
    double (*x)[3], (*v)[3], *radius; /* [nodes] */
    float (*float_x)[3];
    struct element *element; /* [triangles] */
    int (*edge)[2];          /* [edges] */
    double *rest;
    int (*corner)[4];       /* [tetrahedra] one on each square */
    struct pattern blocks;  /* of a tetrahedron's corners with each other */
    struct pattern upper;   /* of the ends of edges, and the diagonal */
    double *value, *single; /* of upper; [nodes] */
};

/** Numbers of nodes, elements, edges and blocks in order, or shuffled. */
struct mesh make_mesh(int side, int shuffled);

void free_mesh(struct mesh *mesh);

#endif
