# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(shortfall) for other projects: libraries, headers below include/shortfall/, package description.
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/shortfall")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/analysis" "${PROJECT_SOURCE_DIR}/notebooks-export"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/shortfall" ${shortfall_readable} COMPONENT development
        FILES_MATCHING PATTERN "*.hpp"
        PATTERN "analysis/shortfall.hpp" EXCLUDE)
install(FILES "${PROJECT_SOURCE_DIR}/analysis/shortfall.hpp"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/shortfall" COMPONENT development)
file(GLOB schemas CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/share/*.schema.json")
install(FILES ${schemas} DESTINATION "${CMAKE_INSTALL_DATADIR}/shortfall" COMPONENT runtime)
file(GLOB schemas CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/share/output/*.schema.json")
install(FILES ${schemas} DESTINATION "${CMAKE_INSTALL_DATADIR}/shortfall/output" COMPONENT runtime)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/scenes" DESTINATION "${CMAKE_INSTALL_DATADIR}/shortfall" ${shortfall_readable} COMPONENT runtime)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/shortfall" ${shortfall_readable} COMPONENT runtime)
install(EXPORT shortfallTargets NAMESPACE shortfall:: DESTINATION "${package}" COMPONENT development)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/shortfallConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/shortfallConfig.cmake" INSTALL_DESTINATION "${package}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/shortfallConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/shortfallConfig.cmake"
              "${PROJECT_BINARY_DIR}/shortfallConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindGMP.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindMPFR.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindFLINT.cmake"
        DESTINATION "${package}" COMPONENT development)

# pkg-config: the modules from the top down, then what they stand on.
get_property(modules GLOBAL PROPERTY SHORTFALL_MODULES)
list(REVERSE modules)
list(TRANSFORM modules PREPEND "-lshortfall_")
set(libraries ${modules} -lfmt -lgsl -lgslcblas -ltbb -lsqlite3 -ltomlplusplus)
if(ARB_LIBRARY)
  list(APPEND libraries -lflint-arb)
endif()
list(APPEND libraries -lflint -lmpfr -lgmpxx -lgmp -lquadmath)
list(JOIN libraries " " libraries)
file(RELATIVE_PATH to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file("${PROJECT_SOURCE_DIR}/packaging/shortfall.pc.in" "${PROJECT_BINARY_DIR}/shortfall.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/shortfall.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
