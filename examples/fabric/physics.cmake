# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The sources of the cloth's physics; step/simulation.h is their interface.
set(FABRIC_PHYSICS_SOURCES)
foreach(source
    step/simulation.c step/team.c step/simulation_state.c step/simulation_archive.c step/integrator.c step/newton.c step/forces.c contact/motion.c contact/collision.c contact/pin.c contact/shape.c system/constraint.c solver/solver.c solver/solver_precondition.c
    solver/solver_factor.c solver/solver_domains.c solver/solver_domains_layout.c solver/solver_domains_passes.c solver/solver_domains_turns.c solver/solver_packed.c solver/solver_direct.c solver/solver_fallback.c
    system/system.c system/sparse_product.c
    effects/triangle.c effects/triangle_elements.c effects/hinge.c effects/hinge_elements.c
    effects/drag.c effects/drag_work.c effects/damping.c
    effects/strain_limit.c effects/strain_limit_list.c
    contact/collision_account.c contact/collision_near.c contact/collision_triangles.c contact/shape_triangle.c contact/impulse.c contact/impact.c contact/impact_zone.c step/monitor.c step/plan.c step/rest.c step/timing.c step/doubts.c contact/self_collision.c contact/self_grid.c contact/self_pair.c
    contact/solid_mesh.c contact/nearest.c contact/barrier.c contact/barrier_pairs.c contact/barrier_part.c contact/barrier_energy.c contact/barrier_start.c contact/barrier_untangle.c contact/barrier_system.c
    step/barrier_step.c)
  list(APPEND FABRIC_PHYSICS_SOURCES ${CMAKE_CURRENT_LIST_DIR}/${source})
endforeach()
# Without OpenMP the compiler ignores the pragmas on regular loops.
set_source_files_properties(${FABRIC_PHYSICS_SOURCES} PROPERTIES
                            COMPILE_OPTIONS -Wno-unknown-pragmas)
