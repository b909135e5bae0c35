# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# build_behind_redcc(TARGET [OPTION...]): compiles the C sources of TARGET through this build's redcc-cc,
# with these options of redcc, and links the runtime. Without the translator (a partial checkout) TARGET stays as it is.
function(build_behind_redcc target)
  if(NOT (TARGET redcc-cc AND TARGET redcc AND TARGET redcc_rt_static))
    return()
  endif()
  # Neither a launcher nor OBJECT_DEPENDS can be a generator expression (CMake 3.25).
  foreach(program redcc redcc-cc)
    get_target_property(folder ${program} RUNTIME_OUTPUT_DIRECTORY)
    if(NOT folder)
      get_target_property(folder ${program} BINARY_DIR)
    endif()
    set(${program}_path ${folder}/${program}${CMAKE_EXECUTABLE_SUFFIX})
  endforeach()
  # A sanitizer build of the tools works as a compiler all the same, but has no reason to look for
  # its own leaks while it does.
  set(environment ASAN_OPTIONS=detect_leaks=0)
  if(ARGN)
    string(REPLACE ";" " " options "${ARGN}")
    list(APPEND environment "REDCC_OPTS=${options}")
  endif()
  set_target_properties(${target} PROPERTIES C_COMPILER_LAUNCHER
                        "${CMAKE_COMMAND};-E;env;${environment};${redcc-cc_path}")
  target_link_libraries(${target} PRIVATE redcc_rt_static)
  target_link_options(${target} PUBLIC LINKER:-u,redcc_run) # a weak name takes nothing out of an archive
  add_dependencies(${target} redcc redcc-cc redcc_rt_static)
  get_target_property(sources ${target} SOURCES)
  set_source_files_properties(${sources} PROPERTIES OBJECT_DEPENDS
                              "${redcc_path};${redcc-cc_path}")
endfunction()
