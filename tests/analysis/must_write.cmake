# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The proof's cases as the frontend gives them: made anew with the tests.
set(must_write_cases ${CMAKE_CURRENT_BINARY_DIR}/must_write_cases.ir)
add_custom_command(OUTPUT ${must_write_cases} DEPENDS dump_ir ${CMAKE_CURRENT_LIST_DIR}/must_write_cases.c
  COMMAND dump_ir must_write_cases.c > ${must_write_cases} WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR} VERBATIM)
add_custom_target(must_write_cases DEPENDS ${must_write_cases})
add_executable(must_write_test ${CMAKE_CURRENT_LIST_DIR}/must_write_test.c)
target_link_libraries(must_write_test PRIVATE redcc_warnings redcc_analysis redcc_ir_reader PkgConfig::CMOCKA)
add_dependencies(must_write_test must_write_cases)
target_compile_definitions(must_write_test
  PRIVATE MUST_WRITE_CASES="${must_write_cases}"
          MUST_WRITE_SOURCE="${CMAKE_CURRENT_LIST_DIR}/must_write_cases.c")
add_test(NAME analysis.must_write COMMAND must_write_test)
add_executable(must_write_random_test ${CMAKE_CURRENT_LIST_DIR}/must_write_random_test.c)
target_link_libraries(must_write_random_test
  PRIVATE redcc_warnings redcc_analysis redcc_ir_reader PkgConfig::CMOCKA)
add_test(NAME analysis.must_write_random COMMAND must_write_random_test)
