# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The hard cases of docs/fabric-hard-cases.md that need whole simulations.
if(NOT TARGET fabric_physics_tests)
  return()
endif()
foreach(name motion contact shape effects self piles rules resume)
  add_executable(test_fabric_hard_${name} hard/test_${name}.c)
  target_link_libraries(test_fabric_hard_${name} PRIVATE fabric_stage redcc_warnings)
  add_test(NAME fabric.hard.${name} COMMAND test_fabric_hard_${name})
endforeach()

# script/fuzz runs many more of them.
add_executable(random_scenes hard/random_scenes.c)
target_link_libraries(random_scenes PRIVATE fabric_stage redcc_warnings)
set(scenes 30)
if(REDCC_SANITIZE)
  set(scenes 12)
endif()
add_test(NAME fabric.hard.random_scenes COMMAND random_scenes ${scenes})
# A stiff sheet in steps of 29 s: a plane at rest seemed to have put in what the solution gained.
add_test(NAME fabric.hard.random_scenes_230 COMMAND random_scenes 3 229)

if(TARGET fabric_app)
  set(files_folder ${CMAKE_CURRENT_BINARY_DIR}/hard)
  file(MAKE_DIRECTORY ${files_folder})
  add_executable(test_fabric_hard_files hard/test_files.c)
  target_link_libraries(test_fabric_hard_files PRIVATE fabric_app fabric_physics_tests
                        redcc_warnings)
  target_compile_definitions(test_fabric_hard_files PRIVATE
                             SCENES_FOLDER="${PROJECT_SOURCE_DIR}/examples/fabric/scenes")
  add_test(NAME fabric.hard.files COMMAND test_fabric_hard_files
           WORKING_DIRECTORY ${files_folder})
endif()

# Instructions of a build with the effects that do not act against one without them.
find_program(VALGRIND valgrind)
if(VALGRIND AND NOT REDCC_SANITIZE)
  # Bits of plan.h: bend, bend damping, strain limit, drag, wind, self-collision.
  set(without "1<<EFFECT_BEND|1<<EFFECT_BEND_DAMPING|1<<EFFECT_STRAIN_LIMIT|1<<EFFECT_DRAG|1<<EFFECT_WIND|1<<EFFECT_SELF_COLLISION")
  add_library(fabric_physics_without STATIC EXCLUDE_FROM_ALL ${FABRIC_PHYSICS_SOURCES})
  target_compile_definitions(fabric_physics_without PRIVATE "FABRIC_WITHOUT=(${without})")
  target_link_libraries(fabric_physics_without PUBLIC fabric_mesh fabric_flags m
                        PRIVATE redcc_warnings)
  foreach(which physics physics_without)
    add_executable(effect_cost_${which} EXCLUDE_FROM_ALL hard/effect_cost.c)
    target_link_libraries(effect_cost_${which} PRIVATE fabric_physics_tests fabric_${which}
                          fabric_mesh redcc_warnings)
  endforeach()
  add_test(NAME fabric.hard.build_without
           COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target
                   effect_cost_physics effect_cost_physics_without)
  add_test(NAME fabric.hard.instructions
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/hard/instructions.sh
                   $<TARGET_FILE:effect_cost_physics> $<TARGET_FILE:effect_cost_physics_without>)
  set_tests_properties(fabric.hard.build_without PROPERTIES FIXTURES_SETUP effect_cost LABELS slow)
  set_tests_properties(fabric.hard.instructions PROPERTIES FIXTURES_REQUIRED effect_cost
                       LABELS slow)
endif()
