/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What a step must keep to, and whether it did. A step is bad that
 *  - ends in an infinity or not-a-number, or has no converged solution;
 *  - stretches a triangle by more than a limit, unless the cloth stays below a harmless strain;
 *  - has gained more energy than gravity, wind, pins and colliders put in: with E kinetic and
 *    elastic energy and W their work, E' - E - W > limit (E_0 + sum |W|); or ends with more than
 *    all steps were given, E' > (1 + limit) (E_0 + sum |W|);
 *  - ends with a vertex deeper in a collider than a limit, and deeper than it was;
 *  - lets cloth pass through itself or through a collider.
 * Nothing here changes the state, so a step that is accepted has the bits it has without.
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
    STEP_NO_ROOM, /* with `contact: barrier`: what is driven could not get where it should */
    STEP_VERDICT_COUNT
} monitor_verdict;

/** What the monitor looks at: the step's two ends. All by reference. */
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
    int watched;  /* else only `finite`, `status` and `passing` are looked at */
    int finite;   /* all of x_next and v_next */
    int shortest; /* the step cannot be halved any more, */
    int futile;   /* or shorter ones have not kept cloth and bodies apart (monitor_futile_parts) */
} monitored_step;

typedef struct monitor {
    const scene *scene;
    double strain, energy, depth; /* of the state accepted last: largest, J, m */
    double reference;             /* J, E_0 + sum |W| */
    double noise;                 /* J, what the rounding of positions may make of nothing */
    /* of the step checked last */
    double next_strain, next_energy, next_depth, work;
    double value, limit;               /* what was too much, and what would not have been */
    int tolerated[STEP_VERDICT_COUNT]; /* what it let pass because the step was the shortest */
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
 * Steps of how many of the least parts of a scene's step need not be halved for what passes or
 * goes into a body: 1 at first, and twice as many each time 32 steps in a row were let pass. What
 * two bodies squeeze passes however short the steps are; to go on in the shortest ones would cost
 * a thousand times as much and end no better.
 */
int monitor_futile_parts(const monitor *m);

/** The step checked last becomes the state to compare with. */
void monitor_accept(monitor *m);

/** "energy", "strain", ...: one word, or two. */
const char *monitor_verdict_name(monitor_verdict verdict);

#endif
