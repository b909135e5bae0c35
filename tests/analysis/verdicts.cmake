# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
add_library(analysis_expectation STATIC ${CMAKE_CURRENT_LIST_DIR}/expectation.c)
target_link_libraries(analysis_expectation PUBLIC redcc_analysis PRIVATE redcc_warnings)
target_include_directories(analysis_expectation PUBLIC ${CMAKE_CURRENT_LIST_DIR})

add_executable(analysis_verdict_ir_test ${CMAKE_CURRENT_LIST_DIR}/verdict_ir_test.c)
target_link_libraries(analysis_verdict_ir_test
  PRIVATE redcc_warnings analysis_expectation redcc_ir_reader PkgConfig::CMOCKA)
target_compile_definitions(analysis_verdict_ir_test
  PRIVATE REASONS_DOCUMENT="${CMAKE_SOURCE_DIR}/docs/reasons.md")
add_test(NAME analysis.verdict_ir COMMAND analysis_verdict_ir_test)

if(TARGET redcc_frontend)
  add_executable(analysis_invariants_test ${CMAKE_CURRENT_LIST_DIR}/invariants_test.c)
  target_link_libraries(analysis_invariants_test
    PRIVATE redcc_warnings redcc_analysis redcc_frontend PkgConfig::CMOCKA)
  add_test(NAME analysis.invariants COMMAND analysis_invariants_test)

  add_executable(analysis_cases_test ${CMAKE_CURRENT_LIST_DIR}/cases_test.c)
  target_link_libraries(analysis_cases_test
    PRIVATE redcc_warnings analysis_expectation redcc_frontend)
  file(GLOB cases CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/cases/*.c)
  foreach(case ${cases})
    get_filename_component(name ${case} NAME_WE)
    add_test(NAME analysis.cases.${name} COMMAND analysis_cases_test ${case})
  endforeach()
endif()
