# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
add_executable(must_write_test ${CMAKE_CURRENT_LIST_DIR}/must_write_test.c)
target_link_libraries(must_write_test PRIVATE redcc_warnings redcc_analysis PkgConfig::CMOCKA)
target_compile_definitions(must_write_test
  PRIVATE MUST_WRITE_CASES="${CMAKE_CURRENT_LIST_DIR}/must_write_cases.ir"
          MUST_WRITE_SOURCE="${CMAKE_CURRENT_LIST_DIR}/must_write_cases.c")
add_test(NAME analysis.must_write COMMAND must_write_test)
add_executable(must_write_random_test ${CMAKE_CURRENT_LIST_DIR}/must_write_random_test.c)
target_link_libraries(must_write_random_test
  PRIVATE redcc_warnings redcc_analysis PkgConfig::CMOCKA)
add_test(NAME analysis.must_write_random COMMAND must_write_random_test)
