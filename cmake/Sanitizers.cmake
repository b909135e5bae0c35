# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# REDCC_SANITIZE: a list for -fsanitize=, applied to everything that is built here.
set(REDCC_SANITIZE "" CACHE STRING "sanitizers to build with, as -fsanitize= takes them")
if(REDCC_SANITIZE)
  add_compile_options(-fsanitize=${REDCC_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${REDCC_SANITIZE})
  # For what tests spend their time in, as the sanitizers' manuals advise; it takes twice as long to
  # compile.
  set(REDCC_SANITIZED_OPTIONS -O1)
endif()
