/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Checks each step. A step is bad if it
 *
 *  - ends with an infinity or NaN, or has no converged solution;
 *  - stretches a triangle by more than a limit, unless the cloth stays below a harmless strain;
 *  - gains more energy than gravity, wind, pins and colliders supply: E' - E - W > limit (E_0 + sum
 *    |W|), or over all steps, E' > (1 + limit) (E_0 + sum |W|). E and E' are the kinetic and
 *    elastic energy before and after the step, E_0 is that at the start of the run, W is the work
 *    supplied;
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
    STEP_NO_ROOM, /* with `contact: barrier`: vertices moved by pins or bodies could not reach their
                   * goals */
    STEP_VERDICT_COUNT
} monitor_verdict;

/** Input of the monitor: pointers to the states at both ends of the step, and results of the
 *  step. */
typedef struct monitored_step {
    double h;           /* s */
    double stage_h;     /* s, length of the integrator's stage */
    double time;        /* s, time at the step's beginning */
    double push_work;   /* J, work of impact_resolve or, with barriers, of bodies */
    const double *wind; /* [3] m/s, wind in this step */
    const double (*x)[3], (*v)[3], (*x_next)[3], (*v_next)[3];
    const double (*residual)[3]; /* the solver's residual, see solver.h */
    const constraints *given;
    struct cloth *cloth;       /* not const: hinges cache the angles of the last energy */
    const strain_limit *limit; /* NULL: none */
    const collisions *collisions;
    solver_status status;
    int passing;  /* number of pairs of the cloth, and of triangles with a collider, that pass in
                   * the step */
    int watched;  /* 0: only `finite`, `status` and `passing` are checked */
    int finite;   /* all of x_next and v_next are finite */
    int shortest; /* the step cannot be halved further */
    int futile;   /* shorter steps would not separate cloth and bodies (monitor_futile_parts) */
} monitored_step;

typedef struct monitor {
    const scene *scene;
    double strain, energy, depth; /* of the state accepted last: largest strain; J; m, greatest
                                   * depth */
    double reference;             /* J, E_0 + sum |W| */
    double noise;                 /* J, bound on the error of the energy that rounding of positions
                                   * causes */
    /* About the step checked last: */
    double next_strain, next_energy, next_depth, work;
    double value, limit;               /* the value and its limit */
    int tolerated[STEP_VERDICT_COUNT]; /* faults accepted in this step */
    long passing_in_a_row;             /* number of consecutive accepted steps in which something
                                        * passed */
    /* About all accepted steps: */
    long let_pass[STEP_VERDICT_COUNT];
    double greatest_strain, deepest; /* no unit; m */
    /* At the start of the run: */
    long start_inside;  /* number of vertices in a collider */
    double start_depth; /* m */
} monitor;

/** Evaluates the state from which a run starts. `start` needs no data of the step's end. */
void monitor_begin(monitor *m, const scene *s, const monitored_step *start);

/** Checks a step. A step of the shortest length cannot be halved, so all its faults are accepted
 *  except energy and non-finite values. In a step whose halving is futile (monitor_futile_parts),
 *  passing and penetration are accepted. Accepted faults are counted. */
monitor_verdict monitor_check(monitor *m, const monitored_step *step);

/**
 * Returns the step length, in multiples of the shortest step, at and below which passing or
 * penetration causes no more halving. It is 1 at first, and doubles after every 32 consecutive
 * accepted steps with such a fault. Cloth squeezed by two bodies passes in steps of any length;
 * with the shortest ones a run would take a thousand times as long without a better result.
 */
int monitor_futile_parts(const monitor *m);

/** Accepts the step checked last: the next step is compared with its end. */
void monitor_accept(monitor *m);

/** The verdict's name, such as "energy" or "strain". */
const char *monitor_verdict_name(monitor_verdict verdict);

#endif
