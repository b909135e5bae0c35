/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Elements and masses of a cloth, constant during a simulation. */
#ifndef FABRIC_CLOTH_ELEMENTS_H
#define FABRIC_CLOTH_ELEMENTS_H

#include "effects/hinge.h"
#include "effects/strain_limit.h"
#include "effects/triangle.h"

struct cloth {
    triangle_elements triangles; /* for stretch, shear, drag, strain */
    hinge_elements hinges;       /* none without bending */
    strain_limit strain_limit;   /* empty without a limit */
    triangle_material triangle_material;
    hinge_material hinge_material;
    int has_triangle_forces, has_hinge_forces;
    double *mass; /* [vertices] kg */
    double total_mass;
};

#endif
