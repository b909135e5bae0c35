# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The parallel program gives the bits of the serial one; label threads: for the thread sanitizer.
if(TARGET fabric)
  add_test(NAME fabric.app.same_bits
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/app_same_bits.sh $<TARGET_FILE:fabric-serial>
                   $<TARGET_FILE:fabric> ${scenes_folder} ${app_folder}/same_bits)
  set_tests_properties(fabric.app.same_bits PROPERTIES LABELS threads
                       ENVIRONMENT "TSAN_OPTIONS=${tsan_options}")
endif()
