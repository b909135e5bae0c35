/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Checks each step. A step is bad if it
 *
 *  - ends in an infinity or not-a-number, or has no converged solution;
 *  - stretches a triangle by more than a limit, unless the cloth stays below a harmless strain;
 *  - has gained more energy than gravity, wind, pins and colliders put in: with E kinetic and
 *    elastic energy and W their work, E' - E - W > limit (E_0 + sum |W|); or ends with more than
 *    all steps were given, E' > (1 + limit) (E_0 + sum |W|);
 *  - ends with a vertex deeper in a collider than a limit, and deeper than before;
 *  - lets cloth pass through itself or through a collider.
 *
 * The state is not changed, so an accepted step has the same bits as without the monitor.
 */
#ifndef FABRIC_MONITOR_H
#define FABRIC_MONITOR_H

#include "cloth_elements.h"
#include "contact/collision.h"
#include "scene/scene.h"
#include "solver/solver.h"

typedef enum monitor_verdict {
    STEP_GOOD,
    STEP_NOT_FINITE,
    STEP_NOT_SOLVED,
    STEP_STRAIN,
    STEP_ENERGY,
    STEP_PENETRATION,
    STEP_PASSING,
    STEP_NO_ROOM, /* with `contact: barrier`: driven vertices could not reach their goals */
    STEP_VERDICT_COUNT
} monitor_verdict;

/** Input of the monitor: both ends of the step, by reference. */
typedef struct monitored_step {
    double h;           /* s */
    double stage_h;     /* s, of the integrator's stage */
    double time;        /* s, at the step's begin */
    double push_work;   /* J, that collisions_keep_out did */
    const double *wind; /* [3] m/s, at present */
    const double (*x)[3], (*v)[3], (*x_next)[3], (*v_next)[3];
    const double (*residual)[3]; /* of the solver, see solver.h */
    const constraints *given;
    struct cloth *cloth;       /* what its hinges remember of the last energy may change */
    const strain_limit *limit; /* NULL: none */
    const collisions *collisions;
    solver_status status;
    int passing;  /* pairs of the cloth that pass through each other in the step */
    int watched;  /* otherwise only `finite`, `status` and `passing` are checked */
    int finite;   /* all of x_next and v_next */
    int shortest; /* the step cannot be halved further */
    int futile;   /* shorter steps did not keep cloth and bodies separate (monitor_futile_parts) */
} monitored_step;

typedef struct monitor {
    const scene *scene;
    double strain, energy, depth; /* of the state accepted last: largest, J, m */
    double reference;             /* J, E_0 + sum |W| */
    double noise;                 /* J, bound on the error by rounded positions */
    /* of the step checked last */
    double next_strain, next_energy, next_depth, work;
    double value, limit;               /* the value and its limit */
    int tolerated[STEP_VERDICT_COUNT]; /* faults accepted in the shortest step */
    long in_vain;                      /* steps accepted in a row in which something passed */
    /* of all steps accepted */
    long let_pass[STEP_VERDICT_COUNT];
    double greatest_strain, deepest; /* m */
    /* where the run starts */
    long start_inside;  /* vertices in a collider */
    double start_depth; /* m */
} monitor;

/** Looks at the state a run starts from: only mass, x, v, elements and collisions are read. */
void monitor_begin(monitor *m, const scene *s, const monitored_step *start);

/** Looks at a step. At the shortest length all but energy and infinities passes, since there is
 * nothing better to be had, and in a futile one what goes through or into a body: that is
 * counted. */
monitor_verdict monitor_check(monitor *m, const monitored_step *step);

/**
 * The step length, in least parts of the scene's step, below which passing or penetration causes no
 * more halving: 1 at first, doubled after each 32 accepted faults in a row. Cloth squeezed by two
 * bodies passes in steps of any length; the shortest ones would take a thousand times as long and
 * end no better.
 */
int monitor_futile_parts(const monitor *m);

/** The step checked last becomes the state to compare with. */
void monitor_accept(monitor *m);

/** "energy", "strain", ...: one word, or two. */
const char *monitor_verdict_name(monitor_verdict verdict);

#endif
