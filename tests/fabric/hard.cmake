# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The hard cases of docs/fabric-hard-cases.md that need whole simulations.
if(NOT TARGET fabric_physics_tests)
  return()
endif()
foreach(name motion contact shape effects demand decisions self impact piles rules steps resume bodies barrier barrier_rules barrier_scenes)
  add_executable(test_fabric_hard_${name} hard/test_${name}.c)
  target_link_libraries(test_fabric_hard_${name} PRIVATE fabric_stage redcc_warnings)
  add_test(NAME fabric.hard.${name} COMMAND test_fabric_hard_${name})
endforeach()

add_test(NAME fabric.hard.piles_long COMMAND test_fabric_hard_piles long)
set_tests_properties(fabric.hard.piles_long PROPERTIES LABELS slow)
add_test(NAME fabric.hard.barrier_long COMMAND test_fabric_hard_barrier long)
set_tests_properties(fabric.hard.barrier_long PROPERTIES LABELS slow)
add_test(NAME fabric.hard.barrier_scenes_long COMMAND test_fabric_hard_barrier_scenes long)
set_tests_properties(fabric.hard.barrier_scenes_long PROPERTIES LABELS slow)
target_sources(test_fabric_hard_demand PRIVATE ${PROJECT_SOURCE_DIR}/examples/fabric/output/memory.c)
target_compile_definitions(test_fabric_hard_decisions PRIVATE
                           SCENES_FOLDER="${scenes_folder}")

# Every scene of the catalogue by the physics behind redcc-cc: the same bits at any number of threads. Threads
# that wait for a core take most of the time, so that only the slow tests have them all.
if(TARGET fabric_physics_parallel AND NOT REDCC_SANITIZE)
  foreach(name simulation motion contact shape effects self piles rules steps resume bodies barrier barrier_rules barrier_scenes)
    set(folder hard)
    if(name STREQUAL simulation)
      set(folder physics)
      set(test test_fabric_simulation)
    else()
      set(test test_fabric_hard_${name})
    endif()
    add_executable(test_fabric_bits_${name} ${folder}/test_${name}.c hard/stage.c hard/crossings.c hard/barrier_scene.c)
    target_include_directories(test_fabric_bits_${name} PRIVATE hard)
    target_link_libraries(test_fabric_bits_${name} PRIVATE fabric_physics_tests fabric_scene
                          fabric_physics_parallel redcc_warnings)
    add_test(NAME fabric.hard.bits_${name}
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/hard/bits.sh $<TARGET_FILE:${test}>
                     $<TARGET_FILE:test_fabric_bits_${name}>
                     ${CMAKE_CURRENT_BINARY_DIR}/hard/bits_${name} 3)
    add_test(NAME fabric.hard.bits_${name}_long
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/hard/bits.sh $<TARGET_FILE:${test}>
                     $<TARGET_FILE:test_fabric_bits_${name}>
                     ${CMAKE_CURRENT_BINARY_DIR}/hard/bits_${name}_long 1 2 3 7)
    set_tests_properties(fabric.hard.bits_${name}_long PROPERTIES LABELS slow)
  endforeach()
endif()

# script/fuzz runs many more of them.
add_executable(random_scenes hard/random_scenes.c)
target_link_libraries(random_scenes PRIVATE fabric_stage redcc_warnings)
set(scenes 30)
set(driven 28)
if(REDCC_SANITIZE) # driven scenes behind the 19th take up to a minute so, and do nothing else
  set(scenes 12)
  set(driven 19)
endif()
add_test(NAME fabric.hard.random_scenes COMMAND random_scenes ${scenes})
add_test(NAME fabric.hard.random_scenes_driven COMMAND random_scenes ${driven} 1 driven)
# With contact by a barrier; in 6 and 8 bodies press a held sheet, until nothing but rounding was left between.
add_test(NAME fabric.hard.random_scenes_barrier COMMAND random_scenes 5 5 barrier)
# The longest tests begin first, or one core waits for the other at the end.
set_tests_properties(fabric.hard.piles fabric.hard.random_scenes_driven fabric.hard.demand
                     fabric.hard.shape fabric.hard.random_scenes PROPERTIES COST 100)
