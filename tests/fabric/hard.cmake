# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The hard cases of docs/fabric-hard-cases.md that need whole simulations.
if(NOT TARGET fabric_physics_tests)
  return()
endif()
add_library(fabric_stage STATIC hard/stage.c)
target_include_directories(fabric_stage PUBLIC hard)
target_link_libraries(fabric_stage PUBLIC fabric_physics_tests fabric_physics
                      PRIVATE redcc_warnings)

foreach(name motion contact shape effects)
  add_executable(test_fabric_hard_${name} hard/test_${name}.c)
  target_link_libraries(test_fabric_hard_${name} PRIVATE fabric_stage redcc_warnings)
  add_test(NAME fabric.hard.${name} COMMAND test_fabric_hard_${name})
endforeach()
