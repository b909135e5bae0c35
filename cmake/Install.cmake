# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What `cmake --install` puts below the prefix besides what the rooms install themselves (programs,
# runtime): the CMake package, the pkg-config file, manual pages, completions. Every file finds the
# others from its own place, so that the tree can be moved.
include(CMakePackageConfigHelpers)

set(redcc_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/redcc)
set(redcc_pkgconfig_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/redcc-config.cmake.in ${PROJECT_BINARY_DIR}/cmake/redcc-config.cmake
  INSTALL_DESTINATION ${redcc_cmake_folder}
  PATH_VARS CMAKE_INSTALL_BINDIR CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/redcc-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/redcc-config.cmake
              ${PROJECT_BINARY_DIR}/cmake/redcc-config-version.cmake
        DESTINATION ${redcc_cmake_folder})

# The prefix, seen from the folder of redcc.pc.
file(RELATIVE_PATH redcc_prefix_from_pkgconfig /prefix/${redcc_pkgconfig_folder} /prefix)
string(REGEX REPLACE "/$" "" redcc_prefix_from_pkgconfig "${redcc_prefix_from_pkgconfig}")
foreach(package redcc redcc-runtime)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${package}.pc.in
                 ${PROJECT_BINARY_DIR}/cmake/${package}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cmake/${package}.pc DESTINATION ${redcc_pkgconfig_folder})
endforeach()

set(redcc_pages redcc redcc-cc)
if(REDCC_EXAMPLES)
  list(APPEND redcc_pages fabric)
endif()
foreach(page ${redcc_pages})
  configure_file(${PROJECT_SOURCE_DIR}/docs/man/${page}.1 ${PROJECT_BINARY_DIR}/man/${page}.1 @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/man/${page}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/completions/${page}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endforeach()

install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
file(GLOB redcc_documents CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
if(NOT REDCC_EXAMPLES)
  list(FILTER redcc_documents EXCLUDE REGEX "/fabric-[^/]*$")
endif()
install(FILES ${redcc_documents} DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