# A stiff sheet in steps of 29 s: a plane at rest seemed to have put in what the solution gained.
add_test(NAME fabric.hard.random_scenes_230 COMMAND random_scenes 3 229)
# Impulses between two bodies that grew from round to round, to 1e8 J in a step.
add_test(NAME fabric.hard.random_scenes_driven_158 COMMAND random_scenes 1 158 driven)

if(TARGET fabric_app)
  set(files_folder ${CMAKE_CURRENT_BINARY_DIR}/hard)
  file(MAKE_DIRECTORY ${files_folder})
  add_executable(test_fabric_hard_files hard/test_files.c)
  target_link_libraries(test_fabric_hard_files PRIVATE fabric_app fabric_physics_tests
                        redcc_warnings)
  target_compile_definitions(test_fabric_hard_files PRIVATE
                             SCENES_FOLDER="${scenes_folder}")
  add_test(NAME fabric.hard.files COMMAND test_fabric_hard_files
           WORKING_DIRECTORY ${files_folder})
endif()

# Instructions of a build with an effect that a sheet lacks against one without it: one test for each
# effect of effects.def.
find_program(VALGRIND valgrind)
if(VALGRIND AND NOT REDCC_SANITIZE)
  set(sheet_SHEAR no-shear)
  set(sheet_SHEAR_DAMPING no-shear)
  set(sheet_STRETCH no-stretch)
  set(sheet_STRETCH_DAMPING no-stretch)
  set(sheet_GRAVITY weightless)
  set(sheet_PINS free)
  set(sheet_MONITOR unwatched)
  # Only the sources that ask what a build has are compiled anew.
  set(asking step/forces.c step/integrator.c step/simulation.c step/simulation_state.c effects/triangle.c)
  list(TRANSFORM asking PREPEND ${PROJECT_SOURCE_DIR}/examples/fabric/)
  set_source_files_properties(${asking} PROPERTIES COMPILE_OPTIONS -Wno-unknown-pragmas)
  add_executable(effect_cost EXCLUDE_FROM_ALL hard/effect_cost.c)
  target_link_libraries(effect_cost PRIVATE fabric_physics_tests fabric_physics redcc_warnings)
  set(effect_cost_targets effect_cost)
  file(STRINGS ${PROJECT_SOURCE_DIR}/examples/fabric/effects/effects.def effects REGEX "^EFFECT\\(")
  list(TRANSFORM effects REPLACE "^EFFECT\\(([A-Z_]+),.*" "\\1")
  foreach(effect ${effects})
    set(sheet ${sheet_${effect}})
    if(NOT sheet)
      set(sheet held)
    endif()
    string(TOLOWER ${effect} name)
    add_executable(effect_cost_${name} EXCLUDE_FROM_ALL hard/effect_cost.c ${asking})
    target_compile_definitions(effect_cost_${name} PRIVATE "FABRIC_WITHOUT=(1<<EFFECT_${effect})")
    target_link_libraries(effect_cost_${name} PRIVATE fabric_physics_tests fabric_physics
                          redcc_warnings)
    add_test(NAME fabric.hard.instructions_${name}
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/hard/instructions.sh
                     $<TARGET_FILE:effect_cost> $<TARGET_FILE:effect_cost_${name}> ${sheet})
    set_tests_properties(fabric.hard.instructions_${name} PROPERTIES FIXTURES_REQUIRED effect_cost
                         LABELS slow)
    list(APPEND effect_cost_targets effect_cost_${name})
  endforeach()
  add_test(NAME fabric.hard.build_without
           COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target ${effect_cost_targets})
  set_tests_properties(fabric.hard.build_without PROPERTIES FIXTURES_SETUP effect_cost LABELS slow)
endif()
