# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Finds libclang's C API, 17 or later (which operator an expression has cannot be asked of earlier
# ones): header and library of the same version, as enumerators move between versions. Gives
# LibClang::LibClang, LibClang_VERSION and LibClang_RESOURCE_DIR. It is looked for
#   where LLVM_CONFIG, a program, says;
#   where Debian has it, and where the llvm-config of a version says, the versions tested most first;
#   where a plain llvm-config says;
#   by Clang's own CMake package (Clang_DIR, CMAKE_PREFIX_PATH).
set(LibClang_LEAST 17)
set(LLVM_CONFIG "" CACHE FILEPATH "llvm-config of the LLVM whose libclang is to be used")

# What lies below an include folder and a library folder, if it is new enough.
macro(libclang_look_at include_folder library_folder version)
  if(NOT LibClang_LIBRARY AND "${version}" VERSION_GREATER_EQUAL LibClang_LEAST)
    string(REGEX MATCH "^[0-9]+" libclang_major "${version}")
    find_path(LibClang_INCLUDE_DIR clang-c/Index.h PATHS ${include_folder} NO_DEFAULT_PATH)
    find_library(LibClang_LIBRARY NAMES clang clang-${libclang_major} PATHS ${library_folder} NO_DEFAULT_PATH)
    if(LibClang_INCLUDE_DIR AND LibClang_LIBRARY)
      set(LibClang_VERSION ${libclang_major} CACHE INTERNAL "libclang's version")
      set(LibClang_RESOURCE_DIR ${library_folder}/clang/${libclang_major} CACHE INTERNAL "clang's own headers")
    else()
      unset(LibClang_INCLUDE_DIR CACHE)
      unset(LibClang_LIBRARY CACHE)
    endif()
  elseif(NOT LibClang_LIBRARY AND NOT "${version}" STREQUAL "")
    list(APPEND libclang_too_old ${version})
  endif()
endmacro()

function(libclang_ask program)
  set(answers "")
  foreach(option version includedir libdir)
    execute_process(COMMAND ${program} --${option} OUTPUT_VARIABLE answer RESULT_VARIABLE status
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT status EQUAL 0)
      set(answer "")
    endif()
    list(APPEND answers "${answer}")
  endforeach()
  set(libclang_answers "${answers}" PARENT_SCOPE)
endfunction()

macro(libclang_look_by program)
  libclang_ask(${program})
  list(GET libclang_answers 0 libclang_version)
  list(GET libclang_answers 1 libclang_include)
  list(GET libclang_answers 2 libclang_library)
  libclang_look_at("${libclang_include}" "${libclang_library}" "${libclang_version}")
endmacro()

set(libclang_too_old "")
if(NOT LibClang_VERSION) # library and version are found together
  unset(LibClang_INCLUDE_DIR CACHE)
  unset(LibClang_LIBRARY CACHE)
endif()
if(LLVM_CONFIG)
  libclang_look_by(${LLVM_CONFIG})
else()
  foreach(version 19 20 21 18 17)
    libclang_look_at(/usr/lib/llvm-${version}/include /usr/lib/llvm-${version}/lib ${version})
    if(NOT LibClang_LIBRARY)
      find_program(libclang_config llvm-config-${version} NO_CACHE)
      if(libclang_config)
        libclang_look_by(${libclang_config})
      endif()
      unset(libclang_config)
    endif()
  endforeach()
  find_program(libclang_config llvm-config NO_CACHE)
  if(libclang_config AND NOT LibClang_LIBRARY)
    libclang_look_by(${libclang_config})
  endif()
  if(NOT LibClang_LIBRARY)
    find_package(Clang CONFIG QUIET)
    if(Clang_FOUND)
      libclang_look_at("${CLANG_INCLUDE_DIRS}" "${LLVM_LIBRARY_DIRS}" "${LLVM_VERSION}")
    endif()
  endif()
endif()

set(libclang_wanted "install libclang-19-dev (${LibClang_LEAST} or later will do), or give -DLLVM_CONFIG=PROGRAM")
if(libclang_too_old)
  list(JOIN libclang_too_old ", " libclang_too_old)
  string(APPEND libclang_wanted
    " (too old: ${libclang_too_old} - before ${LibClang_LEAST} libclang cannot say which operator an expression has)")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LibClang
  REQUIRED_VARS LibClang_LIBRARY LibClang_INCLUDE_DIR VERSION_VAR LibClang_VERSION
  REASON_FAILURE_MESSAGE "${libclang_wanted}")
if(LibClang_FOUND AND NOT TARGET LibClang::LibClang)
  add_library(LibClang::LibClang UNKNOWN IMPORTED)
  set_target_properties(LibClang::LibClang PROPERTIES IMPORTED_LOCATION ${LibClang_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${LibClang_INCLUDE_DIR})
endif()
