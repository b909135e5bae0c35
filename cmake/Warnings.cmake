# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Link a target of ours to redcc_warnings (PRIVATE) to build it with every warning that the project
# keeps clean. REDCC_WERROR=ON (script/test) turns warnings into errors; an undeclared function is one
# always, since what it returns is then read as an int.
option(REDCC_WERROR "treat warnings as errors" OFF)
add_library(redcc_warnings INTERFACE)
target_compile_options(redcc_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion
                       -Werror=implicit-function-declaration
                       $<$<BOOL:${REDCC_WERROR}>:-Werror>)
