# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The hard cases of docs/fabric-hard-cases.md that need whole simulations.
if(NOT TARGET fabric_physics_tests)
  return()
endif()
add_library(fabric_stage STATIC hard/stage.c)
target_include_directories(fabric_stage PUBLIC hard)
target_link_libraries(fabric_stage PUBLIC fabric_physics_tests fabric_physics
                      PRIVATE redcc_warnings)

foreach(name motion contact shape effects self)
  add_executable(test_fabric_hard_${name} hard/test_${name}.c)
  target_link_libraries(test_fabric_hard_${name} PRIVATE fabric_stage redcc_warnings)
  add_test(NAME fabric.hard.${name} COMMAND test_fabric_hard_${name})
endforeach()

# script/fuzz runs many more of them.
add_executable(random_scenes hard/random_scenes.c)
target_link_libraries(random_scenes PRIVATE fabric_stage redcc_warnings)
add_test(NAME fabric.hard.random_scenes COMMAND random_scenes 30)

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
