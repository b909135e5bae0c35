# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The sources of the cloth's physics, with simulation.h as its face.
set(FABRIC_PHYSICS_SOURCES)
foreach(source
    simulation.c team.c simulation_state.c simulation_archive.c archive.c integrator.c newton.c forces.c motion.c collision.c pin.c shape.c constraint.c solver.c solver_precondition.c
    solver_factor.c solver_domains.c solver_domains_layout.c solver_domains_passes.c solver_packed.c solver_direct.c solver_fallback.c
    system.c sparse_product.c
    effects/triangle.c effects/triangle_elements.c effects/hinge.c effects/hinge_elements.c
    effects/drag.c effects/drag_along.c effects/drag_work.c effects/damping.c
    effects/strain_limit.c effects/strain_limit_list.c
    collision_account.c collision_near.c collision_triangles.c shape_triangle.c impulse.c impact.c impact_zone.c monitor.c plan.c rest.c self_collision.c self_grid.c self_pair.c)
  list(APPEND FABRIC_PHYSICS_SOURCES ${CMAKE_CURRENT_LIST_DIR}/${source})
endforeach()
# Built without OpenMP, its pragmas on regular loops mean nothing.
set_source_files_properties(${FABRIC_PHYSICS_SOURCES} PROPERTIES
                            COMPILE_OPTIONS -Wno-unknown-pragmas)
