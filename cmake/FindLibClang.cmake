# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Finds libclang's C API, 17 or later: header and library of the same version (enumerators move
# between versions). Gives LibClang::LibClang, LibClang_VERSION and LibClang_RESOURCE_DIR.
foreach(version 19 20 21 18 17)
  set(root /usr/lib/llvm-${version})
  find_path(LibClang_INCLUDE_DIR clang-c/Index.h PATHS ${root}/include NO_DEFAULT_PATH)
  find_library(LibClang_LIBRARY NAMES clang clang-${version} PATHS ${root}/lib NO_DEFAULT_PATH)
  if(LibClang_INCLUDE_DIR AND LibClang_LIBRARY)
    set(LibClang_VERSION ${version})
    set(LibClang_RESOURCE_DIR ${root}/lib/clang/${version})
    break()
  endif()
  unset(LibClang_INCLUDE_DIR CACHE)
  unset(LibClang_LIBRARY CACHE)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LibClang
  REQUIRED_VARS LibClang_LIBRARY LibClang_INCLUDE_DIR VERSION_VAR LibClang_VERSION
  REASON_FAILURE_MESSAGE "install libclang-19-dev (17 or later will do)")
if(LibClang_FOUND AND NOT TARGET LibClang::LibClang)
  add_library(LibClang::LibClang UNKNOWN IMPORTED)
  set_target_properties(LibClang::LibClang PROPERTIES IMPORTED_LOCATION ${LibClang_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${LibClang_INCLUDE_DIR})
endif()
