/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Vectors of three doubles. An output may be one of the inputs. */
#ifndef FABRIC_VECTOR_H
#define FABRIC_VECTOR_H

#include <math.h>

static inline double vector_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vector_length(const double a[3]) {
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

static inline void vector_subtract(const double a[3], const double b[3], double difference[3]) {
    difference[0] = a[0] - b[0];
    difference[1] = a[1] - b[1];
    difference[2] = a[2] - b[2];
}

static inline void vector_cross(const double a[3], const double b[3], double product[3]) {
    const double x = a[1] * b[2] - a[2] * b[1];
    const double y = a[2] * b[0] - a[0] * b[2];
    const double z = a[0] * b[1] - a[1] * b[0];
    product[0] = x;
    product[1] = y;
    product[2] = z;
}

static inline void vector_scale(const double a[3], double factor, double scaled[3]) {
    for (int k = 0; k < 3; k++)
        scaled[k] = factor * a[k];
}

/** unit = a / |a|, or 0 if a is 0. Returns |a|. */
static inline double vector_unit(const double a[3], double unit[3]) {
    const double length = vector_length(a);
    for (int k = 0; k < 3; k++)
        unit[k] = length > 0 ? a[k] / length : 0;
    return length;
}

/** Computes the normal of the triangle a b c; its length is twice the triangle's area. */
static inline void vector_normal(const double a[3], const double b[3], const double c[3],
                                 double normal[3]) {
    double one[3], other[3];
    vector_subtract(b, a, one);
    vector_subtract(c, a, other);
    vector_cross(one, other, normal);
}

/** sum = a + factor * b */
static inline void vector_add_scaled(const double a[3], double factor, const double b[3],
                                     double sum[3]) {
    sum[0] = a[0] + factor * b[0];
    sum[1] = a[1] + factor * b[1];
    sum[2] = a[2] + factor * b[2];
}

/** Returns the same array with const elements. (C has no such implicit conversion of pointers to
 *  arrays.) */
static inline const double (*read_only(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

#endif
