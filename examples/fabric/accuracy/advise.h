/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which step, integrator and tolerance reach an error, from curves measured before. */
#ifndef FABRIC_ACCURACY_ADVISE_H
#define FABRIC_ACCURACY_ADVISE_H

#include "scene.h"

/** A measured point, as `fabric accuracy dt` writes it. */
typedef struct curve_point {
    char scene[64];
    char integrator[48];
    int vertices;
    double step, tolerance, cpu_seconds, error;
    long steps;
    double side, stiffness; /* of the scene, as are the others: see study.h */
    int contact, wind;
} curve_point;

typedef struct advice {
    char integrator[48];
    int exact_scene; /* measured on a scene of this name and mesh; else carried over by scale */
    double unlike;   /* of the scene measured: curve_unlike; 0: it is the same */
    int within;      /* the error lies between measured ones; else it is extrapolated */
    char measured_on[64];
    double order;       /* slope of the curve there */
    double step;        /* s */
    double error;       /* m, expected */
    double cpu_seconds; /* expected for the whole scene on one core */
    double tolerance;   /* of the linear system, or of Newton's method */
} advice;

/** Reads a table; *points is the caller's to free. Their count, or -1 after a message. */
int curves_read(const char *path, curve_point **points);

/**
 * How unlike the scene is to the one that the curve was measured on: |log2| of the ratios of
 * vertices, of side, of stiffness and of duration, 4 where one has colliders and the other has
 * none, 2 for wind, and 3 for another name.
 */
double curve_unlike(const scene *s, const curve_point *curve);

/**
 * The cheapest integrator for an rms error (m) of the scene, by curves of the least unlike one.
 * Those of the scene's own name and vertices are taken as they are; others' errors are scaled by
 * the side of the sheets, and times by vertices and duration. 0, or -1: there is no curve.
 */
int advise(const scene *s, double error, const curve_point *points, int count, advice *result);

#endif
