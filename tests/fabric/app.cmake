# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Meshes, scenes, states and the command line of the cloth simulator.
function(fabric_app_test name)
  add_executable(test_fabric_${name} app_${name}.c)
  target_link_libraries(test_fabric_${name} PRIVATE redcc_warnings PkgConfig::CMOCKA ${ARGN})
  target_compile_definitions(test_fabric_${name} PRIVATE SCENES_FOLDER="${scenes_folder}")
  add_test(NAME fabric.app.${name} COMMAND test_fabric_${name} WORKING_DIRECTORY ${app_folder})
endfunction()

fabric_app_test(mesh fabric_mesh m)
fabric_app_test(mesh_file fabric_mesh m)
fabric_app_test(scene fabric_scene)
if(TARGET fabric_app)
  fabric_app_test(state fabric_app)
  fabric_app_test(picture fabric_view)
  fabric_app_test(gltf fabric_view PkgConfig::JANSSON)
  # Another program's reader of glTF, where it is installed.
  find_library(ASSIMP_LIBRARY assimp)
  find_path(ASSIMP_INCLUDE assimp/cimport.h)
  if(ASSIMP_LIBRARY AND ASSIMP_INCLUDE)
    target_compile_definitions(test_fabric_gltf PRIVATE FABRIC_WITH_ASSIMP)
    target_include_directories(test_fabric_gltf SYSTEM PRIVATE ${ASSIMP_INCLUDE})
    target_link_libraries(test_fabric_gltf PRIVATE ${ASSIMP_LIBRARY})
  endif()
  fabric_app_test(checkpoint fabric_app)
  fabric_app_test(progress fabric_app)
  # What they choose goes by processor time, of which sanitizers make another one.
  if(NOT REDCC_SANITIZE)
    fabric_app_test(advise fabric_app)
    set(accuracy accuracy)
  endif()
  foreach(document runs files)
    add_test(NAME fabric.app.docs_${document}
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_docs.sh $<TARGET_FILE:fabric-serial>
                     ${scenes_folder} ${app_folder}/docs_${document}
                     ${PROJECT_SOURCE_DIR}/docs/fabric-${document}.md)
  endforeach()
  foreach(script ${accuracy} blender cli export resume run render sheet video)
    add_test(NAME fabric.app.${script}
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_${script}.sh $<TARGET_FILE:fabric-serial>
                     ${scenes_folder} ${app_folder}/${script})
  endforeach()
  set_tests_properties(fabric.app.blender fabric.app.video PROPERTIES SKIP_RETURN_CODE 77)
endif()
if(TARGET fabric AND NOT REDCC_SANITIZE)
  add_test(NAME fabric.app.resume_parallel
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_resume.sh $<TARGET_FILE:fabric-serial>
                   ${scenes_folder} ${app_folder}/resume_parallel $<TARGET_FILE:fabric>)
  add_test(NAME fabric.app.gallery
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_gallery.sh $<TARGET_FILE:fabric-serial>
                   $<TARGET_FILE:fabric> ${scenes_folder} ${app_folder}/gallery)
  add_test(NAME fabric.app.plan
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_plan.sh $<TARGET_FILE:fabric>)
  set_tests_properties(fabric.app.plan PROPERTIES ENVIRONMENT FABRIC_SCENES=${scenes_folder})
  add_test(NAME fabric.app.translated
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_translated.sh $<TARGET_FILE:redcc>
                   ${PROJECT_SOURCE_DIR}/runtime/include ${PROJECT_SOURCE_DIR}/examples/fabric)
  add_test(NAME fabric.app.paper_bits
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_paper_bits.sh
                   $<TARGET_FILE:fabric-serial> $<TARGET_FILE:fabric> ${scenes_folder}
                   ${app_folder}/paper_bits)
endif()
