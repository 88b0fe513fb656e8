# SPDX-License-Identifier: GPL-3.0-or-later
# One test: the Debian packages are made, twice the same bytes; what is in them runs, is found by pkg-config, and lintian
# has nothing to say where it is installed.
find_program(DPKG_DEB dpkg-deb)
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
find_program(PKG_CONFIG pkg-config)
find_program(FILE_PROGRAM file)  # cpack asks it for shared libraries
mark_as_advanced(DPKG_DEB DPKG_SHLIBDEPS PKG_CONFIG FILE_PROGRAM)
if(FILE_PROGRAM AND DPKG_DEB AND DPKG_SHLIBDEPS AND PKG_CONFIG AND NOT SHORTFALL_SANITIZE)
  add_test(NAME package COMMAND sh "${PROJECT_SOURCE_DIR}/tests/package/run.sh" "${PROJECT_BINARY_DIR}"
           "${PROJECT_SOURCE_DIR}" "${CMAKE_CXX_COMPILER}")
  # The longest test begins first, or the others would be done before it.
  set_tests_properties(package PROPERTIES LABELS package COST 100)
endif()
