# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Physics of the cloth: effects, system, solver, contact, steps.
if(NOT TARGET fabric_physics)
  return()
endif()
include(${CMAKE_SOURCE_DIR}/examples/fabric/physics.cmake)

add_library(fabric_physics_tests STATIC physics/cloth.c physics/dense.c)
target_include_directories(fabric_physics_tests PUBLIC physics)
target_link_libraries(fabric_physics_tests PUBLIC fabric_flags PkgConfig::CMOCKA m
                      PRIVATE redcc_warnings)

# A cloth with its scene and simulation: for whole steps, and for hard.cmake.
add_library(fabric_stage STATIC hard/stage.c hard/crossings.c hard/barrier_scene.c)
target_include_directories(fabric_stage PUBLIC hard)
target_link_libraries(fabric_stage PUBLIC fabric_physics_tests fabric_physics
                      PRIVATE redcc_warnings)

foreach(name forces system solver domains collision simulation integrator team barrier)
  add_executable(test_fabric_${name} physics/test_${name}.c)
  target_link_libraries(test_fabric_${name} PRIVATE fabric_physics fabric_physics_tests
                        redcc_warnings)
  add_test(NAME fabric.physics.${name} COMMAND test_fabric_${name})
endforeach()
target_link_libraries(test_fabric_simulation PRIVATE fabric_stage)

# The same sources with OpenMP's pragmas alive: the bits must not depend on the thread count.
add_library(fabric_physics_openmp STATIC ${FABRIC_PHYSICS_SOURCES})
target_link_libraries(fabric_physics_openmp PUBLIC fabric_mesh fabric_flags OpenMP::OpenMP_C m
                      PRIVATE redcc_warnings)
add_executable(test_fabric_threads physics/test_threads.c)
target_link_libraries(test_fabric_threads PRIVATE fabric_physics_tests fabric_physics_openmp
                      fabric_mesh redcc_warnings)
add_test(NAME fabric.physics.threads COMMAND test_fabric_threads)
