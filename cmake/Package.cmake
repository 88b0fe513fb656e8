# SPDX-License-Identifier: GPL-3.0-or-later
# Two Debian packages by cpack: shortfall, the command, and libshortfall-dev, the libraries.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME shortfall)
set(CPACK_PACKAGE_CONTACT "the shortfall authors <shortfall@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact error of time integrators, derived, proved and corrected")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME shortfall)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION math)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "gnuplot-nox, jupyter-notebook")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
"For any integrator (explicit, symplectic, Runge-Kutta, splittings, a game
engine's own loop, one that was just written down) shortfall derives the
exact discrete motion, its shortfall against the true motion, and what to
add to launch, read-out, force or step so that it vanishes, with proofs.
It separates rounding from method, measures speed against accuracy, finds
which integrator made a log, and writes code, pages and notebooks.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libshortfall-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libgmp-dev, libmpfr-dev, libflint-dev, libboost-dev, libfmt-dev, nlohmann-json3-dev, libtomlplusplus-dev, libgsl-dev, libtbb-dev, libsqlite3-dev")
if(ARB_LIBRARY)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libflint-arb-dev")
endif()
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"What is needed to derive shortfalls and corrections from C++: the headers,
the static libraries, and the descriptions for CMake and pkg-config of
shortfall.")

# Debian's own texts, in both packages, compressed without a time.
set(folder "${PROJECT_BINARY_DIR}/debian")
configure_file("${PROJECT_SOURCE_DIR}/packaging/changelog.in" "${folder}/changelog.Debian" @ONLY)
configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${folder}/changelog" COPYONLY)
add_custom_command(
  OUTPUT "${folder}/changelog.Debian.gz" "${folder}/changelog.gz"
  COMMAND "${GZIP_PROGRAM}" -9nkf "${folder}/changelog.Debian" "${folder}/changelog"
  DEPENDS "${folder}/changelog.Debian" "${folder}/changelog" VERBATIM)
add_custom_target(changelogs ALL DEPENDS "${folder}/changelog.Debian.gz")
foreach(package runtime=shortfall development=libshortfall-dev)
  string(REPLACE "=" ";" package "${package}")
  list(GET package 0 component)
  list(GET package 1 name)
  install(FILES "${folder}/changelog.Debian.gz" "${folder}/changelog.gz" "${PROJECT_SOURCE_DIR}/packaging/copyright"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${name}" COMPONENT ${component})
  # It wants the number of a bug report that asked Debian for the package; there is none.
  file(CONFIGURE OUTPUT "${folder}/${name}" CONTENT "${name}: initial-upload-closes-no-bugs\n")
  install(FILES "${folder}/${name}" DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides" COMPONENT ${component})
endforeach()
include(CPack)
